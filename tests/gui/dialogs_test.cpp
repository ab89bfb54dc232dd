#include <gmock/gmock.h>

#include <QApplication>
#include <QMessageBox>
#include <QPointer>
#include <QTest>
#include <QTextDocument>
#include <QTimer>
#include <functional>

#include "gui/main_window.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_editor.hpp"
#include "widgets.hpp"

/// Dialogs are opened, answered and left by keys alone.
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
    for (Project* project : window.findChildren<Project*>()) project->editor()->document()->setModified(false);
  }
  QString file(const char* name) const { return folder.filePath(name); }
  Project& open(const std::string& text = small_scene) {
    write_file(file("scene.toml"), text);
    window.open({file("scene.toml")});
    return *window.current();
  }
  /// Does this to the dialog that is going to be open; a dialog that is still there afterwards is left by Escape.
  void next(const std::function<void(QWidget&)>& act) {
    auto* const poll = new QTimer(&window);
    QObject::connect(poll, &QTimer::timeout, &window, [this, poll, act] {
      const QPointer<QWidget> dialog = QApplication::activeModalWidget();
      if (dialog.isNull() || !dialog->isVisible()) return;
      poll->stop();
      dialog->activateWindow();
      EXPECT_TRUE(QTest::qWaitForWindowActive(dialog));
      ++answered;
      act(*dialog);
      if (!dialog.isNull() && dialog->isVisible()) QTest::keyClick(dialog, Qt::Key_Escape);
    });
    poll->start(10);
  }
  /// A key of the window, which a dialog that was open may have left inactive.
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    QTest::keyClick(&window, key, modifiers);
  }
};

TEST(Dialogs, EscapeOpensNothing) {
  Keys keys;
  keys.next([](QWidget& dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); });
  keys.press(Qt::Key_O, Qt::ControlModifier);
  EXPECT_EQ(keys.answered, 1);
  EXPECT_EQ(keys.window.count(), 0);
}

/// Enter saves, Escape stays.
TEST(Dialogs, UnsavedChangesAreAskedAbout) {
  Keys keys;
  QTest::keyClicks(keys.open().editor(), "# x");
  keys.next([](QWidget& dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); });
  keys.press(Qt::Key_W, Qt::ControlModifier);
  ASSERT_EQ(keys.window.count(), 1);
  keys.next([](QWidget& dialog) { QTest::keyClick(&dialog, Qt::Key_Return); });
  keys.press(Qt::Key_W, Qt::ControlModifier);
  ASSERT_EQ(keys.window.count(), 0);
  EXPECT_THAT(read_file(keys.file("scene.toml")), testing::StartsWith("# x"));
  EXPECT_EQ(keys.answered, 2);
}

TEST(Dialogs, AboutIsReadAndLeft) {
  Keys keys;
  QString text;
  keys.next([&](QWidget& dialog) {
    text = static_cast<QMessageBox&>(dialog).text();
    QTest::keyClick(&dialog, Qt::Key_Return);
  });
  keys.press(Qt::Key_H, Qt::AltModifier);
  ASSERT_NE(QApplication::activePopupWidget(), nullptr);
  QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_A);
  EXPECT_EQ(keys.answered, 1);
  EXPECT_THAT(text.toStdString(), testing::HasSubstr("QCustomPlot"));
}

}  // namespace
}  // namespace jointid::gui
