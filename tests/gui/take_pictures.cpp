// take_pictures SCENE FOLDER [every]: the pictures of docs/workbench.md, taken off the screen; and every page in two sizes and
// both themes.

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QSettings>
#include <QSlider>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <cstdio>

#include "gui/compare/compare_page.hpp"
#include "gui/couple/couple_page.hpp"
#include "gui/data/data_page.hpp"
#include "gui/geometry/geometry_page.hpp"
#include "gui/geometry/motion_bar.hpp"
#include "gui/loading_curve/loading_curve_page.hpp"
#include "gui/look/choice_button.hpp"
#include "gui/look/language.hpp"
#include "gui/look/theme.hpp"
#include "gui/main_window.hpp"
#include "gui/modal/modal_page.hpp"
#include "gui/page/plot_menu.hpp"
#include "gui/page/scene_page.hpp"
#include "gui/plan/plan_page.hpp"
#include "gui/plot/chart.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/project.hpp"
#include "gui/records/records_page.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/study/study_page.hpp"
#include "gui/table/cell_table.hpp"
#include "ident/identify.hpp"

namespace jointid::gui {
namespace {

bool wait_for(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, 60000); }

/// The tab that has a widget in it.
void show_tab_of(QTabWidget& tabs, const QWidget& inside) {
  for (int tab = 0; tab < tabs.count(); ++tab) {
    if (tabs.widget(tab)->isAncestorOf(&inside)) tabs.setCurrentIndex(tab);
  }
}

class Photographer {
 public:
  Photographer(const QString& scene, const QString& folder, bool every) : folder_(folder), every_(every) {
    window_.resize(1280, 800);
    window_.show();
    scene_ = scene;
  }

  void take() {
    take_proposal();
    window_.open({scene_});
    take_scene();
    if (every_) take_every_page();
  }

 private:
  /// Of the FRF files beside the scene.
  void take_proposal() {
    QStringList files;
    const QDir beside = QFileInfo(scene_).absoluteDir();
    for (const QString& name : beside.entryList({"*.uff"}, QDir::Files, QDir::Name)) files << beside.filePath(name);
    window_.open(files);
    wait_for([&] { return window_.current() != nullptr; });
    Project& project = *window_.current();
    wait_for([&] { return !project.data_page()->is_busy() && !project.data_page()->plot()->curves().empty(); });
    keep("workbench-new");
    project.editor()->document()->setModified(false);
    QTest::keyClick(&window_, Qt::Key_W, Qt::ControlModifier);
  }

  void take_scene() {
    Project& project = *window_.current();
    DataPage& data = *project.data_page();
    wait_for([&] { return !data.is_busy() && data.files().size() > 0; });
    project.switch_view(true);
    keep("workbench-form");
    project.switch_view(false);
    data.choose_file(2);
    wait_for([&] { return !data.is_busy(); });
    data.choose_frfs({{0, 0}, {1, 0}});
    wait_for([&] { return data.plot()->curves().size() == 2; });
    data.plot()->set_cursor(420.0);
    keep("workbench-data");
    GeometryPage& geometry = *project.geometry_page();
    project.pages()->setCurrentWidget(&geometry);
    wait_for([&] { return !geometry.is_busy() && geometry.dofs()->count() > 0; });
    geometry.dofs()->setCurrentRow(3);
    geometry.set_frequency(420.0);
    geometry.findChild<QToolButton*>("play")->click();
    wait_for([&] { return !geometry.is_busy(); });
    keep("workbench-geometry");
    geometry.findChild<QToolButton*>("play")->click();
    project.pages()->setCurrentWidget(&data);
    data.findChild<QTableView*>("grid")->selectAll();
    data.plot()->set_view(View::cmif);
    wait_for([&] { return !data.is_busy(); });
    keep("workbench-cmif");
    data.plot()->set_view(View::magnitude_phase);
    take_modes(project);
    take_curves(project);
    SolvePage& solve = *project.solve_page();
    project.pages()->setCurrentWidget(&solve);
    solve.solve();
    wait_for([&] { return !solve.runs().empty() && !solve.is_busy(); });
    keep("workbench-unknowns");
    take_compared(project);
    take_planned(project);
    project.pages()->setCurrentWidget(&solve);
    solve.results()->setCurrentWidget(solve.runs_table());
    keep("workbench-runs");
    show_tab_of(*solve.results(), *solve.plot());
    wait_for([&] { return !solve.is_busy() && !solve.plot()->curves().empty(); });
    solve.plot()->set_cursor(420.0);
    window_.set_theme(Theme::dark);
    QTest::qWait(4000);  // plots of all pages are drawn anew, one after the other
    keep("workbench-frfs-dark");
    window_.set_theme(Theme::light);
    project.pages()->setCurrentIndex(0);
    QString text = project.editor()->toPlainText();
    project.editor()->replace_text(text.replace("pattern = \"symmetric\"", "patern = \"symmetric\"").toStdString());
    keep("workbench-error");
    project.editor()->undo();
    wait_for([&] { return !project.editor()->error(); });
  }

  void take_planned(Project& project) {
    PlanPage& plan = *project.plan_page();
    project.pages()->setCurrentWidget(&plan);
    const auto coordinates = ident::make_plan(*project.checked().scene)->coordinates;
    QStringList candidates;
    for (const frf::Dof& dof : coordinates.responses) candidates << QString::fromStdString(dof.name());
    plan.candidates()->setText(candidates.mid(1).join(QStringLiteral(", ")));
    plan.predict();
    wait_for([&] { return !plan.is_busy(); });
    keep("workbench-plan");
  }

  /// Of the assembly, of which one mode is then shown to move.
  void take_modes(Project& project) {
    ModalPage& modal = *project.modal_page();
    project.pages()->setCurrentWidget(&modal);
    QComboBox& structure = *modal.findChild<QComboBox*>("modal_structure");
    structure.setCurrentIndex(structure.count() - 1);
    modal.findChild<QDoubleSpinBox*>("modal_high")->setValue(1000.0);
    modal.run();
    wait_for([&] { return !modal.is_busy() && modal.shown() != nullptr; });
    modal.plot()->set_cursor(420.0);
    keep("workbench-modes");
    modal.results()->setCurrentWidget(modal.mac());
    keep("workbench-mac");
    GeometryPage& geometry = *project.geometry_page();
    project.pages()->setCurrentWidget(&geometry);
    geometry.motion()->choose_mode(2);
    geometry.findChild<QToolButton*>("play")->click();
    geometry.findChild<QToolButton*>("hold")->click();
    geometry.findChild<QSlider*>("phase")->setValue(0);
    wait_for([&] { return !geometry.is_busy(); });
    keep("workbench-mode");
    geometry.findChild<QToolButton*>("play")->click();
  }

  /// A loading curve and a scene of coupling, in folders beside the scene.
  void take_curves(Project& project) {
    const QDir beside = QFileInfo(scene_).absoluteDir();
    LoadingCurvePage& curves = *project.loading_curve_page();
    project.pages()->setCurrentWidget(&curves);
    curves.open({beside.filePath("curve/table2.1-1.csv")});
    wait_for([&] { return !curves.is_busy(); });
    curves.run();
    wait_for([&] { return !curves.is_busy(); });
    keep("workbench-loading-curve");
    curves.plots()->menu()->setCurrentIndex(1);
    curves.tables()->setCurrentIndex(1);
    keep("workbench-equivalents");
    window_.open({beside.filePath("couple/coupling-C.toml")});
    CouplePage& couple = *window_.current()->couple_page();
    window_.current()->pages()->setCurrentWidget(&couple);
    couple.set_bounds(true);
    couple.run();
    wait_for([&] { return !couple.is_busy(); });
    const QString measured = beside.filePath("couple/coupling-C_assembly.h5");
    if (QFileInfo::exists(measured)) {
      couple.set_measured({measured});
      wait_for([&] { return !couple.is_busy(); });
    }
    keep("workbench-couple");
    QTest::keyClick(&window_, Qt::Key_W, Qt::ControlModifier);
    take_frictional(beside.filePath("response/beams-B.toml"), &Project::response_page, "workbench-response");
    take_frictional(beside.filePath("laws/sdof-iwan.toml"), &Project::laws_page, "workbench-laws");
    take_frictional(beside.filePath("chain/chain-3.toml"), &Project::oscillate_page, "workbench-oscillate");
    RecordsPage& records = *project.records_page();
    project.pages()->setCurrentWidget(&records);
    records.open({beside.filePath("chain/motion.csv")});
    wait_for([&] { return !records.is_busy(); });
    records.run();
    wait_for([&] { return !records.is_busy(); });
    keep("workbench-records");
  }

  /// A scene of joints with friction.
  void take_frictional(const QString& scene, ScenePage* (Project::*page_of)(), const char* name) {
    window_.open({scene});
    ScenePage& page = *(window_.current()->*page_of)();
    window_.current()->pages()->setCurrentWidget(&page);
    page.run();
    wait_for([&] { return !page.is_busy(); });
    keep(name);
    for (int choice = 1; every_ && choice < page.plots()->menu()->count(); ++choice) {
      page.plots()->menu()->setCurrentIndex(choice);
      keep(qPrintable(QStringLiteral("every-%1-%2").arg(QLatin1String(name)).arg(choice)));
    }
    window_.current()->switch_view(true);
    if (every_) keep(qPrintable(QStringLiteral("every-%1-form").arg(QLatin1String(name))));
    QTest::keyClick(&window_, Qt::Key_W, Qt::ControlModifier);
  }

  /// Needs simulated noise and a truth, which rig one has.
  void take_compared(Project& project) {
    ComparePage& compare = *project.compare_page();
    project.pages()->setCurrentWidget(&compare);
    compare.findChild<QSpinBox*>("compare_trials")->setValue(20);
    compare.findChild<ChoiceButton*>("compare_methods")->choose({"one", "two"});
    compare.findChild<ChoiceButton*>("compare_weightings")->choose({"none", "WA", "WB", "WBS"});
    compare.findChild<ChoiceButton*>("compare_deltas")->choose({"0", "0.1"});
    compare.run();
    wait_for([&] { return !compare.is_busy(); });
    if (!compare.chart()->scatter().groups.empty()) compare.chart()->choose(0, 0);
    compare.table()->selectRow(1);
    keep("workbench-compare");
    if (compare.comparison().combinations.empty()) return;
    Q_EMIT compare.way_opened(compare.comparison().combinations.back().way);
    wait_for([&] { return project.solve_page()->runs().size() > 1 && !project.solve_page()->is_busy(); });
    project.save();
    StudyPage& study = *project.study_page();
    project.pages()->setCurrentWidget(&study);
    study.set_trials(1000);
    study.run();
    wait_for([&] { return !study.is_busy(); });
    keep("workbench-study");
    project.editor()->undo();
    project.save();
  }

  /// Every page and result as it is now, in both themes and two sizes.
  void take_every_page() {
    Project& project = *window_.current();
    for (const QSize size : {QSize(1024, 768), QSize(1280, 800)}) {
      for (const Theme theme : {Theme::light, Theme::dark}) {
        window_.resize(size);
        window_.set_theme(theme);
        const QString look = QStringLiteral("-%1-%2").arg(size.width()).arg(theme == Theme::dark ? "dark" : "light");
        for (int page = 0; page < project.pages()->count(); ++page) {
          project.pages()->setCurrentIndex(page);
          keep(qPrintable("every-" + project.pages()->tabText(page) + look));
        }
        project.switch_view(true);
        keep(qPrintable("every-form" + look));
        project.switch_view(false);
        project.pages()->setCurrentWidget(project.solve_page());
        QTabWidget& results = *project.solve_page()->results();
        for (int result = 0; result < results.count(); ++result) {
          if (!results.isTabVisible(result)) continue;
          results.setCurrentIndex(result);
          keep(qPrintable("every-solve-" + results.tabText(result).section(' ', -1) + look));
        }
      }
    }
  }

  void keep(const char* name) {
    QTest::qWait(200);
    const QImage image = window_.grab().toImage();
    const QString file = QDir(folder_).filePath(QString::fromLocal8Bit(name) + ".png");
    image.convertToFormat(QImage::Format_RGB32).save(file, "PNG", 0);
    std::printf("%s\n", qPrintable(file));
  }

  QString folder_, scene_;
  bool every_;
  MainWindow window_;
};

}  // namespace
}  // namespace jointid::gui

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QApplication application(argc, argv);
  QApplication::setOrganizationName("jointid");
  QApplication::setApplicationName("pictures");
  jointid::gui::apply(jointid::gui::Theme::light, application);
  jointid::gui::use_language();  // that of LC_ALL
  if (argc < 3) return 2;
  jointid::gui::Photographer(QString::fromLocal8Bit(argv[1]), QString::fromLocal8Bit(argv[2]), argc > 3).take();
  return 0;
}
