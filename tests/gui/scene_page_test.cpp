#include "gui/page/scene_page.hpp"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QProcess>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>

#include "gui/laws/law_kind.hpp"
#include "gui/look/paths.hpp"
#include "gui/main_window.hpp"
#include "gui/plot/chart.hpp"
#include "gui/project.hpp"
#include "gui/response/response_kind.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

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

TEST(ScenePage, FindsResponsesAsTheCommandDoes) {
  Page page(response_kind());
  ASSERT_FALSE(page.set(sliding));
  ASSERT_TRUE(page.run()) << page.page.status().toStdString();
  EXPECT_FALSE(page.page.shown()->is_bad);
  for (const char* ending : {"json", "csv"}) {
    const QString mine = page.folder.filePath(QString("mine.") + ending), theirs = page.folder.filePath(QString("theirs.") + ending);
    page.page.write(mine, ending);
    QProcess process;
    process.start("/bin/sh", {"-c", shell_word(JOINTID_COMMAND) + page.page.command_line().mid(7) + " --" + ending + " " + shell_word(theirs)});
    ASSERT_TRUE(process.waitForFinished(60000));
    ASSERT_EQ(process.exitCode(), 0) << page.page.command_line().toStdString();
    EXPECT_EQ(read_file(mine), read_file(theirs)) << ending;
  }
  page.page.write(page.folder.filePath("page.html"), "html");
  EXPECT_THAT(read_file(page.folder.filePath("page.html")), HasSubstr("</html>"));
}

/// A diagram for every choice of the menu, points and curves, and a table for every one of its.
TEST(ScenePage, DrawsEveryChoice) {
  Page page(response_kind());
  ASSERT_FALSE(page.set(sliding));
  ASSERT_TRUE(page.run()) << page.page.status().toStdString();
  QComboBox& menu = *page.page.plots()->menu();
  bool loops = false, levels = false;
  for (int i = 0; i < menu.count(); ++i) {
    menu.setCurrentIndex(i);
    const Chart& chart = *page.page.plots()->chart();
    EXPECT_NE(chart.curve_plots().empty(), chart.scatter().groups.empty()) << menu.itemText(i).toStdString();
    loops = loops || (menu.itemText(i).startsWith("loop") && chart.scatter().groups.size() == 2U);
    levels = levels || (menu.itemText(i).startsWith("response") && chart.curve_plots().front().series.size() == 2U);
  }
  EXPECT_TRUE(loops && levels);
  QComboBox& tables = *page.page.tables()->menu();
  ASSERT_GE(tables.count(), 3);
  for (int i = 0; i < tables.count(); ++i) {
    tables.setCurrentIndex(i);
    EXPECT_GT(page.page.tables()->table()->cells()->rowCount(), 0) << tables.itemText(i).toStdString();
  }
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
    Page page(response_kind());
    ASSERT_FALSE(page.set(sliding));
    page.page.run();
    QTest::qWait(wait);
    page.page.cancel();
    ASSERT_TRUE(page.rests());
    page.page.run();
    QTest::qWait(wait);
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
}

}  // namespace
}  // namespace jointid::gui
