#include "gui/couple/couple_page.hpp"

#include <gmock/gmock.h>

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QProcess>
#include <QPushButton>
#include <QTest>
#include <cmath>

#include "frf/file/file_format.hpp"
#include "gui/look/paths.hpp"
#include "gui/main_window.hpp"
#include "gui/page/plot_menu.hpp"
#include "gui/plot/chart.hpp"
#include "gui/project.hpp"
#include "scene/text.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

struct Coupling {
  Measured measured{"coupling-C"};
  CouplePage page;

  Coupling() {
    page.resize(900, 700);
    page.show();
    EXPECT_FALSE(set(scene::read_text(as_path(measured.scene()))));
  }
  std::optional<SceneError> set(const std::string& text) {
    return page.set_scene(text, as_path(measured.scene()), measured.scene());
  }
  bool rests() {
    return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000);
  }
};

TEST(CouplePage, WritesTheFileOfTheCommand) {
  Coupling coupling;
  coupling.page.set_bounds(true);
  find<QPushButton>(coupling.page, "couple")->click();
  ASSERT_TRUE(coupling.rests());
  ASSERT_NE(coupling.page.shown(), nullptr) << coupling.page.status().toStdString();
  ASSERT_TRUE(QFileInfo::exists(coupling.page.result_file()));
  const QString other = coupling.measured.file("by-command.h5");
  QProcess process;
  const QString line = coupling.page.command_line().replace(shell_word(coupling.page.result_file()), shell_word(other));
  process.start("/bin/sh", {"-c", shell_word(JOINTID_COMMAND) + line.mid(7)});
  ASSERT_TRUE(process.waitForFinished(60000));
  ASSERT_EQ(process.exitCode(), 0) << line.toStdString();
  const frf::FrfSet mine = frf::load(*frf::open(as_path(coupling.page.result_file()))),
                    theirs = frf::load(*frf::open(as_path(other)));
  EXPECT_EQ(mine.values, theirs.values);
  EXPECT_EQ(mine.header.response.size(), theirs.header.response.size());
  EXPECT_GT(coupling.page.conditions()->cells()->rowCount(), 1);
  EXPECT_GT(coupling.page.resonances()->cells()->rowCount(), 1);
}

/// What was written, taken for what was measured: no error, drawn behind the prediction.
TEST(CouplePage, WhatWasMeasuredStandsBehindThePrediction) {
  Coupling coupling;
  coupling.page.run();
  ASSERT_TRUE(coupling.rests());
  EXPECT_EQ(coupling.page.errors()->cells()->rowCount(), 0);
  const auto without = coupling.page.plots()->chart()->curve_plots().at(0).series.size();
  const QString copy = coupling.measured.file("measured.h5");
  ASSERT_TRUE(QFile::copy(coupling.page.result_file(), copy));
  coupling.page.set_measured({copy});
  ASSERT_TRUE(coupling.rests());
  EXPECT_EQ(coupling.page.plots()->chart()->curve_plots().at(0).series.size(), without + 1);
  ASSERT_GT(coupling.page.errors()->cells()->rowCount(), 3);
  EXPECT_EQ(coupling.page.errors()->cells()->index(0, 1).data().toString(), "0.00");
}

TEST(CouplePage, SaysWhatIsWrongWithTheScene) {
  Coupling coupling;
  const auto wrong = coupling.set("[data]\nparts = [\"a.h5\"]\n[couple]\njion = []\n");
  ASSERT_TRUE(wrong);
  EXPECT_THAT(wrong->remedy + wrong->problem, HasSubstr("join"));
  EXPECT_FALSE(find<QPushButton>(coupling.page, "couple")->isEnabled());
  EXPECT_FALSE(coupling.set(small_scene));
  EXPECT_FALSE(find<QPushButton>(coupling.page, "couple")->isEnabled());
  EXPECT_FALSE(is_couple_scene("# [couple]\n"));
}

TEST(CouplePage, CanBeCancelledAndDestroyedAtAnyMoment) {
  for (const int wait : {0, 10, 40}) {
    Coupling coupling;
    coupling.page.run();
    QTest::qWait(wait);
    coupling.page.cancel();
    ASSERT_TRUE(coupling.rests());
    coupling.page.run();
    QTest::qWait(wait);
  }
}

TEST(CouplePage, AProjectKnowsAScene) {
  const Measured measured("coupling-C");
  MainWindow window;
  window.show();
  window.open({measured.scene()});
  Project& project = *window.current();
  EXPECT_FALSE(project.checked().error);
  EXPECT_TRUE(find<QPushButton>(*project.couple_page(), "couple")->isEnabled());
}

}  // namespace
}  // namespace jointid::gui
