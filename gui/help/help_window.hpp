#pragma once

#include <QDialog>

class QTextBrowser;

namespace jointid::gui {

/// The pages of docs/, which are part of the program: no network, no other program. Links lead from page to page; Alt+← leads back.
class HelpWindow : public QDialog {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent = nullptr);

  /// "records", of docs/records.md, or "records#Windows", with that heading at the top; "workbench" where there is none of that
  /// name.
  void show_page(const QString& name);
  QTextBrowser* browser() const { return browser_; }

 private:
  void go_to_heading(const QString& heading);

  QTextBrowser* browser_;
};

}  // namespace jointid::gui
