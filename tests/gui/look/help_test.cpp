#include <gmock/gmock.h>

#include <QApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QWhatsThis>

#include "../widgets.hpp"
#include "gui/begin/example_dialog.hpp"
#include "gui/help/help_keys.hpp"
#include "gui/help/help_window.hpp"
#include "gui/joint/joint_assistant.hpp"
#include "gui/main_window.hpp"
#include "gui/open/variable_dialog.hpp"

namespace jointid::gui {
namespace {

using testing::EndsWith;

std::string source_of(const QWidget& window) {
  const auto* const help = window.findChild<HelpWindow*>();
  return help == nullptr || !help->isVisible() ? "no help" : help->browser()->source().toString().toStdString();
}

/// F1 is of the window's filter.
struct Helped {
  MainWindow window;

  void press(QDialog& dialog) {
    dialog.show();
    QTest::keyClick(dialog.focusWidget() != nullptr ? dialog.focusWidget() : &dialog, Qt::Key_F1);
  }
};

TEST(Help, F1InEveryDialogOpensItsPage) {
  Helped helped;
  ExampleDialog examples;
  helped.press(examples);
  EXPECT_THAT(source_of(examples), EndsWith("docs/problems.md"));
  VariableDialog variables({{QStringLiteral("a.mat"), {QStringLiteral("H1")}}});
  helped.press(variables);
  EXPECT_THAT(source_of(variables), EndsWith("docs/file-formats.md"));
  JointAssistant assistant({});
  helped.press(assistant);
  EXPECT_THAT(source_of(assistant), EndsWith("docs/workbench.md"));
  QFileDialog files;
  helped.press(files);
  EXPECT_THAT(source_of(files), EndsWith("docs/file-formats.md"));
  QMessageBox box(QMessageBox::Question, "Unsaved scene", "Save?", QMessageBox::Save | QMessageBox::Cancel);
  helped.press(box);
  EXPECT_THAT(source_of(box), EndsWith("docs/workbench.md"));
}

TEST(Help, OwnDialogsHaveAButtonForIt) {
  Helped helped;
  ExampleDialog examples;
  VariableDialog variables({{QStringLiteral("a.mat"), {QStringLiteral("H1")}}});
  JointAssistant assistant({});
  for (QDialog* dialog : std::initializer_list<QDialog*>{&examples, &variables, &assistant}) {
    dialog->show();
    auto* const buttons = dialog->findChild<QDialogButtonBox*>();
    ASSERT_NE(buttons, nullptr);
    ASSERT_NE(buttons->button(QDialogButtonBox::Help), nullptr) << dialog->objectName().toStdString();
    buttons->button(QDialogButtonBox::Help)->click();
    EXPECT_THAT(source_of(*dialog), EndsWith(".md"));
  }
}

TEST(Help, WhatIsThisOpensThePageOfTheWidget) {
  Helped helped;
  QWidget page;
  page.setObjectName("records_page");
  QPushButton button("x", &page);
  page.show();
  QHelpEvent asked(QEvent::QueryWhatsThis, QPoint(2, 2), QPoint(2, 2)), event(QEvent::WhatsThis, QPoint(2, 2), QPoint(2, 2));
  asked.ignore();
  EXPECT_TRUE(QApplication::sendEvent(&button, &asked));
  EXPECT_TRUE(asked.isAccepted());
  QApplication::sendEvent(&button, &event);
  EXPECT_THAT(source_of(page), EndsWith("docs/records.md"));
}

TEST(Help, AHeadingComesToTheTop) {
  HelpWindow help;
  help.show_page("workbench#Languages");
  EXPECT_EQ(help.browser()->textCursor().block().text(), "Languages");
  help.show_page("workbench#no such heading");
  EXPECT_TRUE(help.isVisible());
}

/// All pages that widgets name are there, and their headings.
TEST(Help, EveryPageAndHeadingIsThere) {
  for (const char* name :
       {"modal_page",    "couple_page", "loading_curve_page", "response_page",  "laws_page",      "oscillate_page",
        "records_page",  "lines_page",  "compare_page",       "study_page",     "plan_page",      "data_page",
        "geometry_page", "solve_page",  "iterations",         "worth",          "matrix",         "bounds",
        "scene_editor",  "scene_form",  "joint_assistant",    "example_dialog", "variable_dialog"}) {
    QWidget widget;
    widget.setObjectName(QString::fromLatin1(name));
    const QString place = help_of(&widget);
    const QString page = place.section('#', 0, 0), heading = place.section('#', 1);
    EXPECT_TRUE(QFile::exists(":/docs/" + page + ".md")) << name;
    if (heading.isEmpty()) continue;
    HelpWindow help;
    help.show_page(place);
    EXPECT_EQ(help.browser()->textCursor().block().text(), heading) << name;
  }
}

}  // namespace
}  // namespace jointid::gui
