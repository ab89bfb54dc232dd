#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace jointid::gui {

/// The page of docs on a widget: of itself, or of the nearest one around it that has a page. "records", or "workbench#From files
/// to joint" with the heading.
QString help_of(const QWidget* widget);

/// Shows it in a window of the dialog that the widget is in, which stays in front of it; else of the main window.
void show_help_of(QWidget* widget);

/// F1 in dialogs, and "What's this?" of any widget, open the page of docs on it.
class HelpKeys : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace jointid::gui
