#include <QSplitter>
#include <QTabWidget>

#include "gui/compare/compare_page.hpp"
#include "gui/couple/couple_page.hpp"
#include "gui/data/data_page.hpp"
#include "gui/geometry/geometry_page.hpp"
#include "gui/laws/law_kind.hpp"
#include "gui/loading_curve/loading_curve_page.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/modal/modal_page.hpp"
#include "gui/plan/plan_page.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/project.hpp"
#include "gui/response/response_kind.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/study/study_page.hpp"

/// The pages of a project, and what they tell each other.
namespace jointid::gui {

void Project::add_pages() {
  pages_ = named(new QTabWidget, "pages", tr("Pages"));
  data_page_ = named(new DataPage, "data_page", tr("Data"));
  pages_->addTab(data_page_, tr("Data"));
  geometry_page_ = named(new GeometryPage, "geometry_page", tr("Geometry"));
  pages_->addTab(geometry_page_, tr("Geometry"));
  solve_page_ = named(new SolvePage, "solve_page", tr("Solve"));
  pages_->addTab(solve_page_, tr("Solve"));
  compare_page_ = named(new ComparePage, "compare_page", tr("Compare"));
  pages_->addTab(compare_page_, tr("Compare"));
  study_page_ = named(new StudyPage, "study_page", tr("Study"));
  pages_->addTab(study_page_, tr("Study"));
  modal_page_ = named(new ModalPage, "modal_page", tr("Modes"));
  pages_->addTab(modal_page_, tr("Modes"));
  couple_page_ = named(new CouplePage, "couple_page", tr("Coupling"));
  pages_->addTab(couple_page_, tr("Coupling"));
  loading_curve_page_ = named(new LoadingCurvePage, "loading_curve_page", tr("Loading curves"));
  pages_->addTab(loading_curve_page_, tr("Loading curves"));
  plan_page_ = named(new PlanPage, "plan_page", tr("Before measuring"));
  pages_->addTab(plan_page_, tr("Before measuring"));
  response_page_ = named(new ScenePage(response_kind()), "response_page", tr("Response"));
  pages_->addTab(response_page_, tr("Response"));
  laws_page_ = named(new ScenePage(law_kind()), "laws_page", tr("Friction laws"));
  pages_->addTab(laws_page_, tr("Friction laws"));
  splitter_->addWidget(pages_);
  link_cursors();
  connect(solve_page_, &SolvePage::failed, this, &Project::show_failure);
  connect(compare_page_, &ComparePage::failed, this, &Project::show_failure);
  connect(study_page_, &StudyPage::failed, this, &Project::show_failure);
  connect(modal_page_, &ModalPage::modes_changed, this, [this] {
    geometry_page_->set_modes(named_shapes(report::uff_modes(*modal_page_->shown()), q(modal_page_->shown()->files)));
  });
  connect(couple_page_, &CouplePage::failed, this, &Project::show_failure);
  connect(plan_page_, &PlanPage::failed, this, &Project::show_failure);
  for (ScenePage* page : {response_page_, laws_page_}) connect(page, &ScenePage::failed, this, &Project::show_failure);
  connect(compare_page_, &ComparePage::way_opened, this, &Project::open_way);
  connect(data_page_, &DataPage::edit_wanted, this, &Project::edit);
  connect(geometry_page_, &GeometryPage::edit_wanted, this, &Project::edit);
  connect(data_page_, &DataPage::files_opened, this, &Project::offer_dofs);
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
