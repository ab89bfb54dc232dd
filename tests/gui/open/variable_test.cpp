#include <gmock/gmock.h>

#include <QComboBox>
#include <QTest>
#include <QTextDocument>

#include "gui/data/data_page.hpp"
#include "gui/main_window.hpp"
#include "gui/open/variable_dialog.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_editor.hpp"
#include "../widgets.hpp"

/// Files of MATLAB and its relatives in which several variables may be the FRFs.
namespace jointid::gui {
namespace {

using testing::HasSubstr;

std::string column(const char* name, const char* type, const std::vector<std::string>& rows) {
  std::string text = std::string("# name: ") + name + "\n# type: " + type + "\n# rows: " + std::to_string(rows.size()) + "\n# columns: 1\n";
  for (const std::string& row : rows) text += " " + row + "\n";
  return text + "\n\n";
}

std::string word(const char* name, const std::string& text) {
  const std::string length = std::to_string(text.size());
  return std::string("# name: ") + name + "\n# type: string\n# elements: 1\n# length: " + length + "\n" + text + "\n\n\n";
}

/// Two FRFs, of before and after.
std::string two_variables() {
  return "# Created by Octave 7.3.0\n" + column("f", "matrix", {"10", "20", "30"}) +
         column("before", "complex matrix", {"(1,0.5)", "(2,0.5)", "(3,0.5)"}) +
         column("after", "complex matrix", {"(4,0.5)", "(5,0.5)", "(6,0.5)"}) + word("response_dof", "1:+Z") +
         word("reference_dof", "1:+Z") + word("quantity", "receptance");
}

TEST(Variables, AreAChoiceInPlaceOfAnError) {
  QTemporaryDir folder;
  write_file(folder.filePath("two.mat"), two_variables());
  MainWindow window;
  window.show();
  window.open({folder.filePath("two.mat")});
  VariableDialog* dialog = nullptr;
  ASSERT_TRUE(QTest::qWaitFor([&] { return (dialog = window.findChild<VariableDialog*>()) != nullptr; }, 10000));
  auto* const box = find<QComboBox>(*dialog, "variable_of_file");
  ASSERT_EQ(box->count(), 2);
  EXPECT_EQ(window.count(), 0);
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Down);
  QTest::keyClick(dialog, Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.count() == 1; }, 10000));
  Project& project = *window.current();
  EXPECT_THAT(project.editor()->text(), HasSubstr("variable = \"after\""));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !project.data_page()->files().empty(); }, 10000));
  EXPECT_EQ(project.data_page()->files().front().error, "");
  project.editor()->document()->setModified(false);
}

}  // namespace
}  // namespace jointid::gui
