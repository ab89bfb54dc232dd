#pragma once

#include <gmock/gmock.h>

#include <QProcess>
#include <QTemporaryDir>

#include "gui/look/paths.hpp"
#include "widgets.hpp"

namespace jointid::gui {

/// A JSON result without how it was made, which the workbench does not tell.
inline std::string answers_of(std::string text) {
  const std::size_t at = text.find(",\n  \"provenance\": {");
  return at == std::string::npos ? text : text.substr(0, at) + "\n}\n";
}

/// All that a page of `jointid …` writes: JSON and CSV, where it has them, are those of its command line to the last byte; the
/// report is a whole page.
template <class Page>
void expect_the_commands_files(Page& page, const QTemporaryDir& folder) {
  ASSERT_NE(page.shown(), nullptr) << page.status().toStdString();
  for (const auto& [ending, write] : page.shown()->outputs) {
    const QString mine = folder.filePath("mine." + ending), theirs = folder.filePath("theirs." + ending);
    page.write(mine, ending);
    if (ending == "html") {
      EXPECT_THAT(read_file(mine), testing::HasSubstr("</html>"));
      continue;
    }
    QProcess process;
    process.start("/bin/sh",
                  {"-c", shell_word(JOINTID_COMMAND) + page.command_line().mid(7) + " --" + ending + " " + shell_word(theirs)});
    ASSERT_TRUE(process.waitForFinished(120000));
    ASSERT_EQ(process.exitCode(), 0) << page.command_line().toStdString();
    EXPECT_EQ(read_file(mine), answers_of(read_file(theirs))) << ending.toStdString();
  }
}

/// A diagram for every choice of the menu, points or curves, and a table for every one of its.
template <class Page>
void expect_every_choice_drawn(Page& page) {
  auto& menu = *page.plots()->menu();
  for (int i = 0; i < menu.count(); ++i) {
    menu.setCurrentIndex(i);
    const auto& chart = *page.plots()->chart();
    EXPECT_NE(chart.curve_plots().empty(), chart.scatter().groups.empty()) << menu.itemText(i).toStdString();
  }
  auto& tables = *page.tables()->menu();
  ASSERT_GE(tables.count(), 1);
  for (int i = 0; i < tables.count(); ++i) {
    tables.setCurrentIndex(i);
    EXPECT_GT(page.tables()->table()->cells()->rowCount(), 0) << tables.itemText(i).toStdString();
  }
}

}  // namespace jointid::gui
