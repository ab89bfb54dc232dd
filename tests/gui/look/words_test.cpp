#include <gmock/gmock.h>

#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QTabWidget>
#include <QTest>
#include <QTextDocument>

#include "../widgets.hpp"
#include "gui/look/language.hpp"
#include "gui/main_window.hpp"
#include "gui/project.hpp"
#include "gui/scene/scene_editor.hpp"

namespace jointid::gui {
namespace {

/// The text of every menu entry by its key, without the mark of the letter that chooses it.
std::map<QString, QString> entries_by_key(MainWindow& window) {
  std::map<QString, QString> out;
  for (const QAction* menu : window.menuBar()->actions()) {
    for (const QAction* action : menu->menu()->actions())
      out[action->shortcut().toString(QKeySequence::PortableText)] = QString(action->text()).remove(QLatin1Char('&'));
  }
  return out;
}

QStringList titles_of_pages(MainWindow& window) {
  QStringList out;
  window.activateWindow();
  if (!QTest::qWaitForWindowActive(&window)) return out;
  QTest::keyClick(&window, Qt::Key_N, Qt::ControlModifier);
  if (window.current() == nullptr) return out;
  for (int page = 0; page < window.current()->pages()->count(); ++page) out << window.current()->pages()->tabText(page);
  window.current()->editor()->document()->setModified(false);
  return out;
}

class PageWords : public testing::TestWithParam<const char*> {
 protected:
  Spoken spoken_{GetParam()};
};

TEST_P(PageWords, AreOneInMenuAndTab) {
  ASSERT_TRUE(has_language(QString::fromLatin1(GetParam())));
  MainWindow window;
  window.show();
  const auto entries = entries_by_key(window);
  const QStringList titles = titles_of_pages(window);
  ASSERT_EQ(titles.size(), 14);
  for (int page = 0; page < titles.size(); ++page) {
    const QString key = page < 9 ? QStringLiteral("Alt+%1").arg((page + 2) % 10) : QStringLiteral("Ctrl+%1").arg(page - 8);
    ASSERT_TRUE(entries.contains(key)) << key.toStdString();
    EXPECT_EQ(entries.at(key).toStdString(), titles[page].toStdString()) << key.toStdString();
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, PageWords, testing::Values("en", "de"));

/// Every page has its words at its description and in the table of keys.
TEST(WordsOfPages, AreThoseOfTheDocumentation) {
  MainWindow window;
  window.show();
  QFile page(QStringLiteral(":/docs/workbench.md"));
  ASSERT_TRUE(page.open(QIODevice::ReadOnly));
  const QString docs = QString::fromUtf8(page.readAll());
  const QStringList titles = titles_of_pages(window);
  ASSERT_EQ(titles.size(), 14);
  EXPECT_TRUE(docs.contains(QStringLiteral("| Text, %1; next project |").arg(titles.join(QStringLiteral(", "))))) << titles.join(", ").toStdString();
  for (int i = 0; i < titles.size(); ++i) {
    const QString key = i < 9 ? QStringLiteral("Alt+%1").arg((i + 2) % 10) : QStringLiteral("Ctrl+%1").arg(i - 8);
    EXPECT_TRUE(docs.contains(QStringLiteral("(page %1, %2").arg(titles[i], key))) << titles[i].toStdString();
  }
}

}  // namespace
}  // namespace jointid::gui
