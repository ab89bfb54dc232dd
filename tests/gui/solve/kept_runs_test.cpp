#include "gui/solve/kept_runs.hpp"

#include <gmock/gmock.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <QTimer>

#include "../widgets.hpp"
#include "gui/page/plot_menu.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_edit.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/difference_tab.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/table/cell_table.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

/// A project of a scene, as after a start of the workbench.
struct Opened {
  Project project;

  explicit Opened(const QString& scene) {
    project.resize(1000, 700);
    project.show();
    project.open(scene);
    EXPECT_TRUE(rests());
  }
  SolvePage& page() { return *project.solve_page(); }
  bool rests() {
    return QTest::qWaitFor([&] { return !page().is_busy(); }, 60000);
  }
  void solve() {
    page().solve();
    ASSERT_TRUE(rests());
  }
};

QStringList files_in(const QString& folder) { return QDir(folder).entryList(QDir::Files, QDir::Name); }

TEST(KeptRuns, AreThereAgainAfterARestart) {
  const Measured measured("H4");
  std::string unknowns, matrix, json;
  {
    Opened first(measured.scene());
    first.solve();
    ASSERT_EQ(first.page().runs().size(), 1U);
    unknowns = first.page().unknowns()->text('\t').toStdString();
    matrix = first.page().matrix()->text('\t').toStdString();
    json = json_of(first.page().runs().front());
  }
  EXPECT_EQ(files_in(run_folder(measured.scene())).size(), 1);
  Opened again(measured.scene());
  SolvePage& page = again.page();
  ASSERT_EQ(page.runs().size(), 1U) << page.status().toStdString();
  EXPECT_EQ(page.unknowns()->text('\t').toStdString(), unknowns);
  EXPECT_EQ(page.matrix()->text('\t').toStdString(), matrix);
  EXPECT_EQ(json_of(page.runs().front()), json);
  EXPECT_EQ(page.runs().front().worth.size(), 4U);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !page.plot()->curves().empty(); }, 60000)) << page.status().toStdString();
  EXPECT_EQ(find<QComboBox>(page, "runs")->count(), 1);
  EXPECT_THAT(find<QComboBox>(page, "runs")->currentText().toStdString(), HasSubstr("1: newton"));
}

TEST(KeptRuns, AreComparedWithNewOnes) {
  const Measured measured("A1");
  { Opened(measured.scene()).solve(); }
  Opened again(measured.scene());
  again.project.editor()->replace_text(with_value(again.project.editor()->text(), "identify", "weighting", "\"WB\""));
  QTest::qWait(400);
  ASSERT_TRUE(again.rests());
  again.solve();
  SolvePage& page = again.page();
  ASSERT_EQ(page.runs().size(), 2U) << page.status().toStdString();
  EXPECT_EQ(page.runs_table()->cells()->columnCount(), 2);
  EXPECT_EQ(page.differences()->others()->count(), 1);
  page.choose_run(0);
  ASSERT_TRUE(again.rests());
  EXPECT_THAT(page.status().toStdString(), HasSubstr("The scene was another then"));
  find<QAction>(page, "scene_of_run")->trigger();
  EXPECT_THAT(again.project.editor()->text(), testing::Not(HasSubstr("\"WB\"")));
  EXPECT_EQ(files_in(run_folder(measured.scene())).size(), 2);
}

TEST(KeptRuns, OfANewSceneAreKeptWhenItIsSaved) {
  const Measured measured("A1");
  QTemporaryDir folder;
  Project project;
  project.start(read_file(measured.scene()), QFileInfo(measured.scene()).absolutePath());
  SolvePage& page = *project.solve_page();
  const auto rests = [&] { return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000); };
  ASSERT_TRUE(rests());
  page.solve();
  ASSERT_TRUE(rests());
  ASSERT_EQ(page.runs().size(), 1U);
  EXPECT_GT(project.seconds_of_runs(), 0.0);
  const QString file = QFileInfo(measured.scene()).absolutePath() + "/saved.toml";
  ASSERT_TRUE(project.save_as(file));
  ASSERT_TRUE(rests());
  EXPECT_EQ(files_in(run_folder(file)).size(), 1);
  EXPECT_EQ(project.seconds_of_runs(), 0.0);
}

TEST(KeptRuns, ARunIsRemovedWithItsFile) {
  const Measured measured("A1");
  Opened opened(measured.scene());
  opened.solve();
  QTimer::singleShot(100, [] {
    auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    box->button(QMessageBox::Yes)->click();
  });
  find<QAction>(opened.page(), "remove_run")->trigger();
  EXPECT_TRUE(opened.page().runs().empty());
  EXPECT_EQ(opened.page().unknowns()->cells()->rowCount(), 0);
  EXPECT_TRUE(files_in(run_folder(measured.scene())).isEmpty());
  opened.solve();
  EXPECT_EQ(opened.page().runs().size(), 1U);
}

TEST(KeptRuns, WhatCannotBeKeptOrReadIsSaid) {
  const Measured measured("A1");
  write_file(run_folder(measured.scene()), "a file in place of the folder");
  {
    Opened opened(measured.scene());
    opened.solve();
    EXPECT_EQ(opened.page().runs().size(), 1U);
    EXPECT_THAT(opened.page().status().toStdString(), HasSubstr("The run is not kept"));
    EXPECT_GT(opened.project.seconds_of_runs(), 0.0);
  }
  QFile::remove(run_folder(measured.scene()));
  QDir().mkpath(run_folder(measured.scene()));
  write_file(run_folder(measured.scene()) + "/2026-01-01T00-00-00.json", "{}");
  Opened again(measured.scene());
  EXPECT_TRUE(again.page().runs().empty());
  EXPECT_THAT(again.page().status().toStdString(), HasSubstr("2026-01-01T00-00-00.json"));
}

TEST(KeptRuns, AFileThatChangedSinceIsNamed) {
  const Measured measured("A1");
  { Opened(measured.scene()).solve(); }
  const QString data = measured.files().front();
  QFile file(data);
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  file.setFileTime(QDateTime::currentDateTime().addDays(-3), QFileDevice::FileModificationTime);
  file.close();
  Opened again(measured.scene());
  EXPECT_THAT(again.page().status().toStdString(),
              HasSubstr("changed since this run: " + QFileInfo(data).fileName().toStdString()));
}

TEST(KeptRuns, StayReadableWithoutTheirData) {
  const Measured measured("A1");
  { Opened(measured.scene()).solve(); }
  for (const QString& data : measured.files()) QFile::remove(data);
  Opened again(measured.scene());
  ASSERT_EQ(again.page().runs().size(), 1U);
  EXPECT_GT(again.page().unknowns()->cells()->rowCount(), 0);
  EXPECT_TRUE(again.page().plot()->curves().empty());
  EXPECT_THAT(again.page().status().toStdString(), HasSubstr("FRFs of this run are not drawn"));
}

TEST(KeptRuns, TheLayoutIsKeptBesideThem) {
  const Measured measured("A1");
  {
    Opened opened(measured.scene());
    opened.solve();
    opened.solve();
    opened.page().choose_run(0);
    ASSERT_TRUE(opened.rests());
    opened.project.pages()->setCurrentWidget(opened.project.solve_page());
    opened.page().results()->setCurrentWidget(opened.page().findings());
    opened.project.keep_layout();
  }
  Opened again(measured.scene());
  EXPECT_EQ(again.project.pages()->currentWidget(), again.project.solve_page());
  EXPECT_EQ(again.page().results()->currentWidget(), again.page().findings());
  EXPECT_EQ(again.page().run_in_front(), 0U);
  EXPECT_EQ(again.page().runs().size(), 2U);
}

TEST(SolvePage, ObjectiveAndUnknownsOverTheIterationsAreDrawn) {
  const Measured iterated("H4"), linear("A1");
  Opened opened(iterated.scene());
  opened.solve();
  SolvePage& page = opened.page();
  EXPECT_TRUE(page.results()->isTabVisible(page.results()->indexOf(page.iterations())));
  EXPECT_GT(page.iterations()->menu()->count(), 0);
  EXPECT_THAT(report_of(page.runs().front(), {}), HasSubstr("Over the iterations"));
  Opened other(linear.scene());
  other.solve();
  EXPECT_THAT(report_of(other.page().runs().front(), {}), testing::Not(HasSubstr("Over the iterations")));
  EXPECT_FALSE(other.page().results()->isTabVisible(other.page().results()->indexOf(other.page().iterations())));
}

}  // namespace
}  // namespace jointid::gui
