#include <gmock/gmock.h>

#include <QApplication>
#include <QComboBox>
#include <QListWidget>
#include <QTabWidget>
#include <QTest>
#include <QTextDocument>
#include <cmath>

#include "frf/uff/uff_lines.hpp"
#include "gui/data/data_page.hpp"
#include "gui/geometry/geometry_page.hpp"
#include "gui/geometry/motion_bar.hpp"
#include "gui/geometry/structure_view.hpp"
#include "gui/loading_curve/loading_curve_page.hpp"
#include "gui/look/message_bar.hpp"
#include "gui/look/paths.hpp"
#include "gui/main_window.hpp"
#include "gui/modal/modal_page.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/project.hpp"
#include "gui/records/records_page.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/table/cell_table.hpp"
#include "../widgets.hpp"

/// What a new user does first: files of an analyser, one file, files that are no FRFs.
namespace jointid::gui {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct FirstSteps {
  QTemporaryDir folder;
  MainWindow window;

  FirstSteps() {
    window.resize(1100, 750);
    window.show();
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
  }
  ~FirstSteps() {
    for (Project* project : window.findChildren<Project*>()) project->editor()->document()->setModified(false);
  }
  Project* open(const QStringList& files) {
    const int before = window.count();
    window.open(files);
    return wait([&] { return window.count() > before; }) ? window.current() : nullptr;
  }
  QString write(const char* name, const std::string& text) {
    write_file(folder.filePath(name), text);
    return folder.filePath(name);
  }
  static bool wait(const std::function<bool()>& came) { return QTest::qWaitFor(came, 30000); }
};

bool is_read(Project& project) {
  return FirstSteps::wait([&] { return !project.data_page()->files().empty() && !project.data_page()->is_busy(); });
}

TEST(FirstSteps, FilesWithoutPositionsAreSeenWithoutAJoint) {
  FirstSteps steps;
  const Measured rig("A1", "uff");
  Project* const project = steps.open(without_positions(rig.files(), steps.folder));
  ASSERT_NE(project, nullptr);
  EXPECT_FALSE(project->checked().scene);
  EXPECT_THAT(project->editor()->text(), HasSubstr("dofs = []"));
  ASSERT_TRUE(is_read(*project));
  EXPECT_EQ(project->data_page()->files().size(), 3U);
  EXPECT_FALSE(project->data_page()->plot()->curves().empty());
  project->pages()->setCurrentWidget(project->geometry_page());
  EXPECT_TRUE(steps.wait([&] { return project->geometry_page()->dofs()->count() == 14; }));
  project->pages()->setCurrentWidget(project->modal_page());
  EXPECT_EQ(find<QComboBox>(*project->modal_page(), "modal_structure")->count(), 3);
}

TEST(FirstSteps, PagesStayWhateverElseIsWrong) {
  FirstSteps steps;
  const Measured rig("A1");
  steps.window.open({rig.scene()});
  Project& project = *steps.window.current();
  ASSERT_TRUE(is_read(project));
  project.editor()->replace_text(project.editor()->text() + "\n[nonsense]\n");
  ASSERT_TRUE(steps.wait([&] { return project.checked().error.has_value(); }));
  ASSERT_TRUE(project.checked().seen());
  EXPECT_EQ(project.checked().seen()->joints.size(), 1U);
  EXPECT_EQ(project.data_page()->files().size(), 3U);
}

TEST(FirstSteps, OneFileIsShownToItsModes) {
  FirstSteps steps;
  const Measured rig("A1");
  Project* const project = steps.open({rig.file("A1_assembly.h5")});
  ASSERT_NE(project, nullptr);
  EXPECT_EQ(project->pages()->currentWidget(), project->data_page());
  EXPECT_THAT(project->messages()->text().toStdString(), HasSubstr("show the file."));
  ASSERT_TRUE(is_read(*project));
  EXPECT_EQ(project->data_page()->plot()->curves().size(), 1U);
  ModalPage* const modal = project->modal_page();
  project->pages()->setCurrentWidget(modal);
  modal->run();
  EXPECT_TRUE(steps.wait([&] { return modal->shown() != nullptr && !modal->is_busy(); })) << modal->status().toStdString();
  project->pages()->setCurrentWidget(project->geometry_page());
  EXPECT_TRUE(steps.wait([&] { return find<QComboBox>(*project->geometry_page(), "force_at")->count() >= 14; }));
}

TEST(FirstSteps, FilesThatAreNoJointAreShownAndItIsSaidWhy) {
  FirstSteps steps;
  const Measured rig("A1");
  Project* const project = steps.open({rig.file("A1_substructure_1.h5"), rig.file("A1_substructure_2.h5")});
  ASSERT_NE(project, nullptr);
  EXPECT_THAT(project->messages()->text().toStdString(), HasSubstr("No joint is proposed"));
  EXPECT_THAT(project->editor()->text(), StartsWith("# No joint is proposed"));
  ASSERT_TRUE(is_read(*project));
  EXPECT_EQ(project->data_page()->files().size(), 2U);
}

TEST(FirstSteps, AFileOfNodesIsAGeometry) {
  FirstSteps steps;
  const Measured rig("bolts", "uff");
  Project* const project = steps.open({steps.write("nodes.unv", only_positions(rig.file("bolts_assembly.uff")))});
  ASSERT_NE(project, nullptr);
  EXPECT_EQ(project->pages()->currentWidget(), project->geometry_page());
  EXPECT_TRUE(steps.wait([&] { return project->geometry_page()->view()->structure().nodes.size() == 20; }));
}

TEST(FirstSteps, RecordsAndCurvesGoToTheirPages) {
  FirstSteps steps;
  std::string record = "time [s],left [m]\n", curve = "displacement [mm],force [N]\n";
  for (int i = 0; i < 50; ++i) {
    record += std::to_string(0.01 * i) + "," + std::to_string(std::sin(0.3 * i)) + "\n";
    curve += std::to_string(0.001 * i) + "," + std::to_string(100.0 * std::sqrt(i)) + "\n";
  }
  Project* const project = steps.open({steps.write("motion.csv", record)});
  ASSERT_NE(project, nullptr);
  EXPECT_EQ(project->pages()->currentWidget(), project->records_page());
  EXPECT_THAT(project->records_page()->command_line().toStdString(), HasSubstr("motion.csv"));
  EXPECT_FALSE(project->is_modified());
  steps.window.open({steps.write("softening.csv", curve)});
  EXPECT_TRUE(steps.wait([&] { return project->pages()->currentWidget() == project->loading_curve_page(); }));
  EXPECT_THAT(project->loading_curve_page()->command_line().toStdString(), HasSubstr("softening.csv"));
  EXPECT_EQ(steps.window.count(), 1);
}

TEST(FirstSteps, WhatIsNoDataBesideDataIsSaid) {
  FirstSteps steps;
  const Measured rig("A1");
  ASSERT_NE(steps.open({rig.file("A1_assembly.h5"), steps.write("letter.txt", "Dear Sir")}), nullptr);
  EXPECT_THAT(steps.window.messages()->text().toStdString(), HasSubstr("letter.txt"));
}

TEST(FirstSteps, PagesThatNeedNoSceneOpenWithoutOne) {
  FirstSteps steps;
  QTest::keyClick(&steps.window, Qt::Key_4, Qt::AltModifier);
  EXPECT_EQ(steps.window.count(), 0);
  QTest::keyClick(&steps.window, Qt::Key_4, Qt::ControlModifier);
  ASSERT_EQ(steps.window.count(), 1);
  Project& project = *steps.window.current();
  EXPECT_EQ(project.pages()->currentWidget(), project.records_page());
  QTest::keyClick(&steps.window, Qt::Key_9, Qt::AltModifier);
  EXPECT_EQ(project.pages()->currentWidget(), project.loading_curve_page());
}

/// A drop of plain files of bolts, the pairs chosen by keys, solved by F5.
TEST(FirstSteps, FromFilesWithoutPositionsToSpringsPerBoltByKeys) {
  FirstSteps steps;
  const Measured rig("bolts", "uff");
  Project* const project = steps.open(without_positions(rig.files(), steps.folder));
  ASSERT_NE(project, nullptr);
  ASSERT_TRUE(is_read(*project));
  QTest::keyClick(&steps.window, Qt::Key_J, Qt::ControlModifier);
  auto* const assistant = project->findChild<QWidget*>("joint_assistant");
  ASSERT_NE(assistant, nullptr);
  auto *const first = find<QComboBox>(*assistant, "joint_first"), *const second = find<QComboBox>(*assistant, "joint_second");
  for (const auto& [below, above] : {std::pair("118", "201"), std::pair("120", "203"), std::pair("128", "211"), std::pair("130", "213")}) {
    QTest::keyClicks(first, below);
    QTest::keyClicks(second, above);
    QTest::keyClick(find(*assistant, "joint_add"), Qt::Key_Space);
    QTest::qWait(QApplication::keyboardInputInterval() + 50);  // letters within that time are one word
  }
  QTest::keyClick(assistant, Qt::Key_Return);
  ASSERT_TRUE(project->checked().scene) << project->editor()->text();
  steps.window.activateWindow();  // what a window manager does when a dialog closes
  ASSERT_TRUE(QTest::qWaitForWindowActive(&steps.window));
  QTest::keyClick(&steps.window, Qt::Key_F5);
  ASSERT_TRUE(steps.wait([&] { return !project->solve_page()->runs().empty(); })) << project->solve_page()->status().toStdString();
  const ident::Solution& solution = project->solve_page()->runs().front().solution;
  ASSERT_EQ(solution.unknowns.size(), 24U);
  const double truth[] = {1.0e8, 1.1e8, 2.0e8};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(solution.unknowns[i].value, truth[i], 0.05 * truth[i]) << solution.unknowns[i].name;
}

}  // namespace
}  // namespace jointid::gui
