#include "gui/solve/solve_page.hpp"

#include <gmock/gmock.h>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QElapsedTimer>
#include <QProcess>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>

#include "base/statistics.hpp"
#include "base/text.hpp"
#include "gui/look/paths.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/table/cell_table.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "tasks/bound_report.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

struct Solving {
  Measured measured;
  SolvePage page;

  explicit Solving(const char* problem = "A1") : measured(problem) {
    page.resize(900, 700);
    page.show();
    page.set_file(measured.scene());
    page.set_scene(ident::read_scene(as_path(measured.scene())));
  }
  bool rests() {
    return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000);
  }
  void solve() {
    page.solve();
    ASSERT_TRUE(rests());
  }
};

/// What the command writes of a scene, without run times and its own call.
Json by_command(const QString& scene) {
  QProcess command;
  command.start(JOINTID_COMMAND, {"solve", scene, "--json", "-"});
  EXPECT_TRUE(command.waitForFinished(120000));
  Json json = Json::parse(command.readAllStandardOutput().toStdString());
  json.erase("runtime_s");
  json.erase("provenance");
  return json;
}

void expect_the_commands_json(const char* problem) {
  Solving solving(problem);
  solving.solve();
  ASSERT_EQ(solving.page.runs().size(), 1U) << solving.page.status().toStdString();
  Json json = Json::parse(json_of(solving.page.runs().front()));
  json.erase("runtime_s");
  EXPECT_EQ(json.dump(), by_command(solving.measured.scene()).dump());
}

TEST(SolvePage, TheJsonOfALinearMethodIsTheCommands) { expect_the_commands_json("A1"); }
TEST(SolvePage, TheJsonOfJointsWithBandsOrMassIsTheCommands) { expect_the_commands_json("B"); }
TEST(SolvePage, TheJsonOfAnIteratedMethodIsTheCommands) { expect_the_commands_json("H4"); }

TEST(SolvePage, ThePlanIsThereBeforeAnythingIsSolved) {
  Solving solving;
  ASSERT_TRUE(solving.rests());
  EXPECT_THAT(solving.page.plan_table()->text('\t').toStdString(), HasSubstr("4:+Y, 4:+RZ, 5:+Y, 5:+RZ"));
  EXPECT_TRUE(solving.page.runs().empty());
}

TEST(SolvePage, BoundsAreThoseOfTheLibrary) {
  Solving solving;
  ident::Scene scene = ident::read_scene(as_path(solving.measured.scene()));
  scene.noise = ident::NoiseSection{.model = "gaussian", .level = 0.01, .frf_model = {.level = 0.01}};
  solving.page.set_scene(scene);
  solving.page.bound();
  ASSERT_TRUE(solving.rests());
  const auto report = tasks::predict_bound(*ident::make_plan(scene), {}, {});
  const CellModel& cells = *solving.page.bounds()->cells();
  ASSERT_GT(cells.rowCount(), static_cast<int>(report.unknowns.size())) << solving.page.status().toStdString();
  EXPECT_EQ(cells.index(0, 1).data().toString().toStdString(), report.unknowns.front().name);
  EXPECT_THAT(cells.index(0, 2).data().toString().toStdString(), HasSubstr(digits(report.unknowns.front().bound, "%.3g")));
}

TEST(SolvePage, BoundsWithoutAJointToAssumeAreRefused) {
  Solving solving;
  ident::Scene scene = ident::read_scene(as_path(solving.measured.scene()));
  scene.truth.clear();
  solving.page.set_scene(scene);
  solving.page.bound();
  ASSERT_TRUE(solving.rests());
  EXPECT_EQ(solving.page.bounds()->cells()->rowCount(), 0);
  EXPECT_THAT(solving.page.status().toStdString(), HasSubstr("truth"));
}

TEST(SolvePage, TheLastSceneIsPlannedHoweverFastItChanges) {
  Solving solving;
  ident::Scene scene = ident::read_scene(as_path(solving.measured.scene()));
  for (const double low : {420.0, 440.0, 460.0}) {
    scene.frequency.range_hz = ident::Range{low, 1000.0};
    solving.page.set_scene(scene);
  }
  ASSERT_TRUE(solving.rests());
  EXPECT_THAT(solving.page.plan_table()->text('\t').toStdString(), HasSubstr("460 to 1000 Hz"));
}

TEST(SolvePage, ShowsUnknownsMatricesAndRegeneratedFrfs) {
  Solving solving;
  solving.solve();
  EXPECT_THAT(solving.page.unknowns()->text('\t').toStdString(), HasSubstr("K(1,1)"));
  EXPECT_EQ(solving.page.matrix()->cells()->rowCount(), 4);
  EXPECT_THAT(solving.page.findings()->text('\t').toStdString(), HasSubstr("assembly FRF error"));
  ASSERT_EQ(solving.page.plot()->curves().size(), 2U);
  EXPECT_FALSE(solving.page.plot()->curves()[1].is_measured);
}

TEST(SolvePage, EarlierRunsStay) {
  Solving solving;
  solving.solve();
  ident::Scene other = ident::read_scene(as_path(solving.measured.scene()));
  other.identify.equations = {ident::Equation::nn};
  solving.page.set_scene(other);
  solving.solve();
  ASSERT_EQ(solving.page.runs().size(), 2U);
  const QString second = solving.page.unknowns()->text('\t');
  auto* const runs = find<QComboBox>(solving.page, "runs");
  runs->setCurrentIndex(0);
  Q_EMIT runs->activated(0);
  EXPECT_NE(solving.page.unknowns()->text('\t'), second);
}

TEST(SolvePage, RunsStandBesideEachOther) {
  Solving solving;
  solving.solve();
  ident::Scene other = ident::read_scene(as_path(solving.measured.scene()));
  other.identify.equations = {ident::Equation::nn};
  solving.page.set_scene(other);
  solving.solve();
  const CellModel& cells = *solving.page.runs_table()->cells();
  ASSERT_EQ(cells.columnCount(), 2);
  const std::string text = solving.page.runs_table()->text('\t').toStdString();
  EXPECT_THAT(text, HasSubstr("run 1: one\trun 2: one"));
  EXPECT_THAT(text, HasSubstr("equations nn,"));
  EXPECT_THAT(text, HasSubstr("\nK(1,1)\t"));
  find<QCheckBox>(solving.page, "all_runs")->click();
  ASSERT_TRUE(solving.rests());
  ASSERT_EQ(solving.page.plot()->curves().size(), 3U);
  EXPECT_THAT(solving.page.plot()->curves()[2].name, HasSubstr("run 1"));
}

/// A page without what differs from run to run.
std::string without_times(const std::string& page) {
  return std::regex_replace(page, std::regex("run time[^<]*</dt><dd>[^<]*"), "");
}

/// Without the call of the command that made it.
std::string without_call(const std::string& page) {
  return std::regex_replace(page, std::regex("<details><summary>How this page was made</summary><pre>[^<]*</pre></details>\n"), "");
}

TEST(SolvePage, TheReportIsTheCommands) {
  Solving solving("H4");
  solving.solve();
  const QString mine = solving.measured.file("mine.html"), theirs = solving.measured.file("theirs.html");
  solving.page.write_report(mine);
  ASSERT_TRUE(solving.rests());
  ASSERT_EQ(QProcess::execute(JOINTID_COMMAND, {"solve", solving.measured.scene(), "--report", theirs}), 0);
  ASSERT_GT(read_file(mine).size(), 10000U) << solving.page.status().toStdString();
  EXPECT_TRUE(without_times(read_file(mine)) == without_times(without_call(read_file(theirs))));
}

TEST(SolvePage, NoReportReplacesAnInput) {
  Solving solving;
  solving.solve();
  const std::string before = read_file(solving.measured.files().front());
  solving.page.write_report(solving.measured.files().front());
  ASSERT_TRUE(solving.rests());
  EXPECT_THAT(solving.page.status().toStdString(), HasSubstr("input"));
  EXPECT_EQ(read_file(solving.measured.files().front()), before);
}

/// Those with the largest χ², as many as the fit says.
TEST(SolvePage, OutlyingLinesAreMarked) {
  Solving solving;
  ident::Scene scene = ident::read_scene(as_path(solving.measured.scene()));
  scene.noise = ident::NoiseSection{.model = "gaussian", .level = 0.01, .frf_model = {.level = 0.01}};
  scene.identify.method = ident::Method::likelihood;
  scene.identify.automatic = false;
  solving.page.set_scene(scene);
  solving.solve();
  ASSERT_EQ(solving.page.runs().size(), 1U) << solving.page.status().toStdString();
  Solved solved = solving.page.runs().front();
  ASSERT_TRUE(solved.solution.fit.chi_square);
  std::vector<double>& by_line = solved.solution.fit.chi_square->by_line;
  ASSERT_EQ(by_line.size(), solved.plan->lines.size());
  std::fill(by_line.begin(), by_line.end(), 1.0);
  by_line[0] = nan;
  by_line[3] = 40.0;
  by_line[1] = 50.0;
  solved.solution.fit.chi_square->outlying_lines = 2;
  EXPECT_THAT(outlying_hz(solved), testing::ElementsAre(solved.plan->lines[1].frequency_hz, solved.plan->lines[3].frequency_hz));
  solved.solution.fit.chi_square->outlying_lines = 0;
  EXPECT_TRUE(outlying_hz(solved).empty());
  solved.solution.fit.chi_square.reset();
  EXPECT_TRUE(outlying_hz(solved).empty());
}

TEST(SolvePage, SaysWhatIsWrongWithDataAndScene) {
  Solving solving;
  ident::Scene wrong = ident::read_scene(as_path(solving.measured.scene()));
  wrong.joints.front().dofs.front() = frf::Dof::parse("99:+Y");
  std::string place;
  QObject::connect(&solving.page, &SolvePage::failed, [&](const InputError& error) { place = error.parts().place; });
  solving.page.set_scene(wrong);
  solving.solve();
  EXPECT_THAT(place, HasSubstr("dofs"));
  EXPECT_THAT(solving.page.status().toStdString(), HasSubstr("99:+Y"));
  EXPECT_TRUE(solving.page.runs().empty());
}

TEST(SolvePage, WithoutASceneThereIsNothingToSolve) {
  Solving solving;
  solving.page.set_scene({});
  EXPECT_FALSE(find<QPushButton>(solving.page, "solve")->isEnabled());
  solving.solve();
  EXPECT_TRUE(solving.page.runs().empty());
}

TEST(SolvePage, CanBeCancelledAtAnyMoment) {
  Solving solving("H4");
  ASSERT_TRUE(solving.rests());
  std::mt19937 random(7);
  for (int i = 0; i < 10; ++i) {
    solving.page.solve();
    QTest::qWait(static_cast<int>(random() % 60));
    solving.page.cancel();
    ASSERT_TRUE(solving.rests());
  }
  for (const Solved& run : solving.page.runs()) {
    const bool whole = run.solution.message.find("Interrupted") == std::string::npos;
    EXPECT_TRUE(whole || run.solution.status == ident::Status::not_converged);
  }
}

TEST(SolvePage, CanBeDestroyedWhileItSolves) {
  for (const int wait : {0, 5, 30}) {
    Solving solving("H4");
    solving.page.solve();
    QTest::qWait(wait);
  }
}

TEST(SolvePage, TheCommandLineIsQuoted) {
  Solving solving;
  solving.page.set_file("/a b/it's.toml");
  find<QPushButton>(solving.page, "copy_command")->click();
  EXPECT_EQ(QApplication::clipboard()->text(), "jointid solve '/a b/it'\\''s.toml'");
}

TEST(CellTable, IsCopiedForSpreadsheets) {
  CellTable table("t", "T");
  table.show_rows({{"a", "b,c"}, {}, {{Cell{"1"}, Cell{"x\ty"}}, {Cell{"2"}, Cell{"\"z\""}}}});
  EXPECT_EQ(table.text(','), "a,\"b,c\"\n1,x\ty\n2,\"\"\"z\"\"\"\n");
  table.selectAll();
  QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text().toStdString(), "1\t\"x\ty\"\n2\t\"\"\"z\"\"\"\n");
}

TEST(CellTable, AMatrixHasItsNamesOnBothSides) {
  CellTable table("t", "T");
  table.show_rows({{"a", "b"}, {"a", "b"}, {{Cell{"1"}, Cell{"2"}}, {Cell{"3"}, Cell{"4"}}}});
  EXPECT_EQ(table.text('\t'), "\ta\tb\na\t1\t2\nb\t3\t4\n");
}

}  // namespace
}  // namespace jointid::gui
