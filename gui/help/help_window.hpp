#pragma once

#include <QDialog>

class QTextBrowser;

namespace jointid::gui {

/// The pages of docs/, which are part of the program: no network, no other program. Links lead from page to page; Alt+← leads back.
class HelpWindow : public QDialog {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent = nullptr);

  /// "records", of docs/records.md; "workbench" where there is none of that name.
  void show_page(const QString& name);
  QTextBrowser* browser() const { return browser_; }

 private:
  QTextBrowser* browser_;
};

/// The page of docs on a tab of a project, by the name of its widget: "records" of "records_page".
QString help_page_of(const QString& widget);

}  // namespace jointid::gui
