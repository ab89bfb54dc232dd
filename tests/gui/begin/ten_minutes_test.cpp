#include <gmock/gmock.h>

#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QPushButton>
#include <QRegularExpression>
#include <QTest>
#include <QTextDocument>
#include <QTreeWidget>

#include "../widgets.hpp"
#include "gui/data/data_page.hpp"
#include "gui/main_window.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_editor.hpp"

/// docs/tutorials/ten-minutes.md, which is in the program.
namespace jointid::gui {
namespace {

QString page() {
  QFile file(QStringLiteral(":/docs/tutorials/ten-minutes.md"));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// As the file of translations has them, without the marks of keys.
QStringList texts_of_program() {
  QFile file(QStringLiteral(JOINTID_TEXTS));
  if (!file.open(QIODevice::ReadOnly)) return {};
  QStringList out;
  static const QRegularExpression source(QStringLiteral("<source>([^<]*)</source>"));
  for (auto found = source.globalMatch(QString::fromUtf8(file.readAll())); found.hasNext();)
    out << found.next().captured(1).replace(QStringLiteral("&amp;"), QString());
  return out;
}

TEST(TenMinutes, EveryLabelOfThePageIsInTheProgram) {
  const QStringList texts = texts_of_program();
  ASSERT_GT(texts.size(), 500);
  static const QRegularExpression bold(QStringLiteral("\\*\\*([^*]+)\\*\\*"));
  int labels = 0;
  for (auto found = bold.globalMatch(page()); found.hasNext(); ++labels) {
    const QString label = found.next().captured(1);
    EXPECT_TRUE(texts.contains(label)) << label.toStdString();
  }
  EXPECT_GT(labels, 12);
}

TEST(TenMinutes, ItsStepsLeadToTheJoint) {
  const Measured bolts("bolts", "uff");
  MainWindow window;
  window.resize(1280, 800);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  window.open(bolts.files());
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.count() == 1 && !window.current()->data_page()->is_busy(); }, 60000));
  Project& project = *window.current();
  ASSERT_TRUE(QTest::qWaitFor([&] { return project.data_page()->files().size() == 3; }, 60000));
  QTest::keyClick(&window, Qt::Key_J, Qt::ControlModifier);
  auto* const assistant = project.findChild<QDialog*>(QStringLiteral("joint_assistant"));
  ASSERT_NE(assistant, nullptr);
  EXPECT_EQ(find<QTreeWidget>(*assistant, "joint_pairs")->topLevelItemCount(), 4);
  assistant->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  ASSERT_TRUE(project.checked().scene) << project.editor()->text();
  EXPECT_THAT(project.editor()->text(), testing::HasSubstr("springs = ["));
  project.editor()->document()->setModified(false);
}

}  // namespace
}  // namespace jointid::gui
