#include "gui/main_window.hpp"

#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSet>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QTimer>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>
#include <tuple>

#include "base/stopwatch.hpp"
#include "gui/begin/example_dialog.hpp"
#include "gui/compare/compare_page.hpp"
#include "gui/data/data_page.hpp"
#include "gui/help/help_window.hpp"
#include "gui/look/message_bar.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/solve_page.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

struct Shown {
  QTemporaryDir folder;
  MainWindow window;

  Shown() {
    window.resize(900, 600);
    window.show();
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
  }
  ~Shown() {
    for (int i = 0; i < window.count(); ++i) project(i)->editor()->document()->setModified(false);
  }
  Project* project(int index) { return qobject_cast<Project*>(find<QTabWidget>(window, "projects")->widget(index)); }
  QString scene(const char* name, const std::string& text = small_scene) {
    write_file(folder.filePath(name), text);
    return folder.filePath(name);
  }
  void drop(const QStringList& files) { gui::drop(window, files); }
};

/// Presses a button of the message box that will be open in a moment.
void answer(QMessageBox::StandardButton button) {
  QTimer::singleShot(50, qApp, [button] {
    auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box != nullptr) box->button(button)->click();
  });
}

/// How many colours a picture has, counted up to a hundred.
qsizetype colours_in(const QImage& image) {
  QSet<QRgb> seen;
  for (int y = 0; y < image.height() && seen.size() < 100; y += 2) {
    for (int x = 0; x < image.width(); x += 2) seen.insert(image.pixel(x, y));
  }
  return seen.size();
}

TEST(MainWindow, SaysHowToBegin) {
  Shown shown;
  EXPECT_TRUE(find<QLabel>(shown.window, "hint")->isVisible());
  EXPECT_EQ(shown.window.current(), nullptr);
}

TEST(MainWindow, DroppedScenesAreTabs) {
  Shown shown;
  const QString one = shown.scene("one.toml"), two = shown.scene("two.toml");
  shown.drop({one, two});
  ASSERT_EQ(shown.window.count(), 2);
  EXPECT_EQ(shown.window.current()->file(), two);
  shown.drop({one});
  ASSERT_EQ(shown.window.count(), 2);
  EXPECT_EQ(shown.window.current()->file(), one);
}

TEST(MainWindow, AFileThatIsNotThereLeavesNoTab) {
  Shown shown;
  shown.window.open({"/no/such/scene.toml"});
  ASSERT_EQ(shown.window.count(), 0);
  EXPECT_THAT(shown.window.messages()->text().toStdString(), testing::HasSubstr("/no/such/scene.toml"));
}

TEST(MainWindow, DroppedFrfFilesAreANewScene) {
  Shown shown;
  const Measured rig("A1");
  shown.drop(rig.files());
  ASSERT_TRUE(QTest::qWaitFor([&] { return shown.window.count() == 1; }, 20000));
  const CheckedScene& checked = shown.window.current()->checked();
  ASSERT_TRUE(checked.scene) << checked.error->problem;
  EXPECT_EQ(checked.scene->data.substructures.size(), 2U);
  EXPECT_TRUE(shown.window.isWindowModified());
}

TEST(MainWindow, WrongFilesDroppedAreSaidToBeWrong) {
  Shown shown;
  shown.drop({shown.scene("picture.png", "no picture"), shown.scene("letter.txt", "Dear Sir")});
  const auto said = [&] { return shown.window.messages()->text().toStdString(); };
  ASSERT_TRUE(QTest::qWaitFor([&] { return said().find("picture.png") != std::string::npos; }, 5000)) << said();
  EXPECT_EQ(shown.window.count(), 0);
}

TEST(MainWindow, KeysMakeSaveAndCloseScenes) {
  Shown shown;
  shown.window.open({shown.scene("one.toml")});
  QTest::keyClicks(shown.window.current()->editor(), "# x");
  EXPECT_TRUE(shown.window.isWindowModified());
  QTest::keyClick(&shown.window, Qt::Key_S, Qt::ControlModifier);
  EXPECT_FALSE(shown.window.isWindowModified());
  EXPECT_THAT(read_file(shown.folder.filePath("one.toml")), testing::StartsWith("# x"));
  QTest::keyClick(&shown.window, Qt::Key_N, Qt::ControlModifier);
  ASSERT_EQ(shown.window.count(), 2);
  answer(QMessageBox::Discard);
  QTest::keyClick(&shown.window, Qt::Key_W, Qt::ControlModifier);
  ASSERT_EQ(shown.window.count(), 1);
}

TEST(MainWindow, UnsavedChangesAreNotLostByAccident) {
  Shown shown;
  shown.window.open({shown.scene("one.toml")});
  QTest::keyClicks(shown.window.current()->editor(), "# x");
  answer(QMessageBox::Cancel);
  EXPECT_FALSE(shown.window.close());
  answer(QMessageBox::Save);
  EXPECT_TRUE(shown.window.close());
  EXPECT_THAT(read_file(shown.folder.filePath("one.toml")), testing::StartsWith("# x"));
}

TEST(MainWindow, FromDroppedFilesToTheCommandsAnswer) {
  Shown shown;
  const Measured rig("A1");
  shown.drop(rig.files());
  ASSERT_TRUE(QTest::qWaitFor([&] { return shown.window.count() == 1; }, 20000));
  Project& project = *shown.window.current();
  ASSERT_TRUE(project.save_as(rig.file("mine.toml")));
  QTest::keyClick(&shown.window, Qt::Key_F5);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !project.solve_page()->runs().empty(); }, 60000))
      << project.solve_page()->status().toStdString();
  EXPECT_EQ(project.pages()->currentWidget(), project.solve_page());
  QProcess command;
  command.start(JOINTID_COMMAND, {"solve", rig.file("mine.toml"), "--json", "-"});
  ASSERT_TRUE(command.waitForFinished(60000));
  auto theirs = nlohmann::ordered_json::parse(command.readAllStandardOutput().toStdString());
  auto ours = nlohmann::ordered_json::parse(json_of(project.solve_page()->runs().front()));
  theirs.erase("runtime_s");
  theirs.erase("provenance");
  ours.erase("runtime_s");
  EXPECT_EQ(ours.dump(), theirs.dump());
}

TEST(MainWindow, AWrongPlanStandsBelowItsLine) {
  Shown shown;
  const Measured rig("A1");
  shown.window.open({rig.scene()});
  Project& project = *shown.window.current();
  std::string text = project.editor()->text();
  text.replace(text.find("4:+Y"), 4, "77:+Y");
  project.editor()->replace_text(text);
  QTest::keyClick(&shown.window, Qt::Key_F6);
  ASSERT_TRUE(QTest::qWaitFor([&] { return project.editor()->error().has_value(); }, 20000));
  EXPECT_THAT(project.editor()->error()->problem, testing::HasSubstr("77:+Y"));
  EXPECT_GT(project.editor()->error()->line, 0);
}

TEST(MainWindow, OneCursorIsInAllPlots) {
  Shown shown;
  const Measured rig("A1");
  shown.window.open({rig.scene()});
  Project& project = *shown.window.current();
  project.solve_page()->solve();
  const auto drawn = [&] {
    return !project.solve_page()->plot()->curves().empty() && !project.data_page()->plot()->curves().empty();
  };
  ASSERT_TRUE(QTest::qWaitFor(drawn, 60000));
  Q_EMIT project.data_page()->plot()->cursor_moved(600.0);
  EXPECT_THAT(project.solve_page()->plot()->readout().toStdString(), testing::StartsWith("600 Hz"));
  Q_EMIT project.solve_page()->plot()->cursor_moved(800.0);
  EXPECT_THAT(project.data_page()->plot()->readout().toStdString(), testing::StartsWith("800 Hz"));
}

TEST(MainWindow, TheTimeToTheFirstWindowIsTold) {
  QElapsedTimer timer;
  timer.start();
  Shown shown;
  shown.window.grab();
  std::printf("%lld ms to the first window\n", static_cast<long long>(timer.elapsed()));
}

/// How long the window was blocked while something was done: by the clock, and what its thread worked meanwhile, which other
/// work on the machine does not lengthen.
class Blocked {
 public:
  Blocked() {
    QObject::connect(&tick_, &QTimer::timeout, [this] { count(); });
    tick_.start(1);
    restart();
  }
  void begin(const std::string& step) {
    count();
    longest_.emplace_back(step, 0.0, 0.0);
    restart();
  }
  void tell() {
    count();
    std::printf("the window is blocked at most, by the clock and by the work of its thread\n");
    for (const auto& [step, clock, work] : longest_) {
      std::printf("%5.0f ms, %4.0f ms: %s\n", 1e3 * clock, 1e3 * work, step.c_str());
    }
  }

 private:
  static double work() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }
  void restart() {
    since_ = Clock::now();
    work_ = work();
  }
  void count() {
    if (!longest_.empty()) {
      auto& [step, clock_s, work_s] = longest_.back();
      clock_s = std::max(clock_s, seconds_since(since_));
      work_s = std::max(work_s, work() - work_);
    }
    restart();
  }

  QTimer tick_;
  std::vector<std::tuple<std::string, double, double>> longest_;
  Clock::time_point since_;
  double work_ = 0.0;
};

/// Reports only: a machine with other work says nothing of the program.
TEST(MainWindow, HowLongItEverBlocksIsTold) {
  const Measured measured("rig1");
  Shown shown;
  Blocked blocked;
  blocked.begin("opening a scene");
  shown.window.open({measured.scene()});
  Project& project = *shown.window.current();
  const auto rests = [&] {
    return QTest::qWaitFor([&] { return !project.data_page()->is_busy() && !project.solve_page()->is_busy(); }, 60000);
  };
  ASSERT_TRUE(rests());
  blocked.begin("opening another");
  shown.window.open({shown.scene("another.toml")});
  QTest::qWait(50);
  shown.window.open({measured.scene()});
  for (int page = 0; page < project.pages()->count(); ++page) {
    blocked.begin("page " + project.pages()->tabText(page).toStdString());
    project.pages()->setCurrentIndex(page);
    QTest::qWait(50);
  }
  blocked.begin("the form");
  project.switch_view(true);
  QTest::qWait(50);
  blocked.begin("a letter in the form");
  QTest::keyClicks(QApplication::focusWidget(), "x");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backspace);
  QTest::qWait(50);
  project.switch_view(false);
  blocked.begin("a letter in the text");
  QTest::keyClicks(project.editor(), "#");
  QTest::qWait(400);
  project.editor()->undo();
  QTest::qWait(400);
  ASSERT_TRUE(rests());
  blocked.begin("solving");
  project.solve_page()->solve();
  ASSERT_TRUE(rests());
  QTest::qWait(50);
  blocked.begin("the other theme");
  shown.window.set_theme(Theme::dark);
  QTest::qWait(50);
  shown.window.set_theme(Theme::light);
  QTest::qWait(50);
  blocked.tell();
  EXPECT_EQ(project.solve_page()->runs().size(), 1U);
}

/// The way of a comparison becomes that of the text, which solves to what the command finds.
TEST(MainWindow, AWayThatIsOpenedIsAnEditAndASolution) {
  const Measured measured("A1");
  Shown shown;
  shown.window.open({measured.scene()});
  Project& project = *shown.window.current();
  study::Way way;
  way.method = ident::Method::two;
  way.equations = {ident::Equation::jj, ident::Equation::jn};
  way.solver = ident::Solver::qr;
  Q_EMIT project.compare_page()->way_opened(way);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !project.solve_page()->is_busy(); }, 60000));
  ASSERT_EQ(project.solve_page()->runs().size(), 1U) << project.solve_page()->status().toStdString();
  EXPECT_EQ(project.solve_page()->runs().front().solution.used.method, ident::Method::two);
  EXPECT_EQ(project.pages()->currentWidget(), project.solve_page());
  EXPECT_TRUE(project.is_modified());
  project.editor()->undo();
  EXPECT_FALSE(project.is_modified());
}

TEST(MainWindow, F1OpensThePageOfTheDocumentation) {
  Shown shown;
  QTest::keyClick(&shown.window, Qt::Key_4, Qt::ControlModifier);  // time records
  QTest::keyClick(&shown.window, Qt::Key_F1);
  auto* const help = shown.window.findChild<HelpWindow*>();
  ASSERT_NE(help, nullptr);
  EXPECT_TRUE(help->isVisible());
  EXPECT_THAT(help->browser()->source().toString().toStdString(), testing::EndsWith("docs/records.md"));
  EXPECT_THAT(help->browser()->toPlainText().toStdString(), testing::HasSubstr("jointid frf"));
  help->show_page("no such page");
  EXPECT_THAT(help->browser()->toPlainText().toStdString(), testing::HasSubstr("The workbench"));
}

TEST(MainWindow, AKeyOpensTheExamples) {
  Shown shown;
  QTest::keyClick(&shown.window, Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
  auto* const dialog = shown.window.findChild<ExampleDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->isVisible());
  QTest::keyClick(dialog, Qt::Key_Escape);
  EXPECT_FALSE(dialog->isVisible());
}

TEST(MainWindow, OneKeyFoldsTheText) {
  Shown shown;
  shown.window.open({shown.scene("one.toml")});
  QWidget& editor = *shown.window.current()->editor();
  QTest::keyClick(&shown.window, Qt::Key_B, Qt::ControlModifier);
  EXPECT_FALSE(editor.isVisible());
  QTest::keyClick(&shown.window, Qt::Key_B, Qt::ControlModifier);
  EXPECT_TRUE(editor.isVisible());
}

TEST(MainWindow, ACommandThatLacksUnsavedEditsSaysSo) {
  Shown shown;
  shown.window.open({shown.scene("one.toml")});
  Project& project = *shown.window.current();
  auto* const copy = find<QPushButton>(*project.solve_page(), "copy_command");
  copy->click();
  EXPECT_FALSE(project.messages()->isVisible());
  QTest::keyClicks(project.editor(), "# x");
  copy->click();
  EXPECT_TRUE(project.messages()->isVisible());
  EXPECT_THAT(project.messages()->text().toStdString(), testing::HasSubstr("edits since are not in it"));
}

TEST(MainWindow, ItsLayoutIsKept) {
  {
    Shown shown;
    shown.window.resize(777, 555);
    shown.window.close();
  }
  EXPECT_EQ(MainWindow().size(), QSize(777, 555));
}

TEST(MainWindow, EveryWidgetHasANameForScreenReaders) {
  Shown shown;
  EXPECT_EQ(without_accessible_name(shown.window), QStringList());
  shown.window.open({shown.scene("one.toml")});
  Project& project = *shown.window.current();
  for (int page = 0; page < project.pages()->count(); ++page) {
    project.pages()->setCurrentIndex(page);
    for (int result = 0; result < project.solve_page()->results()->count(); ++result) {
      project.solve_page()->results()->setCurrentIndex(result);
      EXPECT_EQ(without_accessible_name(shown.window), QStringList());
    }
  }
}

TEST(MainWindow, EveryMenuEntryIsReachedByKeyboard) {
  Shown shown;
  for (const QAction* menu : shown.window.menuBar()->actions()) {
    EXPECT_TRUE(menu->text().contains('&')) << menu->text().toStdString();
    for (const QAction* action : menu->menu()->actions()) {
      EXPECT_TRUE(action->isSeparator() || action->text().contains('&')) << action->text().toStdString();
    }
  }
}

TEST(MainWindow, IsReadableInLightAndDark) {
  Shown shown;
  shown.window.open({shown.scene("one.toml", "nonsense = 1\n")});
  for (const Theme theme : {Theme::light, Theme::dark}) {
    shown.window.set_theme(theme);
    QApplication::processEvents();
    const QImage image = shown.window.grab().toImage();
    EXPECT_EQ(theme_of(shown.window.palette()), theme);
    EXPECT_GT(colours_in(image), 20);
  }
  shown.window.set_theme(Theme::light);
}

}  // namespace
}  // namespace jointid::gui
