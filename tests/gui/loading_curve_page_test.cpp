#include "gui/loading_curve/loading_curve_page.hpp"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QProcess>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <nlohmann/json.hpp>

#include "gui/loading_curve/loading_curve_choices.hpp"
#include "gui/look/choice_button.hpp"
#include "gui/look/paths.hpp"
#include "gui/page/plot_menu.hpp"
#include "gui/plot/chart.hpp"
#include "gui/table/cell_table.hpp"
#include "problems/problem.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

/// A softening curve that reaches macroslip, in mm and N.
std::string softening_curve() {
  std::string text = "position [mm],force [N]\n";
  for (int i = 0; i <= 60; ++i) {
    const double u = 0.01 * i, force = 100.0 * std::tanh(u / 0.2) + 0.2 * std::sin(40.0 * i);
    text += std::to_string(u) + "," + std::to_string(force) + "\n";
  }
  return text;
}

struct FittingCurves {
  QTemporaryDir folder;
  QString file = folder.filePath("my curve.csv");
  LoadingCurvePage page;

  FittingCurves() {
    page.resize(900, 700);
    page.show();
    write_file(file, softening_curve());
  }
  bool rests() {
    return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000);
  }
  bool open_and_fit(const QStringList& laws) {
    find<ChoiceButton>(page, "curve_laws")->choose(laws);
    page.open({file});
    if (!rests()) return false;
    find<QPushButton>(page, "curve_fit")->click();
    return rests() && page.shown() != nullptr;
  }
};

nlohmann::json json_of(QString line) {
  QProcess process;
  process.start("/bin/sh", {"-c", line.replace(0, 7, shell_word(JOINTID_COMMAND)) + " --json -"});
  if (!process.waitForFinished(60000) || process.exitCode() != 0) return {};
  return nlohmann::json::parse(process.readAllStandardOutput().toStdString());
}

TEST(LoadingCurvePage, FitsWhatTheCommandFits) {
  FittingCurves fitting;
  EXPECT_FALSE(find<QPushButton>(fitting.page, "curve_fit")->isEnabled());
  ASSERT_TRUE(fitting.open_and_fit({"ren", "bilinear"})) << fitting.page.status().toStdString();
  const auto& fits = fitting.page.shown()->fits;
  ASSERT_EQ(fits.size(), 2U);
  EXPECT_THAT(fitting.page.status().toStdString(), HasSubstr("Best law by AIC: " + fits[0].law));
  const nlohmann::json json = json_of(fitting.page.command_line());
  ASSERT_TRUE(json.contains("fits")) << fitting.page.command_line().toStdString();
  for (std::size_t i = 0; i < fits.size(); ++i) {
    EXPECT_EQ(json["fits"][i]["law"].get<std::string>(), fits[i].law);
    EXPECT_EQ(json["fits"][i]["aic"].get<double>(), fits[i].aic);
  }
  EXPECT_EQ(fitting.page.laws()->cells()->rowCount(), 2);
}

TEST(LoadingCurvePage, ShowsCurvesResidualsAndEquivalents) {
  FittingCurves fitting;
  ASSERT_TRUE(fitting.open_and_fit({"ren", "iwan"}));
  const auto& plots = fitting.page.plots()->chart()->curve_plots();
  ASSERT_EQ(plots.size(), 2U);  // the curve, and residuals
  EXPECT_EQ(plots[0].series.size(), 3U);
  EXPECT_EQ(plots[1].series.size(), 2U);
  fitting.page.plots()->menu()->setCurrentIndex(1);
  ASSERT_EQ(fitting.page.plots()->chart()->curve_plots().size(), 3U);
  EXPECT_EQ(fitting.page.plots()->chart()->curve_plots()[0].title, "Equivalent stiffness");
  EXPECT_GT(fitting.page.equivalents()->cells()->rowCount(), 10);
  fitting.page.laws()->selectRow(1);
  EXPECT_THAT(fitting.page.tables()->tabText(1).toStdString(), HasSubstr(fitting.page.shown()->fits[1].law));
  EXPECT_THAT(fitting.page.plots()->chart()->saveable().table(',').substr(0, 30), HasSubstr("amplitude"));
}

TEST(LoadingCurvePage, SaysWhatIsWrong) {
  FittingCurves fitting;
  write_file(fitting.file, "a,b\n1,2\n2,3\n");
  EXPECT_FALSE(fitting.open_and_fit({}));
  EXPECT_THAT(fitting.page.status().toStdString(), HasSubstr("no column is named"));
  fitting.page.open({"/nowhere/x.csv"});
  ASSERT_TRUE(fitting.rests());
  EXPECT_THAT(fitting.page.status().toStdString(), HasSubstr("x.csv"));
}

TEST(LoadingCurvePage, CancelAndDestructionAtAnyMoment) {
  for (const int wait : {0, 5, 30}) {
    FittingCurves fitting;
    fitting.page.open({fitting.file});
    fitting.page.run();
    QTest::qWait(wait);
    fitting.page.cancel();
    ASSERT_TRUE(fitting.rests());
    fitting.page.run();
    QTest::qWait(wait);
  }
}

TEST(LoadingCurveCommand, SaysWhatIsNotAsUsual) {
  tasks::LoadingCurveTask task;
  task.files = {"a b.csv"};
  EXPECT_EQ(loading_curve_command(task).toStdString(), "jointid loading-curve 'a b.csv'");
  task.displacement = "x [1]";
  task.unit = "mm";
  task.laws = {"ren", "iwan"};
  task.weighting = "travel";
  task.limit = 12.5;
  EXPECT_EQ(
      loading_curve_command(task).toStdString(),
      "jointid loading-curve 'a b.csv' --displacement 'x [1]' --unit 'mm' --weighting 'travel' --law ren,iwan --limit 12.5");
}

}  // namespace
}  // namespace jointid::gui
