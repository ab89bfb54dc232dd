#include "gui/look/language.hpp"

#include <gmock/gmock.h>

#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSignalSpy>

#include "gui/forms/field_hints.hpp"
#include "gui/look/message_bar.hpp"
#include "gui/main_window.hpp"
#include "gui/project.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

QStringList titles(const MainWindow& window) {
  QStringList all;
  for (const QAction* action : window.menuBar()->actions()) all << action->text().remove('&');
  return all;
}

TEST(Language, WindowsSpeakIt) {
  if (!has_language("de")) GTEST_SKIP() << "built without lrelease";
  const Spoken languages("en");
  EXPECT_TRUE(titles(MainWindow()).contains("File"));
  Spoken::speak("de");
  EXPECT_TRUE(titles(MainWindow()).contains("Datei"));
  EXPECT_EQ(title_of("data").toStdString(), "Daten");
  Spoken::speak("en");
  EXPECT_EQ(title_of("data").toStdString(), "Data");
}

TEST(Language, KnowsOneFromSeveral) {
  if (!has_language("de")) GTEST_SKIP() << "built without lrelease";
  const Spoken languages("en");
  EXPECT_EQ(MainWindow::tr("Reading %n file(s) …", nullptr, 1), "Reading 1 file …");
  EXPECT_EQ(MainWindow::tr("Reading %n file(s) …", nullptr, 3), "Reading 3 files …");
}

TEST(Language, IsKept) {
  if (!has_language("de")) GTEST_SKIP() << "built without lrelease";
  const Spoken languages("en");
  choose_language("de");
  EXPECT_EQ(language(), "de");
}

TEST(Language, WhatIsNotThereIsEnglish) {
  const Spoken languages("en");
  choose_language("tlh");
  EXPECT_EQ(language(), "en");
  EXPECT_FALSE(has_language("tlh"));
}

TEST(Language, AMenuOffersToBeginAnewWithTheSameFiles) {
  const Spoken languages("en");
  QTemporaryDir folder;
  write_file(folder.filePath("one.toml"), small_scene);
  MainWindow window;
  window.open({folder.filePath("one.toml")});
  QSignalSpy anew(&window, &MainWindow::begin_anew);
  QAction* english = nullptr;
  for (QAction* action : window.findChildren<QAction*>()) {
    if (action->text() == "&English") english = action;
  }
  ASSERT_NE(english, nullptr);
  english->trigger();
  EXPECT_FALSE(window.messages()->text().isEmpty());
  find<QPushButton>(*window.messages(), "message_action")->click();
  ASSERT_EQ(anew.count(), 1);
  EXPECT_EQ(anew.front().front().toStringList(), QStringList{folder.filePath("one.toml")});
}

}  // namespace
}  // namespace jointid::gui
