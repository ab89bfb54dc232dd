#include "gui/project.hpp"

#include <gmock/gmock.h>

#include <QFile>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTextDocument>

#include "gui/look/message_bar.hpp"
#include "gui/recent_files.hpp"
#include "gui/scene/scene_editor.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

struct Opened {
  QTemporaryDir folder;
  QString file = folder.filePath("scene.toml");
  Project project;

  explicit Opened(const std::string& text = small_scene) {
    write_file(file, text);
    EXPECT_TRUE(project.open(file));
  }
  /// As editors save: under another name, then renamed.
  void change_outside(const std::string& text) {
    write_file(file + ".new", text);
    QFile::remove(file);
    QFile::rename(file + ".new", file);
  }
};

TEST(Project, OpensAndChecks) {
  Opened opened;
  EXPECT_TRUE(opened.project.checked().scene);
  EXPECT_FALSE(opened.project.is_modified());
  EXPECT_EQ(opened.project.title(), "scene.toml");
  EXPECT_TRUE(recent_files().contains(opened.file));
}

TEST(Project, ChecksAsOneTypes) {
  Opened opened;
  opened.project.editor()->moveCursor(QTextCursor::End);
  QTest::keyClicks(opened.project.editor(), "nonsense = 1");
  ASSERT_TRUE(QTest::qWaitFor([&] { return opened.project.checked().error.has_value(); }, 3000));
  EXPECT_EQ(opened.project.editor()->error()->line, 10);
  EXPECT_TRUE(opened.project.is_modified());
}

TEST(Project, TitlesOfAllPagesAreWholeInASmallWindow) {
  Opened opened;
  opened.project.resize(1024, 680);
  opened.project.show();
  auto* pages = opened.project.findChild<QTabWidget*>("pages");
  ASSERT_NE(pages, nullptr);
  for (int page = 0; page < pages->count(); ++page) pages->setTabVisible(page, true);
  QCoreApplication::processEvents();
  const QTabBar* bar = pages->tabBar();
  EXPECT_GE(bar->count(), 13);
  for (int page = 0; page < bar->count(); ++page) {
    const QString title = bar->tabText(page);
    EXPECT_GE(bar->tabRect(page).width(), bar->fontMetrics().horizontalAdvance(title) + 4) << title.toStdString();
  }
}

TEST(Project, SavesWhatIsWritten) {
  Opened opened;
  opened.project.editor()->appendPlainText("# more");
  ASSERT_TRUE(opened.project.save());
  EXPECT_EQ(read_file(opened.file), std::string(small_scene) + "\n# more");
  EXPECT_FALSE(opened.project.is_modified());
}

TEST(Project, NeverSavesOverData) {
  Opened opened;
  const QString data = opened.folder.filePath("a.uff");
  write_file(data, "FRFs");
  EXPECT_FALSE(opened.project.save_as(data));
  EXPECT_EQ(read_file(data), "FRFs");
  EXPECT_FALSE(opened.project.messages()->text().isEmpty());
}

TEST(Project, SaysWhatCannotBeReadOrWritten) {
  Project project;
  EXPECT_FALSE(project.open("/no/such/scene.toml"));
  EXPECT_FALSE(project.messages()->text().isEmpty());
  project.start(small_scene, "/tmp");
  EXPECT_EQ(project.suggested_file(), "/tmp/scene.toml");
  EXPECT_FALSE(project.save_as("/no/such/folder/scene.toml"));
  EXPECT_TRUE(project.is_modified());
}

TEST(Project, FollowsTheFile) {
  Opened opened;
  for (const char* title : {"title = \"one\"\n", "title = \"two\"\n"}) {
    opened.change_outside(title + std::string(small_scene));
    ASSERT_TRUE(QTest::qWaitFor([&] { return opened.project.editor()->text().starts_with(title); }, 5000));
    EXPECT_FALSE(opened.project.is_modified());
  }
}

TEST(Project, AsksBeforeAnotherProgramsChangeReplacesOnesOwn) {
  Opened opened;
  opened.project.editor()->appendPlainText("# mine");
  opened.change_outside("title = \"theirs\"\n" + std::string(small_scene));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !opened.project.messages()->text().isEmpty(); }, 5000));
  EXPECT_THAT(opened.project.editor()->text(), testing::EndsWith("# mine"));
  find<QPushButton>(opened.project, "message_action")->click();
  EXPECT_THAT(opened.project.editor()->text(), testing::StartsWith("title = \"theirs\""));
  opened.project.editor()->undo();
  EXPECT_THAT(opened.project.editor()->text(), testing::EndsWith("# mine"));
}

TEST(Project, DoesNotSaveOverAChangeOfAnotherProgramUnasked) {
  Opened opened;
  opened.project.editor()->appendPlainText("# mine");
  opened.change_outside("title = \"theirs\"\n" + std::string(small_scene));
  EXPECT_FALSE(opened.project.save());
  EXPECT_THAT(read_file(opened.file), testing::StartsWith("title = \"theirs\""));
  EXPECT_TRUE(opened.project.is_modified());
  EXPECT_THAT(find<QPushButton>(opened.project, "message_action")->text().toStdString(), testing::HasSubstr("Replace"));
  find<QPushButton>(opened.project, "message_action")->click();
  EXPECT_THAT(read_file(opened.file), testing::EndsWith("# mine"));
  EXPECT_TRUE(opened.project.save());
}

TEST(Project, OwnSavesAreNoChangesOfOthers) {
  Opened opened;
  opened.project.editor()->appendPlainText("# mine");
  ASSERT_TRUE(opened.project.save());
  QTest::qWait(300);
  EXPECT_TRUE(opened.project.messages()->text().isEmpty());
}

}  // namespace
}  // namespace jointid::gui
