#include "gui/scene/scene_editor.hpp"

#include <gmock/gmock.h>

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QTextBlock>

#include "gui/scene/annotated_layout.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

struct Edited {
  SceneEditor editor;

  explicit Edited(const char* text) {
    editor.resize(500, 300);
    editor.setPlainText(QString::fromUtf8(text));
    editor.show();
    editor.moveCursor(QTextCursor::End);
  }
  void type(const char* text) { QTest::keyClicks(&editor, QString::fromLatin1(text)); }
  /// The list of completions, a window of its own, or nothing.
  static QWidget* popup() {
    for (QWidget* window : QApplication::topLevelWidgets()) {
      if (window->objectName() == "completions" && window->isVisible()) return window;
    }
    return nullptr;
  }
};

TEST(SceneEditor, TellsWhenNothingIsTypedForAMoment) {
  Edited edited("");
  QSignalSpy settled(&edited.editor, &SceneEditor::settled);
  edited.type("title");
  EXPECT_EQ(settled.count(), 0);
  ASSERT_TRUE(settled.wait(3000));
  EXPECT_EQ(settled.count(), 1);
}

TEST(SceneEditor, MakesRoomForAnErrorBelowItsLine) {
  Edited edited("one\ntwo\nthree");
  const auto top = [&](int line) {
    return edited.editor.cursorRect(QTextCursor(edited.editor.document()->findBlockByNumber(line))).top();
  };
  const int before = top(2) - top(1);
  edited.editor.set_error(SceneError{2, "two is too many", "write one"});
  EXPECT_GT(top(2) - top(1), before + 10);
  EXPECT_EQ(top(1) - top(0), before);
  edited.editor.set_error({});
  EXPECT_EQ(top(2) - top(1), before);
}

TEST(SceneEditor, AnErrorOfALineThatIsNoMoreIsBorne) {
  Edited edited("one");
  edited.editor.set_error(SceneError{50, "gone", ""});
  edited.editor.grab();
  edited.editor.clear();
  edited.editor.grab();
}

TEST(SceneEditor, CompletesTablesKeysAndWordsByKeyboard) {
  Edited edited("[joint.sti");
  QTest::keyClick(&edited.editor, Qt::Key_Space, Qt::ControlModifier);
  ASSERT_NE(edited.popup(), nullptr);
  QTest::keyClick(edited.popup(), Qt::Key_Return);
  QTest::keyClick(&edited.editor, Qt::Key_Return);
  edited.type("pa");
  ASSERT_NE(edited.popup(), nullptr);
  QTest::keyClick(edited.popup(), Qt::Key_Return);
  edited.type("\"sym");
  ASSERT_NE(edited.popup(), nullptr);
  QTest::keyClick(edited.popup(), Qt::Key_Return);
  edited.type("\"");
  EXPECT_EQ(edited.editor.text(), "[joint.stiffness]\npattern = \"symmetric\"");
}

TEST(SceneEditor, CompletesHeadersOfSeveralTables) {
  Edited edited("[[data.ga");
  QTest::keyClick(&edited.editor, Qt::Key_Space, Qt::ControlModifier);
  ASSERT_NE(edited.popup(), nullptr);
  QTest::keyClick(edited.popup(), Qt::Key_Return);
  EXPECT_EQ(edited.editor.text(), "[[data.gains]]");
  EXPECT_TRUE(Edited("[[jo").editor.completions().contains("joints"));
  EXPECT_FALSE(Edited("[data.ga").editor.completions().contains("data.gains"));
}

TEST(SceneEditor, OffersDofsWhereNoWordIsAsked) {
  Edited edited("[joint]\ndofs = [\"");
  edited.editor.set_dofs({"1:+X", "2:+X"});
  EXPECT_EQ(edited.editor.completions(), QStringList({"1:+X", "2:+X"}));
}

TEST(SceneEditor, OffersNothingInComments) {
  Edited edited("# the pa");
  EXPECT_TRUE(edited.editor.completions().isEmpty());
  edited.type("t");
  EXPECT_EQ(edited.popup(), nullptr);
}

TEST(SceneEditor, AReplacedTextIsOneStepToUndo) {
  Edited edited("a = 1\nb = 2\nc = 3\n");
  edited.editor.replace_text("a = 1\nb = 22\nc = 3\n");
  EXPECT_EQ(edited.editor.text(), "a = 1\nb = 22\nc = 3\n");
  edited.editor.undo();
  EXPECT_EQ(edited.editor.text(), "a = 1\nb = 2\nc = 3\n");
  EXPECT_FALSE(edited.editor.document()->isUndoAvailable());
}

TEST(SceneEditor, LeavesDroppedFilesToTheWindow) {
  Edited edited("");
  EXPECT_FALSE(edited.editor.acceptDrops() || edited.editor.viewport()->acceptDrops());
}

TEST(SceneEditor, TabLeavesIt) {
  Edited edited("");
  EXPECT_TRUE(edited.editor.tabChangesFocus());
}

}  // namespace
}  // namespace jointid::gui
