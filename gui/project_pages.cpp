#include <QProxyStyle>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>
#include <functional>
#include <type_traits>
#include <utility>

#include "gui/compare/compare_page.hpp"
#include "gui/couple/couple_page.hpp"
#include "gui/data/data_page.hpp"
#include "gui/geometry/geometry_page.hpp"
#include "gui/laws/law_kind.hpp"
#include "gui/lines/line_kind.hpp"
#include "gui/loading_curve/loading_curve_page.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/modal/modal_page.hpp"
#include "gui/oscillate/oscillate_kind.hpp"
#include "gui/plan/plan_page.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/project.hpp"
#include "gui/records/records_page.hpp"
#include "gui/response/response_kind.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/study/study_page.hpp"
#include "tasks/joint/joint_springs.hpp"

/// The pages of a project, and what they tell each other.
namespace jointid::gui {
namespace {

/// Tabs with a third of the space beside their titles, so that all pages have whole titles in a small window.
class CloseTabs : public QProxyStyle {
 public:
  CloseTabs() : QProxyStyle(QStringLiteral("fusion")) {}
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    const int space = QProxyStyle::pixelMetric(metric, option, widget);
    return metric == PM_TabBarTabHSpace ? space / 3 : space;
  }
};

}  // namespace

void Project::add_pages() {
  pages_ = named(new QTabWidget, "pages", tr("Pages"));
  data_page_ = named(new DataPage, "data_page", tr("Data"));
  pages_->addTab(data_page_, tr("Data"));
  geometry_page_ = named(new GeometryPage, "geometry_page", tr("Geometry"));
  pages_->addTab(geometry_page_, tr("Geometry"));
  solve_page_ = named(new SolvePage, "solve_page", tr("Solve"));
  pages_->addTab(solve_page_, tr("Solve"));
  add_pages_of_scene();
  add_other_pages();
  // A page that is asked for by its key or in the menu is seen, whatever the scene.
  connect(pages_, &QTabWidget::currentChanged, this, [this](int page) { pages_->setTabVisible(page, true); });
  pages_->setUsesScrollButtons(false);  // all are seen, if need be shortened
  pages_->setElideMode(Qt::ElideRight);
  auto* close = new CloseTabs;
  close->setParent(pages_->tabBar());
  pages_->tabBar()->setStyle(close);
  splitter_->addWidget(pages_);
  link_cursors();
  watch_commands(*solve_page_);
  connect(solve_page_, &SolvePage::failed, this, &Project::show_failure);
  connect(data_page_, &DataPage::edit_wanted, this, &Project::edit);
  connect(geometry_page_, &GeometryPage::edit_wanted, this, &Project::edit);
  connect(solve_page_, &SolvePage::run_shown, this, [this](std::size_t run) {
    const Solved& shown = solve_page_->runs()[run];
    if (shown.plan == nullptr) return geometry_page_->set_springs({});
    geometry_page_->set_springs(tasks::joint_springs(shown.plan->restriction, shown.solution));
  });
  connect(solve_page_, &SolvePage::text_wanted, this, [this](const std::string& text) {
    editor_->replace_text(text);
    check();
  });
  connect(data_page_, &DataPage::files_opened, this, &Project::offer_dofs);
}

/// No table of a page replaces an input, whenever the page is made.
template <class Page>
void Project::add_later(Later<Page>& later, const QString& title, const QString& hint,
                        std::type_identity_t<std::function<Page*()>> make,
                        std::type_identity_t<std::function<void(Page&)>> tell) {
  const auto make_protected = [this, make = std::move(make)] {
    Page* const page = make();
    protect_inputs(*page);
    if (page->objectName() != QLatin1String("records_page") && page->objectName() != QLatin1String("loading_curve_page"))
      watch_commands(*page);
    return page;
  };
  later.place(*pages_, title, hint, make_protected, std::move(tell));
}

/// A page for scenes of another kind checks these.
template <class Page>
void Project::tell_other_kind(Page& page, bool is_of_kind) {
  const auto wrong = page.set_scene(editor_->text(), path(), is_modified() ? QString() : file_);
  if (is_of_kind) checked_ = {{}, wrong, checked_.seen()};
}

/// What else is done with the scene of the solution.
void Project::add_pages_of_scene() {
  const auto compare = [this] {
    auto* page = named(new ComparePage, "compare_page", tr("Compare"));
    connect(page, &ComparePage::failed, this, &Project::show_failure);
    connect(page, &ComparePage::way_opened, this, &Project::open_way);
    return page;
  };
  add_later(compare_page_, tr("Compare"), tr("Compare"), compare, [this](ComparePage& page) {
    page.set_file(file_);
    page.set_scene(checked_.scene);
  });
  const auto study = [this] {
    auto* page = named(new StudyPage, "study_page", tr("Study"));
    connect(page, &StudyPage::failed, this, &Project::show_failure);
    return page;
  };
  add_later(study_page_, tr("Study"), tr("Study"), study,
            [this](StudyPage& page) { page.set_scene(checked_.scene, editor_->text(), is_modified() ? QString() : file_); });
  const auto modal = [this] {
    auto* page = named(new ModalPage, "modal_page", tr("Modes"));
    connect(page, &ModalPage::modes_changed, this,
            [this, page] { geometry_page_->set_modes(named_shapes(tasks::uff_modes(*page->shown()), q(page->shown()->files))); });
    return page;
  };
  add_later(modal_page_, tr("Modes"), tr("Modes"), modal, [this](ModalPage& page) { page.set_scene(checked_.seen()); });
}

void Project::add_other_pages() {
  const auto couple = [this] {
    auto* page = named(new CouplePage, "couple_page", tr("Coupling"));
    connect(page, &CouplePage::failed, this, &Project::show_failure);
    return page;
  };
  add_later(couple_page_, tr("Coupling"), tr("Coupling"), couple,
            [this](CouplePage& page) { tell_other_kind(page, is_couple_scene(editor_->text())); });
  const auto curves = [] { return named(new LoadingCurvePage, "loading_curve_page", tr("Loading curves")); };
  add_later(loading_curve_page_, tr("Curves"), tr("Loading curves"), curves, [](LoadingCurvePage&) {});
  const auto plan = [this] {
    auto* page = named(new PlanPage, "plan_page", tr("Test planning"));
    connect(page, &PlanPage::failed, this, &Project::show_failure);
    page->set_dofs(dofs_);
    return page;
  };
  add_later(plan_page_, tr("Planning"), tr("Test planning"), plan, [this](PlanPage& page) {
    page.set_file(file_);
    page.set_scene(checked_.scene);
  });
  const auto add_kind = [this](Later<ScenePage>& later, const char* name, const QString& title, SceneKind (*kind)()) {
    const auto make = [this, name, kind] {
      auto* page = named(new ScenePage(kind()), name, kind().title);
      connect(page, &ScenePage::failed, this, &Project::show_failure);
      return page;
    };
    add_later(later, title, kind().title, make, [this](ScenePage& page) { tell_other_kind(page, page.is_of(editor_->text())); });
  };
  add_kind(response_page_, "response_page", tr("Response"), response_kind);
  add_kind(laws_page_, "laws_page", tr("Laws"), law_kind);
  add_kind(oscillate_page_, "oscillate_page", tr("Stick-slip"), oscillate_kind);
  const auto records = [this] {
    auto* page = named(new RecordsPage, "records_page", tr("Time records"));
    connect(page, &RecordsPage::frfs_written, this, &Project::take_frfs);
    return page;
  };
  add_later(records_page_, tr("Records"), tr("Time records"), records, [](RecordsPage&) {});
  add_kind(lines_page_, "lines_page", tr("Z"), line_kind);
}

/// One cursor in all plots.
void Project::link_cursors() {
  FrfPlot* const data = data_page_->plot();
  FrfPlot* const solution = solve_page_->plot();
  connect(data, &FrfPlot::cursor_moved, solution, &FrfPlot::set_cursor);
  connect(solution, &FrfPlot::cursor_moved, data, &FrfPlot::set_cursor);
  for (FrfPlot* plot : {data, solution}) connect(plot, &FrfPlot::cursor_moved, geometry_page_, &GeometryPage::set_frequency);
}

}  // namespace jointid::gui
