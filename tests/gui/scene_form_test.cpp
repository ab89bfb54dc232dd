#include "gui/forms/scene_form.hpp"

#include <gmock/gmock.h>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTextDocument>

#include "gui/forms/field.hpp"
#include "gui/forms/field_hints.hpp"
#include "gui/forms/list_completer.hpp"
#include "gui/main_window.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/scene/scene_words.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

const char* const commented = R"(# of rig one
title = "rig"  # its name
[data]
substructures = ["a.uff", "b.uff"]
assembly = ["c.uff"]  # on Monday

[joint]
dofs = ["1:+Y", "2:+Y"]

[joint.stiffness]
pattern = "symmetric"
)";

/// A window with a scene, its form in front.
struct Form {
  QTemporaryDir folder;
  MainWindow window;

  explicit Form(const std::string& text = commented) {
    window.resize(1000, 700);
    window.show();
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    write_file(folder.filePath("scene.toml"), text);
    window.open({folder.filePath("scene.toml")});
    QTest::keyClick(&window, Qt::Key_F4);
  }
  ~Form() { editor().document()->setModified(false); }
  SceneEditor& editor() { return *window.current()->editor(); }
  std::string text() { return editor().text(); }
  Field& field(const char* table, const char* key) { return *window.current()->form()->field(table, key); }
  QLineEdit& line(const char* table, const char* key) { return *qobject_cast<QLineEdit*>(field(table, key).input()); }
  QComboBox& choice(const char* table, const char* key) { return *qobject_cast<QComboBox*>(field(table, key).input()); }
  void type(QLineEdit& line, const char* text) {
    line.setFocus();
    line.selectAll();
    QTest::keyClicks(&line, text);
  }
};

TEST(SceneForm, HasAFieldForEveryKeyThatTheReaderKnows) {
  Form form;
  for (const std::string& table : all_tables()) {
    if (table == "data.files") continue;  // its keys are files
    EXPECT_FALSE(keys_of(table).empty()) << table;
    for (const std::string& key : keys_of(table)) {
      EXPECT_NE(form.window.current()->form()->field(table, key), nullptr) << table << " " << key;
      EXPECT_FALSE(hint_of(table, key).isEmpty()) << table << " " << key;
    }
    EXPECT_NE(title_of(table).toStdString(), table);
  }
}

TEST(SceneForm, ShowsTheText) {
  Form form;
  EXPECT_EQ(form.line("", "title").text(), "rig");
  EXPECT_EQ(form.line("data", "substructures").text(), "a.uff, b.uff");
  EXPECT_EQ(form.line("joint", "dofs").text(), "1:+Y, 2:+Y");
  EXPECT_EQ(form.choice("joint.stiffness", "pattern").currentText(), "symmetric");
  EXPECT_EQ(form.choice("identify", "method").currentText(), "default");
  form.editor().replace_text(form.text() + "[identify]\nmethod = \"one\"\n");
  EXPECT_EQ(form.choice("identify", "method").currentText(), "one");
}

TEST(SceneForm, EditsAreThoseOfTheTextAndCommentsStay) {
  Form form;
  form.type(form.line("", "title"), "rig two");
  form.type(form.line("frequency", "range"), "400, 1000");
  QTest::keyClick(&form.line("frequency", "range"), Qt::Key_Return);
  std::string wanted = commented;
  wanted.replace(wanted.find("\"rig\""), 5, "\"rig two\"");
  EXPECT_EQ(form.text(), wanted + "\n[frequency]\nrange = [400, 1000]\n");
  ASSERT_TRUE(form.window.current()->checked().scene);
  EXPECT_EQ(*form.window.current()->checked().scene->frequency.range_hz, (ident::Range{400.0, 1000.0}));
}

TEST(SceneForm, AChoiceIsMadeByKeys) {
  Form form;
  QComboBox& method = form.choice("identify", "method");
  method.setFocus();
  QTest::keyClick(&method, Qt::Key_L);
  EXPECT_THAT(form.text(), testing::EndsWith("\n[identify]\nmethod = \"likelihood\"\n"));
  QTest::keyClick(&method, Qt::Key_Home);
  EXPECT_EQ(form.text(), commented);
}

/// Undo of the form, the text and the pages is one.
TEST(SceneForm, UndoIsThatOfTheText) {
  Form form;
  form.type(form.line("", "title"), "x");
  form.type(form.line("data", "assembly"), "d.uff");
  QTest::keyClick(&form.line("data", "assembly"), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(form.line("data", "assembly").text(), "c.uff");
  EXPECT_EQ(form.line("", "title").text(), "x");
  QTest::keyClick(&form.line("data", "assembly"), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(form.text(), commented);
  EXPECT_EQ(form.line("", "title").text(), "rig");
  QTest::keySequence(&form.line("data", "assembly"), QKeySequence(QKeySequence::Redo));
  EXPECT_EQ(form.line("", "title").text(), "x");
}

TEST(SceneForm, WhatIsTypedIsSaved) {
  Form form;
  form.type(form.line("", "title"), "typed");
  QTest::keyClick(&form.line("", "title"), Qt::Key_S, Qt::ControlModifier);
  EXPECT_THAT(read_file(form.folder.filePath("scene.toml")), testing::HasSubstr("title = \"typed\"  # its name"));
}

TEST(SceneForm, WhatIsWrongStandsAtItsField) {
  Form form;
  form.type(form.line("joint", "dofs"), "1:+Y, 2:+Q");
  QTest::keyClick(&form.line("joint", "dofs"), Qt::Key_Return);
  EXPECT_THAT(form.field("joint", "dofs").error().toStdString(), testing::HasSubstr("2:+Q"));
  EXPECT_TRUE(form.field("data", "assembly").error().isEmpty());
  form.line("", "title").setFocus();
  QTest::keyClick(&form.window, Qt::Key_F8);
  EXPECT_TRUE(form.line("joint", "dofs").hasFocus());
  QTest::keyClick(&form.line("joint", "dofs"), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(form.field("joint", "dofs").error().isEmpty());
}

TEST(SceneForm, WhatIsMissingStandsAtItsTable) {
  Form form("[data]\nassembly = [\"c.uff\"]\n");
  QLabel* shown = nullptr;
  for (QLabel* label : form.window.current()->form()->findChildren<QLabel*>("section_error")) {
    if (!label->isHidden()) shown = label;
  }
  ASSERT_NE(shown, nullptr);
  EXPECT_THAT(shown->text().toStdString(), testing::HasSubstr("substructures"));
}

TEST(SceneForm, TablesInOneLineAreFieldsOfTheTableAbove) {
  const std::string start = "[identify]\nstart = { stiffness = [[1, 2], [2, 3]] }\n";
  Form form(commented + start);
  EXPECT_EQ(form.line("identify", "start").text(), "{ stiffness = [[1, 2], [2, 3]] }");
  EXPECT_FALSE(form.field("identify.start", "stiffness").isVisible());
  form.editor().replace_text(commented + std::string("[identify.start]\nstiffness = [[1, 2], [2, 3]]\n"));
  EXPECT_FALSE(form.field("identify", "start").isVisible());
  EXPECT_EQ(form.line("identify.start", "stiffness").text(), "[[1, 2], [2, 3]]");
}

const char* const two_joints = R"([data]
substructures = ["a.uff", "b.uff"]
assembly = ["c.uff"]

[[joints]]
name = "left"
dofs = ["1:+X", "2:+X"]
[joints.stiffness]
pattern = "full"

[[joints]]  # the other one
name = "right"
dofs = ["3:+X", "4:+X"]
[joints.mass]
pattern = "diagonal"

[identify]
method = "one"
)";

TEST(SceneForm, OneOfSeveralJointsIsShownAndEdited) {
  Form form(two_joints);
  QComboBox& chosen = *find<QComboBox>(*form.window.current()->form(), "joint_choice");
  ASSERT_EQ(chosen.count(), 2);
  EXPECT_EQ(chosen.itemText(1), "2: right");
  EXPECT_EQ(form.line("joint", "dofs").text(), "1:+X, 2:+X");
  EXPECT_EQ(form.choice("joint.stiffness", "pattern").currentText(), "full");
  chosen.setFocus();
  QTest::keyClick(&chosen, Qt::Key_Down);
  EXPECT_EQ(form.line("joints", "name").text(), "right");
  EXPECT_EQ(form.line("joint", "dofs").text(), "3:+X, 4:+X");
  EXPECT_EQ(form.choice("joint.mass", "pattern").currentText(), "diagonal");
  form.type(form.line("joint", "bands"), "[[10, 20]]");
  QTest::keyClick(&form.line("joint", "bands"), Qt::Key_Return);
  form.choice("joint.stiffness", "pattern").setFocus();
  QTest::keyClick(&form.choice("joint.stiffness", "pattern"), Qt::Key_S);
  std::string wanted = two_joints;
  wanted.replace(wanted.find("dofs = [\"3"), 24, "dofs = [\"3:+X\", \"4:+X\"]\nbands = [[10, 20]]\n");
  wanted.replace(wanted.find("pattern = \"diagonal\"\n"), 21, "pattern = \"diagonal\"\n\n[joints.stiffness]\npattern = \"symmetric\"\n");
  EXPECT_EQ(form.text(), wanted);
  ASSERT_TRUE(form.window.current()->checked().scene) << form.window.current()->checked().error->problem;
  EXPECT_EQ(form.window.current()->checked().scene->joints[1].matrices.size(), 2U);
}

TEST(SceneForm, JointsAreAddedAndRemoved) {
  Form form;
  QPushButton& add = *find<QPushButton>(*form.window.current()->form(), "joint_choice_add");
  QPushButton& remove = *find<QPushButton>(*form.window.current()->form(), "joint_choice_remove");
  EXPECT_FALSE(remove.isEnabled());
  add.setFocus();
  QTest::keyClick(&add, Qt::Key_Space);
  EXPECT_EQ(form.line("joints", "name").text(), "joint2");
  form.type(form.line("joint", "dofs"), "3:+Y, 4:+Y");
  QTest::keyClick(&form.line("joint", "dofs"), Qt::Key_Return);
  ASSERT_TRUE(form.window.current()->checked().scene) << form.window.current()->checked().error->problem;
  EXPECT_EQ(form.window.current()->checked().scene->joints.size(), 2U);
  EXPECT_EQ(form.window.current()->checked().scene->joints[0].name, "joint1");
  remove.setFocus();
  QTest::keyClick(&remove, Qt::Key_Space);
  ASSERT_TRUE(form.window.current()->checked().scene);
  EXPECT_EQ(form.window.current()->checked().scene->joints.size(), 1U);
  for (int i = 0; i < 3; ++i) QTest::keyClick(&form.window, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(form.text(), commented);
}

TEST(SceneForm, TheJointThatIsWrongIsShown) {
  std::string text = two_joints;
  text.replace(text.find("4:+X"), 4, "4:+Q");
  Form form(text);
  EXPECT_EQ(form.line("joints", "name").text(), "right");
  EXPECT_THAT(form.field("joint", "dofs").error().toStdString(), testing::HasSubstr("4:+Q"));
}

/// Of which there are none at first, and the first is written by its button.
TEST(SceneForm, GainsAreAddedFilledInAndRemoved) {
  Form form;
  QComboBox& choice = *find<QComboBox>(*form.window.current()->form(), "data.gains_choice");
  QPushButton& add = *find<QPushButton>(*form.window.current()->form(), "data.gains_choice_add");
  QPushButton& remove = *find<QPushButton>(*form.window.current()->form(), "data.gains_choice_remove");
  EXPECT_EQ(choice.count(), 0);
  EXPECT_FALSE(remove.isEnabled());
  EXPECT_TRUE(form.field("data.gains", "gain").isHidden());
  EXPECT_TRUE(form.field("data", "gains").isHidden());
  add.setFocus();
  QTest::keyClick(&add, Qt::Key_Space);
  EXPECT_FALSE(form.field("data.gains", "gain").isHidden());
  QTest::keyClick(&add, Qt::Key_Space);
  ASSERT_EQ(choice.count(), 2);
  form.type(form.line("data.gains", "dofs"), "1:+Y");
  form.type(form.line("data.gains", "files"), "a.uff, c.uff");
  QTest::keyClick(&form.line("data.gains", "files"), Qt::Key_Return);
  EXPECT_EQ(choice.currentText(), "2: 1:+Y");
  form.choice("data.gains", "shared").setFocus();
  QTest::keyClick(&form.choice("data.gains", "shared"), Qt::Key_N);
  std::string wanted = commented;
  wanted.insert(wanted.find("\n[joint]"),
                "\n[[data.gains]]\ngain = 0.01\n\n[[data.gains]]\ngain = 0.01\n"
                "dofs = [\"1:+Y\"]\nfiles = [\"a.uff\", \"c.uff\"]\nshared = \"none\"\n");
  EXPECT_EQ(form.text(), wanted);
  ASSERT_TRUE(form.window.current()->checked().scene) << form.window.current()->checked().error->problem;
  EXPECT_EQ(form.window.current()->checked().scene->data.gains.size(), 2U);
  for (int i = 0; i < 2; ++i) QTest::keyClick(&remove, Qt::Key_Space);
  EXPECT_EQ(form.text(), commented);
}

TEST(SceneForm, WhatIsWrongInOneOfSeveralIsShownThere) {
  const std::string masses =
      "\n[[data.masses]]\ndofs = [\"1:+Y\"]\nfiles = [\"a.uff\"]\nmass = 0.003\n"
      "\n[[data.masses]]\ndofs = [\"2:+Y\"]\nfiles = [\"none\"]\nmass = 0.1\n";
  Form form(commented + masses);
  EXPECT_EQ(find<QComboBox>(*form.window.current()->form(), "data.masses_choice")->currentText(), "2: 2:+Y");
  EXPECT_THAT(form.field("data.masses", "files").error().toStdString(), testing::HasSubstr("none"));
  form.type(form.line("data.masses", "files"), "b");
  EXPECT_EQ(form.line("data.masses", "files").completer()->currentCompletion(), "b.uff");
  form.type(form.line("data.masses", "files"), "b.uff");
  QTest::keyClick(&form.line("data.masses", "files"), Qt::Key_Return);
  ASSERT_TRUE(form.window.current()->checked().scene) << form.window.current()->checked().error->problem;
  EXPECT_TRUE(form.field("data.masses", "files").error().isEmpty());
}

/// Where the text has them as the value of a key they are a field of their table.
TEST(SceneForm, SeveralTablesInOneValueAreAField) {
  std::string text = commented;
  text.insert(text.find("\n[joint]"), "gains = [{ gain = 0.02 }]\n");
  Form form(text);
  EXPECT_EQ(form.line("data", "gains").text(), "[{ gain = 0.02 }]");
  EXPECT_TRUE(form.field("data.gains", "gain").isHidden() || form.field("data.gains", "gain").parentWidget()->isHidden());
}

TEST(SceneForm, WhatAFileDoesNotSayIsFilledInFileByFile) {
  Form form;
  QComboBox& file = *find<QComboBox>(*form.window.current()->form(), "file_choice");
  ASSERT_EQ(file.count(), 3);
  file.setFocus();
  QTest::keyClick(&file, Qt::Key_End);
  ASSERT_EQ(file.currentText(), "c.uff");
  form.type(form.line("data.files.*", "flip"), "1:+Y");
  QTest::keyClick(&form.line("data.files.*", "flip"), Qt::Key_Return);
  EXPECT_EQ(form.text(), commented + std::string("\n[data.files.\"c.uff\"]\nflip = [\"1:+Y\"]\n"));
  ASSERT_TRUE(form.window.current()->checked().scene);
  EXPECT_EQ(form.window.current()->checked().scene->data.assembly.front().corrections.flip.size(), 1U);
  file.setFocus();
  QTest::keyClick(&file, Qt::Key_Home);
  EXPECT_EQ(form.line("data.files.*", "flip").text(), "");
  form.editor().replace_text(form.text() + "gain = 0\n");
  EXPECT_EQ(file.currentText(), "c.uff");
  EXPECT_FALSE(form.field("data.files.*", "gain").error().isEmpty());
}

TEST(SceneForm, CellsOfASpreadsheetArePastedIntoAMatrix) {
  Form form;
  QApplication::clipboard()->setText("1e6\t-1e6\n-1e6\t1e6\n");
  QLineEdit& truth = form.line("truth", "stiffness");
  truth.setFocus();
  QTest::keyClick(&truth, Qt::Key_V, Qt::ControlModifier);
  QTest::keyClick(&truth, Qt::Key_Return);
  EXPECT_THAT(form.text(), testing::EndsWith("[truth]\nstiffness = [[1e6, -1e6], [-1e6, 1e6]]\n"));
}

TEST(SceneForm, TheLastNameOfAListIsCompleted) {
  QLineEdit line;
  ListCompleter completer(line, "names");
  completer.set_words({"1:+X", "2:+X"});
  line.setText("1:+X, 2");
  EXPECT_EQ(completer.splitPath(line.text()), QStringList{"2"});
  EXPECT_EQ(completer.pathFromIndex(completer.model()->index(1, 0)), "1:+X, 2:+X");
}

const char* const of_levels = R"(title = "one mass"
[data]
parts = ["part.h5"]
[[data.levels]]
name = "0.5 N"
harmonics = [1, 3]
[[data.levels]]
name = "2 N"
responses = "level # 2.h5"  # measured twice
sweep = true
harmonics = [
  1,
  3,
]
[[joint.friction]]
name = "joint"
dofs = ["1:+Y"]
law = ["ren", "iwan"]
)";

/// Every table and key that the text has, each as it is written; an edit is one of the text, comments stay.
TEST(SceneForm, OfAnotherKindShowsWhatTheTextHas) {
  Form form(of_levels);
  EXPECT_EQ(form.line("", "title").text(), "one mass");
  EXPECT_EQ(form.line("data", "parts").text(), "part.h5");
  EXPECT_EQ(form.line("data.levels#1", "name").text(), "0.5 N");
  EXPECT_EQ(form.line("data.levels#2", "responses").text(), "level # 2.h5");
  EXPECT_EQ(form.choice("data.levels#2", "sweep").currentText(), "true");
  EXPECT_EQ(form.line("joint.friction#1", "law").text(), "ren, iwan");
  EXPECT_EQ(form.window.current()->form()->field("data", "substructures"), nullptr);
  form.type(form.line("data.levels#2", "name"), "4 N\r");
  form.type(form.line("joint.friction#1", "law"), "bilinear, iwan\r");
  EXPECT_THAT(form.text(), testing::HasSubstr("name = \"4 N\"\nresponses = \"level # 2.h5\"  # measured twice\n"));
  EXPECT_THAT(form.text(), testing::HasSubstr("law = [\"bilinear\", \"iwan\"]\n"));
}

/// A key that is left out takes its field with it; one that the text gets, and another kind of scene, get theirs.
TEST(SceneForm, OfAnotherKindFollowsTheText) {
  Form form(of_levels);
  form.type(form.line("data.levels#1", "name"), "\b\r");
  EXPECT_EQ(form.window.current()->form()->field("data.levels#1", "name"), nullptr);
  EXPECT_EQ(form.line("data.levels#2", "name").text(), "2 N");
  QTest::keyClick(&form.window, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(form.text(), of_levels);
  EXPECT_EQ(form.line("data.levels#1", "name").text(), "0.5 N");
  form.editor().replace_text(commented);
  EXPECT_EQ(form.line("data", "substructures").text(), "a.uff, b.uff");
}

TEST(SceneForm, EveryFieldIsReachedByTabAndHasAName) {
  Form form;
  EXPECT_EQ(without_accessible_name(form.window), QStringList());
  for (QWidget* field : form.window.current()->form()->findChildren<QWidget*>()) {
    const QString name = field->objectName();
    if (name != "field_line" && name != "field_choice" && name != "choose_files") continue;
    EXPECT_TRUE((field->focusPolicy() & Qt::TabFocus) != 0) << field->accessibleName().toStdString();
  }
  EXPECT_TRUE(form.line("data", "substructures").hasFocus());
  QTest::keyClick(&form.line("data", "substructures"), Qt::Key_Tab);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  EXPECT_TRUE(form.line("data", "assembly").hasFocus());
}

}  // namespace
}  // namespace jointid::gui
