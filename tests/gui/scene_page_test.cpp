#include "gui/page/scene_page.hpp"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QTest>
#include <algorithm>
#include <map>

#include "command_files.hpp"
#include "gui/laws/law_kind.hpp"
#include "gui/lines/line_kind.hpp"
#include "gui/look/paths.hpp"
#include "gui/main_window.hpp"
#include "gui/oscillate/oscillate_kind.hpp"
#include "gui/plot/chart.hpp"
#include "gui/plot/heat_chart.hpp"
#include "gui/project.hpp"
#include "gui/response/response_kind.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Three masses with a slipping joint: two levels, a curve along the force, and a motion from rest.
const char* const sliding = R"(
[structure]
mass = [[1.0, 0.0, 0.0], [0.0, 1.2, 0.0], [0.0, 0.0, 0.9]]
stiffness = [[500.0, -200.0, 0.0], [-200.0, 250.0, -50.0], [0.0, -50.0, 150.0]]
damping = [[0.5, -0.16, 0.0], [-0.16, 0.32, -0.04], [0.0, -0.04, 0.21]]

[[joints]]
dofs = [2, 3]
law = "ren"
parameters = { a = 0.004, b = 1.5, k = 150.0 }

[force]
dof = 1
amplitudes = [1.0, 3.0]

[frequency]
range = [2.0, 4.0]
points = 41

[response]
dofs = [1, 3]
harmonics = [1, 3]
)";

/// One mass on a belt: a stick-slip orbit, its exponents and how it changes with the velocity.
const char* const on_a_belt = R"(
[system]
kind = "belt_chain"
masses = 1
mass = 1.3
stiffness = 2.1
velocity = 0.2

[friction]
kinetic = 0.3
static = 0.5
normal = 1.7

[start]
velocity = [0.2]

[motion]
transient = 5.0
length = 40.0
step = 0.05

[orbit]
slips = 1

[exponents]
count = 1
transient = 10.0
length = 50.0
interval = 1.0

[sweep]
parameter = "velocity"
range = [0.15, 0.3]
points = 4
transient = 10.0
length = 60.0
)";

const char* const wrong_laws = "[data]\nparts = [\"a.h5\"]\n[[joint.friction]]\ndofs = [\"1:+X\", \"2:+X\"]\nlawz = [\"ren\"]\n";

struct Page {
  QTemporaryDir folder;
  QString file = folder.filePath("scene.toml");
  ScenePage page;

  explicit Page(SceneKind kind) : page(std::move(kind)) {
    page.resize(900, 700);
    page.show();
  }
  std::optional<SceneError> set(const std::string& text) {
    write_file(file, text);
    return page.set_scene(text, as_path(file), file);
  }
  bool rests() {
    return QTest::qWaitFor([&] { return !page.is_busy(); }, 60000);
  }
  bool run() {
    page.run();
    return rests() && page.shown() != nullptr;
  }
};

/// Names of the menu and the most groups of points, or curves of the first diagram, of any of their choices.
std::map<std::string, std::size_t> drawn_by_choice(Page& page) {
  std::map<std::string, std::size_t> out;
  QComboBox& menu = *page.page.plots()->menu();
  for (int i = 0; i < menu.count(); ++i) {
    menu.setCurrentIndex(i);
    const Chart& chart = *page.page.plots()->chart();
    std::size_t& most = out[menu.itemText(i).section(':', 0, 0).toStdString()];
    most =
        std::max(most, chart.curve_plots().empty() ? chart.scatter().groups.size() : chart.curve_plots().front().series.size());
  }
  return out;
}

TEST(ScenePage, FindsResponsesAsTheCommandDoes) {
  Page page(response_kind());
  ASSERT_FALSE(page.set(sliding));
  ASSERT_TRUE(page.run()) << page.page.status().toStdString();
  EXPECT_FALSE(page.page.shown()->is_bad);
  expect_the_commands_files(page.page, page.folder);
}

TEST(ScenePage, IntegratesMotionsAsTheCommandDoes) {
  Page page(oscillate_kind());
  ASSERT_FALSE(page.set(on_a_belt));
  ASSERT_TRUE(page.run()) << page.page.status().toStdString();
  EXPECT_FALSE(page.page.shown()->is_bad);
  expect_the_commands_files(page.page, page.folder);
  expect_every_choice_drawn(page.page);
  const auto drawn = drawn_by_choice(page);
  EXPECT_EQ(drawn.at("motion"), 1U);  // one mass, one phase plane
  EXPECT_EQ(drawn.at("bifurcation diagram"), 1U);
  EXPECT_GE(page.page.tables()->menu()->count(), 5);
}

TEST(ScenePage, SaysWhatIsWrongWithAMotion) {
  Page page(oscillate_kind());
  std::string text = on_a_belt;
  const auto wrong = page.set(text.replace(text.find("masses = 1"), 10, "masses = 0"));
  ASSERT_TRUE(wrong);
  EXPECT_THAT(wrong->problem + wrong->remedy, HasSubstr("from 1 to 1000"));
  EXPECT_GT(wrong->line, 0);
  EXPECT_FALSE(find<QPushButton>(page.page, "oscillate_run")->isEnabled());
  EXPECT_FALSE(page.set(sliding));
  EXPECT_FALSE(find<QPushButton>(page.page, "oscillate_run")->isEnabled());
}

TEST(ScenePage, DrawsEveryChoice) {
  Page page(response_kind());
  ASSERT_FALSE(page.set(sliding));
  ASSERT_TRUE(page.run()) << page.page.status().toStdString();
  expect_every_choice_drawn(page.page);
  const auto drawn = drawn_by_choice(page);
  EXPECT_EQ(drawn.at("loop"), 2U);  // of two levels
  EXPECT_EQ(drawn.at("response"), 2U);
  EXPECT_GE(page.page.tables()->menu()->count(), 3);
}

TEST(ScenePage, SaysWhatIsWrongWithTheScene) {
  Page page(response_kind());
  std::string text = sliding;
  const auto wrong = page.set(text.replace(text.find("amplitudes"), 10, "amplitudez"));
  ASSERT_TRUE(wrong);
  EXPECT_THAT(wrong->problem + wrong->remedy, HasSubstr("amplitude"));
  EXPECT_GT(wrong->line, 0);
  EXPECT_FALSE(find<QPushButton>(page.page, "response_run")->isEnabled());
  EXPECT_FALSE(page.set(small_scene));
  Page laws(law_kind());
  ASSERT_TRUE(laws.set(wrong_laws));
  EXPECT_FALSE(laws.set(small_scene));
  EXPECT_FALSE(laws.set(sliding));
}

TEST(ScenePage, NoOutputReplacesAnInput) {
  Page page(response_kind());
  ASSERT_FALSE(page.set(sliding));
  ASSERT_TRUE(page.run());
  page.page.write(page.file, "csv");
  EXPECT_EQ(read_file(page.file), sliding);
  EXPECT_THAT(page.page.status().toStdString(), HasSubstr("scene.toml"));
}

TEST(ScenePage, CanBeCancelledAndDestroyedAtAnyMoment) {
  for (const int wait : {0, 5, 20}) {
    for (const auto& [kind, text] : {std::pair(response_kind(), sliding), std::pair(oscillate_kind(), on_a_belt)}) {
      Page page(kind);
      ASSERT_FALSE(page.set(text));
      page.page.run();
      QTest::qWait(wait);
      page.page.cancel();
      ASSERT_TRUE(page.rests());
      page.page.run();
      QTest::qWait(wait);
    }
  }
}

/// One joint of Iwan's elements at a few levels: the law, its parameters and the residuals are those of the command.
TEST(ScenePage, IdentifiesLawsAsTheCommandDoes) {
  const Measured measured("sdof-iwan");
  Page page(law_kind());
  std::string text = read_file(measured.scene());
  text.replace(text.find("[\"bilinear"), text.find("# one") - text.find("[\"bilinear"), "[\"iwan\"] ");
  text.replace(text.find("[80.0, 135.0]"), 13, "[95.0, 115.0]");
  page.file = measured.scene();
  ASSERT_FALSE(page.set(text));
  ASSERT_TRUE(page.run()) << page.page.status().toStdString();
  EXPECT_THAT(page.page.status().toStdString(), HasSubstr("iwan"));
  EXPECT_EQ(page.page.plots()->menu()->count(), 1);
  EXPECT_EQ(page.page.plots()->chart()->curve_plots().size(), 3U);
  EXPECT_GE(page.page.tables()->menu()->count(), 4);
  const QString mine = measured.file("mine.csv"), theirs = measured.file("theirs.csv");
  page.page.write(mine, "csv");
  QProcess process;
  process.start(JOINTID_COMMAND, {"solve", measured.scene(), "--csv", theirs});
  ASSERT_TRUE(process.waitForFinished(120000));
  EXPECT_EQ(read_file(mine), read_file(theirs));
}

/// Z at every line of two beams and a joint: the files are those of the command.
TEST(ScenePage, FindsZAtEveryLineAsTheCommandDoes) {
  const Measured measured("A1");
  Page page(line_kind());
  std::string text = read_file(measured.scene());
  text = text.substr(0, text.find("[joint"));
  text += R"([joint]
dofs = ["4:+Y", "4:+RZ", "5:+Y", "5:+RZ"]
lines = "symmetric"
laws = ["hysteretic"]

[noise]
model = "gaussian"
level = 0.01
)";
  page.file = measured.file("lines.toml");
  EXPECT_FALSE(line_kind().is_of(read_file(measured.scene())));
  EXPECT_TRUE(line_kind().is_of(text));
  const auto wrong = page.set(text);
  ASSERT_FALSE(wrong) << wrong->problem << '\n' << text;
  ASSERT_TRUE(page.run()) << page.page.status().toStdString();
  EXPECT_GE(page.page.plots()->menu()->count(), 2);
  EXPECT_EQ(page.page.plots()->chart()->curve_plots().size(), 3U);
  EXPECT_GE(page.page.tables()->menu()->count(), 3);
  const QString mine = measured.file("mine.csv"), theirs = measured.file("theirs.csv");
  page.page.write(mine, "csv");
  QProcess process;
  process.start(JOINTID_COMMAND, {"solve", page.file, "--csv", theirs});
  ASSERT_TRUE(process.waitForFinished(120000));
  EXPECT_NE(read_file(mine), "");
  EXPECT_EQ(read_file(mine), read_file(theirs));
}

TEST(ScenePage, ThreeForceLevelsAndMoreAreAMap) {
  Page page(response_kind());
  std::string text = sliding;
  ASSERT_FALSE(page.set(text.replace(text.find("[1.0, 3.0]"), 10, "[1.0, 2.0, 3.0]")));
  ASSERT_TRUE(page.run()) << page.page.status().toStdString();
  QComboBox& menu = *page.page.plots()->menu();
  const int map = menu.findText("map over force levels", Qt::MatchStartsWith);
  ASSERT_GE(map, 0);
  menu.setCurrentIndex(map);
  const HeatPlot& drawn = page.page.plots()->map()->plot();
  EXPECT_EQ(drawn.rows.size(), 3U);
  EXPECT_EQ(drawn.values.size(), 3U * drawn.x_values.size());
  EXPECT_TRUE(page.page.plots()->map()->isVisible());
  menu.setCurrentIndex(0);
  EXPECT_FALSE(page.page.plots()->map()->isVisible());
}

/// What the levels will tell, and simulated tests, as `plan --bound` and `study` say it.
TEST(ScenePage, BoundsAndStudiesOfLawsAreThoseOfTheCommands) {
  const Measured measured("sdof-iwan");
  Page page(law_kind());
  std::string text = read_file(measured.scene());
  text.replace(text.find("[\"bilinear"), text.find("# one") - text.find("[\"bilinear"), "[\"iwan\"] ");
  text.replace(text.find("[80.0, 135.0]"), 13, "[100.0, 108.0]");
  page.file = measured.file("short.toml");
  ASSERT_FALSE(page.set(text));
  QComboBox& jobs = *page.page.jobs();
  ASSERT_TRUE(jobs.isVisible());
  QSpinBox& trials = *find<QSpinBox>(page.page, "laws_trials");
  EXPECT_FALSE(trials.isVisible());
  jobs.setCurrentIndex(1);
  ASSERT_TRUE(page.run()) << page.page.status().toStdString();
  EXPECT_THAT(page.page.command_line().toStdString(), AllOf(HasSubstr("jointid plan"), HasSubstr("--bound")));
  EXPECT_EQ(page.page.shown()->outputs.size(), 1U);
  EXPECT_FALSE(find<QPushButton>(page.page, "laws_csv")->isEnabled());
  expect_the_commands_files(page.page, page.folder);
  EXPECT_GT(page.page.tables()->table()->cells()->rowCount(), 3);
  jobs.setCurrentIndex(2);
  EXPECT_TRUE(trials.isVisible());
  trials.setValue(4);
  ASSERT_TRUE(page.run()) << page.page.status().toStdString();
  EXPECT_THAT(page.page.status().toStdString(), HasSubstr("4 trials"));
  EXPECT_THAT(page.page.command_line().toStdString(), HasSubstr("--trials 4"));
  EXPECT_GE(page.page.plots()->chart()->histograms().size(), 2U);
  EXPECT_THAT(page.page.shown()->outputs.at("html")(), HasSubstr("Errors and intervals"));
  expect_the_commands_files(page.page, page.folder);
  jobs.setCurrentIndex(2);
  page.page.run();
  QTest::qWait(20);
  page.page.cancel();
  EXPECT_TRUE(page.rests());
}

TEST(ScenePage, AProjectKnowsItsScenes) {
  const QTemporaryDir folder;
  write_file(folder.filePath("response.toml"), sliding);
  MainWindow window;
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  window.open({folder.filePath("response.toml")});
  Project& project = *window.current();
  EXPECT_FALSE(project.checked().error);
  EXPECT_TRUE(find<QPushButton>(*project.response_page(), "response_run")->isEnabled());
  EXPECT_FALSE(find<QPushButton>(*project.laws_page(), "laws_run")->isEnabled());
  QTest::keyClick(&window, Qt::Key_1, Qt::ControlModifier);
  EXPECT_EQ(project.pages()->currentWidget(), project.response_page());
  const auto is_seen = [](Project& of, QWidget* page) { return of.pages()->isTabVisible(of.pages()->indexOf(page)); };
  EXPECT_TRUE(is_seen(project, project.response_page()));
  EXPECT_FALSE(is_seen(project, project.laws_page()));  // of other scenes, until it is asked for
  QTest::keyClick(&window, Qt::Key_2, Qt::ControlModifier);
  EXPECT_TRUE(is_seen(project, project.laws_page()));
  EXPECT_FALSE(find<QPushButton>(*project.oscillate_page(), "oscillate_run")->isEnabled());
  write_file(folder.filePath("belt.toml"), on_a_belt);
  window.open({folder.filePath("belt.toml")});
  EXPECT_FALSE(window.current()->checked().error);
  EXPECT_TRUE(find<QPushButton>(*window.current()->oscillate_page(), "oscillate_run")->isEnabled());
  QTest::keyClick(&window, Qt::Key_3, Qt::ControlModifier);
  EXPECT_EQ(window.current()->pages()->currentWidget(), window.current()->oscillate_page());
}

}  // namespace
}  // namespace jointid::gui
