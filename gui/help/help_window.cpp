#include "gui/help/help_window.hpp"

#include <QDesktopServices>
#include <QFile>
#include <QHBoxLayout>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <map>

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
  const bool is_there = QFile::exists(QStringLiteral(":/docs/%1.md").arg(name));
  browser_->setSource(QUrl(QStringLiteral("qrc:/docs/%1.md").arg(is_there ? name : QStringLiteral("workbench"))),
                      QTextDocument::MarkdownResource);
  show();
  raise();
}

QString help_page_of(const QString& widget) {
  static const std::map<QString, QString> pages = {{QStringLiteral("modal_page"), QStringLiteral("modal-models")},
                                                   {QStringLiteral("couple_page"), QStringLiteral("coupling")},
                                                   {QStringLiteral("loading_curve_page"), QStringLiteral("loading-curves")},
                                                   {QStringLiteral("response_page"), QStringLiteral("response")},
                                                   {QStringLiteral("laws_page"), QStringLiteral("friction-from-vibration")},
                                                   {QStringLiteral("oscillate_page"), QStringLiteral("oscillations")},
                                                   {QStringLiteral("records_page"), QStringLiteral("records")},
                                                   {QStringLiteral("compare_page"), QStringLiteral("choosing-a-method")},
                                                   {QStringLiteral("scene_editor"), QStringLiteral("scene")}};
  const auto found = pages.find(widget);
  return found == pages.end() ? QStringLiteral("workbench") : found->second;
}

}  // namespace jointid::gui
