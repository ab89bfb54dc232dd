#include "gui/study/study_page.hpp"

#include <gmock/gmock.h>

#include <QFileInfo>
#include <QPushButton>
#include <QTest>

#include "base/temporary_file.hpp"
#include "frf/hdf5/table_file.hpp"
#include "gui/look/paths.hpp"
#include "gui/plot/chart.hpp"
#include "gui/table/cell_table.hpp"
#include "ident/scene/read_scene.hpp"
#include "scene/text.hpp"
#include "study/study_statistics.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

struct Studying {
  Measured measured{"A1"};
  StudyPage page;

  Studying() {
    page.resize(900, 700);
    page.show();
    set_file(measured.scene());
    page.set_trials(60);
  }
  void set_file(const QString& file) {
    const auto path = as_path(measured.scene());
    page.set_scene(ident::read_scene(path), scene::read_text(path), file);
  }
  bool rests() {
    return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000);
  }
};

TEST(StudyPage, ShowsWhatTheResultFileSays) {
  Studying studying;
  find<QPushButton>(studying.page, "study")->click();
  ASSERT_TRUE(studying.rests());
  ASSERT_TRUE(QFileInfo::exists(studying.page.result_file())) << studying.page.status().toStdString();
  const auto statistics = study::study_statistics(as_path(studying.page.result_file()));
  EXPECT_EQ(statistics.trials, 60U);
  EXPECT_EQ(studying.page.table()->cells()->rowCount(), static_cast<int>(statistics.unknowns.size()));
  EXPECT_THAT(studying.page.status().toStdString(), HasSubstr("60"));
  ASSERT_FALSE(studying.page.chart()->histograms().empty());
  double trials = 0.0;
  for (const double count : studying.page.chart()->histograms().front().counts) trials += count;
  EXPECT_GT(trials, 50.0);
  EXPECT_LE(trials, 60.0);
}

/// The same trials, whatever was cancelled before: the files have the same bytes.
TEST(StudyPage, WhatIsCancelledIsTakenUpByTheNextRun) {
  Studying once;
  once.page.set_trials(300);
  once.page.run();
  ASSERT_TRUE(once.rests());
  Studying twice;
  twice.page.set_trials(300);
  twice.page.run();
  (void)QTest::qWaitFor([&] { return !twice.page.chart()->histograms().empty() || !twice.page.is_busy(); }, 60000);
  twice.page.cancel();
  ASSERT_TRUE(twice.rests());
  if (!QFileInfo::exists(twice.page.result_file())) {
    EXPECT_THAT(twice.page.status().toStdString(), HasSubstr("ancelled"));
    twice.page.run();
    ASSERT_TRUE(twice.rests());
  }
  EXPECT_EQ(read_file(once.page.result_file()), read_file(twice.page.result_file()));
}

TEST(StudyPage, IsOfASceneThatIsSaved) {
  Studying studying;
  studying.set_file(QString());
  studying.page.run();
  EXPECT_FALSE(studying.page.is_busy());
  EXPECT_THAT(studying.page.status().toStdString(), HasSubstr("Save the scene first"));
}

TEST(StudyPage, CanBeDestroyedWhileItRuns) {
  for (const int wait : {0, 20, 100}) {
    Studying studying;
    studying.page.set_trials(100000);
    studying.page.run();
    QTest::qWait(wait);
  }
}

TEST(StudyPage, TheCommandWritesTheSameFile) {
  Studying studying;
  studying.set_file("/a b/c.toml");
  EXPECT_EQ(studying.page.command_line().toStdString(),
            "jointid study '/a b/c.toml' --trials 60 --seed 1 --out '/a b/c.study.h5'");
}

TEST(LiveTrials, AreCountedUntilTheirMemoryIsFull) {
  LiveTrials live({{"K", "N/m", restrictions::Kind::stiffness, 1.0}});
  EXPECT_TRUE(live.histograms().empty());
  for (int i = 0; i < 100; ++i) {
    const double row[] = {0.0, 1.0 + 0.01 * i};
    live.put(row);
  }
  const auto sets = live.histograms();
  ASSERT_EQ(sets.size(), 1U);
  double counted = 0.0;
  for (const double count : sets[0].plots[0].counts) counted += count;
  EXPECT_EQ(counted, 100.0);
  EXPECT_EQ(sets[0].plots[0].mark, 1.0);
}

}  // namespace
}  // namespace jointid::gui
