#include <gmock/gmock.h>

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <QTextDocument>
#include <QTreeWidget>

#include "gui/begin/example_dialog.hpp"
#include "gui/look/message_bar.hpp"
#include "gui/main_window.hpp"
#include "gui/project.hpp"
#include "gui/records/records_page.hpp"
#include "gui/scene/scene_editor.hpp"
#include "../widgets.hpp"

/// Scenes to be filled in, and examples.
namespace jointid::gui {
namespace {

using testing::HasSubstr;

struct Beginning {
  QTemporaryDir folder;
  MainWindow window;

  Beginning() {
    window.resize(1100, 750);
    window.show();
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
  }
  ~Beginning() {
    for (Project* project : window.findChildren<Project*>()) project->editor()->document()->setModified(false);
  }
  /// The entries of a menu inside the file menu.
  QList<QAction*> entries(const QString& title) {
    for (QAction* action : window.menuBar()->actions().front()->menu()->actions()) {
      if (action->menu() != nullptr && action->text().remove(QLatin1Char('&')) == title) return action->menu()->actions();
    }
    return {};
  }
  /// Opens an example by keys alone, from the action that has the shortcut on.
  Project* open(const char* words) {
    for (QAction* action : window.menuBar()->actions().front()->menu()->actions()) {
      if (action->shortcut() == QKeySequence(QStringLiteral("Ctrl+Shift+O"))) action->trigger();
    }
    auto* const dialog = window.findChild<ExampleDialog*>();
    EXPECT_NE(dialog, nullptr);
    if (dialog == nullptr) return nullptr;
    QTest::keyClicks(find(*dialog, "example_filter"), QString::fromLatin1(words));
    find<QLineEdit>(*dialog, "example_folder")->setText(folder.path());
    const int before = window.count();
    QTest::keyClick(dialog, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.count() > before; }, 60000)) << window.messages()->text().toStdString();
    return window.current();
  }
};

TEST(Templates, EveryOneIsASceneThatItsReaderAccepts) {
  Beginning beginning;
  const QList<QAction*> entries = beginning.entries(QStringLiteral("New from template"));
  ASSERT_EQ(entries.size(), 6);
  for (QAction* entry : entries.mid(0, 5)) {
    const int before = beginning.window.count();
    entry->trigger();
    ASSERT_EQ(beginning.window.count(), before + 1) << entry->text().toStdString();
    const CheckedScene& checked = beginning.window.current()->checked();
    EXPECT_FALSE(checked.error) << entry->text().toStdString() << ": " << checked.error->problem;
  }
}

TEST(Templates, RecordsNeedNoScene) {
  Beginning beginning;
  beginning.entries(QStringLiteral("New from template")).back()->trigger();
  ASSERT_EQ(beginning.window.count(), 1);
  Project& project = *beginning.window.current();
  EXPECT_EQ(project.pages()->currentWidget(), project.records_page());
  EXPECT_THAT(project.records_page()->command_line().toStdString(), HasSubstr("jointid frf"));
  EXPECT_FALSE(project.is_modified());
}

TEST(Examples, OpenByKeysAndReplaceNothing) {
  Beginning beginning;
  const Project* const project = beginning.open("A1");
  ASSERT_NE(project, nullptr);
  EXPECT_TRUE(project->checked().scene);
  EXPECT_EQ(project->folder(), QFileInfo(beginning.folder.filePath("A1")).absoluteFilePath());
  write_file(project->file(), "# mine\n");
  const Project* const again = beginning.open("A1");
  ASSERT_NE(again, nullptr);
  EXPECT_EQ(again->folder(), QFileInfo(beginning.folder.filePath("A1-2")).absoluteFilePath());
  EXPECT_EQ(read_file(beginning.folder.filePath("A1/A1.toml")), "# mine\n");
}

TEST(Examples, AreFoundByTheirWords) {
  ExampleDialog dialog;
  EXPECT_GT(dialog.problems()->topLevelItemCount(), 40);
  auto* const filter = find<QLineEdit>(dialog, "example_filter");
  filter->setText("no such thing");
  EXPECT_TRUE(dialog.name().empty());
  EXPECT_FALSE(find<QDialogButtonBox>(dialog, "example_buttons")->button(QDialogButtonBox::Open)->isEnabled());
  filter->setText("bolts");
  EXPECT_THAT(dialog.name(), HasSubstr("bolts"));
  EXPECT_TRUE(find<QDialogButtonBox>(dialog, "example_buttons")->button(QDialogButtonBox::Open)->isEnabled());
}

}  // namespace
}  // namespace jointid::gui
