#include <gmock/gmock.h>

#include <QApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QMessageBox>
#include <QTabWidget>
#include <QTest>
#include <QTextDocument>
#include <QTimer>
#include <QToolButton>

#include "gui/data/data_page.hpp"
#include "gui/forms/field.hpp"
#include "gui/forms/scene_form.hpp"
#include "gui/loading_curve/loading_curve_page.hpp"
#include "gui/main_window.hpp"
#include "gui/plot/frf_plot.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/solve_page.hpp"
#include "gui/table/cell_table.hpp"
#include "widgets.hpp"

/// Every dialog is opened, answered and left by keys alone.
namespace jointid::gui {
namespace {

struct Keys {
  QTemporaryDir folder;
  MainWindow window;
  int answered = 0;

  Keys() {
    window.resize(1000, 700);
    window.show();
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
  }
  ~Keys() {
    while (window.count() > 0) {
      window.current()->editor()->document()->setModified(false);
      QTest::keyClick(&window, Qt::Key_W, Qt::ControlModifier);
    }
  }
  QString file(const char* name) const { return folder.filePath(name); }
  Project& open(const std::string& text = small_scene) {
    write_file(file("scene.toml"), text);
    window.open({file("scene.toml")});
    return *window.current();
  }
  /// Does this to the dialog that is going to be open; a dialog that is still there afterwards is left by Escape.
  void next(const std::function<void(QWidget&)>& act) {
    QTimer::singleShot(0, &window, [this, act] {
      QWidget* dialog = nullptr;
      const auto is_there = [&] { return (dialog = QApplication::activeModalWidget()) != nullptr && dialog->isVisible(); };
      if (!QTest::qWaitFor(is_there, 5000)) return;
      ++answered;
      act(*dialog);
      if (QApplication::activeModalWidget() == dialog && dialog->isVisible()) QTest::keyClick(dialog, Qt::Key_Escape);
    });
  }
  /// A name typed where the cursor is.
  void next_is_named(const QString& name) {
    next([name](QWidget& dialog) {
      auto* const line = dialog.findChild<QLineEdit*>("fileNameEdit");
      ASSERT_NE(line, nullptr);
      EXPECT_EQ(dialog.focusWidget(), line);
      line->selectAll();
      QTest::keyClicks(line, name);
      QTest::keyClick(line, Qt::Key_Return);
    });
  }
  static void press(QWidget& button) {
    button.setFocus();
    QTest::keyClick(&button, Qt::Key_Space);
  }
};

TEST(Dialogs, ASceneIsOpened) {
  Keys keys;
  write_file(keys.file("one.toml"), small_scene);
  keys.next_is_named(keys.file("one.toml"));
  QTest::keyClick(&keys.window, Qt::Key_O, Qt::ControlModifier);
  ASSERT_EQ(keys.window.count(), 1);
  EXPECT_EQ(keys.window.current()->file(), keys.file("one.toml"));
}

TEST(Dialogs, EscapeOpensNothing) {
  Keys keys;
  keys.next([](QWidget& dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); });
  QTest::keyClick(&keys.window, Qt::Key_O, Qt::ControlModifier);
  EXPECT_EQ(keys.answered, 1);
  EXPECT_EQ(keys.window.count(), 0);
}

TEST(Dialogs, ASceneIsSavedUnderAnotherName) {
  Keys keys;
  keys.open();
  keys.next_is_named(keys.file("other"));
  QTest::keyClick(&keys.window, Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(read_file(keys.file("other.toml")), small_scene);
  EXPECT_EQ(keys.window.current()->file(), keys.file("other.toml"));
}

/// Enter saves, Escape stays, and the arrow keys reach the third answer.
TEST(Dialogs, UnsavedChangesAreAskedAbout) {
  Keys keys;
  QTest::keyClicks(keys.open().editor(), "# x");
  keys.next([](QWidget& dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); });
  QTest::keyClick(&keys.window, Qt::Key_W, Qt::ControlModifier);
  ASSERT_EQ(keys.window.count(), 1);
  keys.next([](QWidget& dialog) { QTest::keyClick(&dialog, Qt::Key_Return); });
  QTest::keyClick(&keys.window, Qt::Key_W, Qt::ControlModifier);
  ASSERT_EQ(keys.window.count(), 0);
  EXPECT_THAT(read_file(keys.file("scene.toml")), testing::StartsWith("# x"));
  QTest::keyClicks(keys.open().editor(), "# y");
  keys.next([](QWidget& dialog) {
    QAbstractButton* const discard = static_cast<QMessageBox&>(dialog).button(QMessageBox::Discard);
    for (int i = 0; i < 3 && !discard->hasFocus(); ++i) QTest::keyClick(dialog.focusWidget(), Qt::Key_Tab);
    ASSERT_TRUE(discard->hasFocus());
    QTest::keyClick(discard, Qt::Key_Space);
  });
  QTest::keyClick(&keys.window, Qt::Key_W, Qt::ControlModifier);
  EXPECT_EQ(keys.window.count(), 0);
  EXPECT_EQ(keys.answered, 3);
  EXPECT_EQ(read_file(keys.file("scene.toml")), small_scene);
}

TEST(Dialogs, AboutIsReadAndLeft) {
  Keys keys;
  QString text;
  keys.next([&](QWidget& dialog) {
    text = static_cast<QMessageBox&>(dialog).text();
    QTest::keyClick(&dialog, Qt::Key_Return);
  });
  QTest::keyClick(&keys.window, Qt::Key_H, Qt::AltModifier);
  ASSERT_NE(QApplication::activePopupWidget(), nullptr);
  QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_A);
  EXPECT_EQ(keys.answered, 1);
  EXPECT_THAT(text.toStdString(), testing::HasSubstr("QCustomPlot"));
}

TEST(Dialogs, FilesAreChosenInTheForm) {
  Keys keys;
  Project& project = keys.open();
  write_file(keys.file("more.uff"), "");
  project.switch_view(true);
  keys.next_is_named(keys.file("more.uff"));
  Keys::press(*find<QToolButton>(*project.form()->field("data", "assembly"), "choose_files"));
  EXPECT_THAT(project.editor()->text(), testing::HasSubstr("assembly = [\"c.uff\", \"more.uff\"]"));
}

TEST(Dialogs, PlotsTablesAndResultsAreSaved) {
  const Measured measured("A1");
  Keys keys;
  keys.window.open({measured.scene()});
  Project& project = *keys.window.current();
  project.pages()->setCurrentWidget(project.solve_page());
  project.solve_page()->solve();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !project.solve_page()->runs().empty() && !project.solve_page()->is_busy(); }, 60000));
  project.solve_page()->results()->setCurrentWidget(project.solve_page()->unknowns());
  const auto saves = [&](const char* name, const std::function<void()>& act) {
    keys.next_is_named(keys.file(name));
    act();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !read_file(keys.file(name)).empty(); }, 20000)) << name;
  };
  saves("a.json", [&] { Keys::press(*find<QPushButton>(*project.solve_page(), "save_json")); });
  saves("a.html", [&] { Keys::press(*find<QPushButton>(*project.solve_page(), "save_report")); });
  saves("a.csv", [&] { QTest::keyClick(project.solve_page()->unknowns(), Qt::Key_E, Qt::ControlModifier); });
  project.pages()->setCurrentWidget(project.data_page());
  saves("a.svg", [&] { Keys::press(*find<QToolButton>(*project.data_page()->plot(), "plot_save")); });
  EXPECT_EQ(keys.answered, 4);
}

TEST(Dialogs, CurvesAreChosen) {
  Keys keys;
  Project& project = keys.open();
  write_file(keys.file("curve.csv"), "displacement_m,force_N\n0,0\n1e-6,1\n");
  project.pages()->setCurrentWidget(project.loading_curve_page());
  keys.next_is_named(keys.file("curve.csv"));
  Keys::press(*find<QPushButton>(*project.loading_curve_page(), "curve_files"));
  EXPECT_EQ(keys.answered, 1);
  EXPECT_TRUE(find<QPushButton>(*project.loading_curve_page(), "curve_fit")->isEnabled() || project.loading_curve_page()->is_busy());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !project.loading_curve_page()->is_busy(); }, 10000));
}

}  // namespace
}  // namespace jointid::gui
