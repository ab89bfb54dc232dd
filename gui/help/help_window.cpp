#include "gui/help/help_window.hpp"

#include <QDesktopServices>
#include <QFile>
#include <QHBoxLayout>
#include <QPushButton>
#include <QTextBlock>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "gui/look/buttons.hpp"
#include "gui/look/named.hpp"

namespace jointid::gui {

HelpWindow::HelpWindow(QWidget* parent) : QDialog(parent) {
  named(this, "help_window", tr("Documentation"));
  setWindowTitle(tr("Documentation"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  browser_ = named(new QTextBrowser, "help_browser", tr("Page of the documentation"));
  browser_->setOpenLinks(false);
  auto* back = push_button("help_back", tr("Back"), tr("To the page before (Alt+Left)"));
  back->setAutoDefault(false);
  back->setShortcut(QKeySequence::Back);
  back->setEnabled(false);
  auto* all = new QVBoxLayout(this);
  all->addLayout(row_of({back}, {}));
  all->addWidget(browser_, 1);
  connect(back, &QPushButton::clicked, browser_, &QTextBrowser::backward);
  connect(browser_, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
  connect(browser_, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
    if (link.isRelative() || link.scheme() == QLatin1String("qrc"))
      browser_->setSource(browser_->source().resolved(link), QTextDocument::MarkdownResource);
    else
      QDesktopServices::openUrl(link);
  });
  resize(900, 680);
}

void HelpWindow::show_page(const QString& name) {
  const QString page = name.section(QLatin1Char('#'), 0, 0), heading = name.section(QLatin1Char('#'), 1);
  const bool is_there = QFile::exists(QStringLiteral(":/docs/%1.md").arg(page));
  browser_->setSource(QUrl(QStringLiteral("qrc:/docs/%1.md").arg(is_there ? page : QStringLiteral("workbench"))),
                      QTextDocument::MarkdownResource);
  show();
  raise();
  if (!heading.isEmpty()) go_to_heading(heading);
}

/// Pages in Markdown have no anchors: the heading is looked for by its words.
void HelpWindow::go_to_heading(const QString& heading) {
  for (QTextBlock block = browser_->document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || block.text().compare(heading, Qt::CaseInsensitive) != 0) continue;
    QTextCursor end(browser_->document());
    end.movePosition(QTextCursor::End);
    browser_->setTextCursor(end);  // so that the heading comes to the top
    browser_->setTextCursor(QTextCursor(block));
    return browser_->ensureCursorVisible();
  }
}

}  // namespace jointid::gui
