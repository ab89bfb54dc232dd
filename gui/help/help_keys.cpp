#include "gui/help/help_keys.hpp"

#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMessageBox>
#include <QWidget>
#include <map>

#include "gui/help/help_window.hpp"

namespace jointid::gui {
namespace {

/// By the names of widgets; what is not here has the page of the nearest widget around it.
const std::map<QString, QString>& pages_of_widgets() {
  static const std::map<QString, QString> pages = {
      {"modal_page", "modal-models"},
      {"couple_page", "coupling"},
      {"loading_curve_page", "loading-curves"},
      {"response_page", "response"},
      {"laws_page", "friction-from-vibration"},
      {"oscillate_page", "oscillations"},
      {"records_page", "records"},
      {"lines_page", "joint-line-by-line"},
      {"compare_page", "choosing-a-method"},
      {"study_page", "workbench#From files to joint"},
      {"plan_page", "likelihood"},
      {"data_page", "checking-data"},
      {"geometry_page", "workbench#From files to joint"},
      {"solve_page", "status"},
      {"iterations_menu", "choosing-a-method#Objective and unknowns over the iterations"},
      {"iterations", "choosing-a-method#Objective and unknowns over the iterations"},
      {"worth", "workbench#From files to joint"},
      {"matrix", "formulas"},
      {"bounds", "likelihood"},
      {"scene_editor", "scene"},
      {"scene_form", "scene"},
      {"scene_views", "scene"},
      {"joint_assistant", "workbench#From files to joint"},
      {"example_dialog", "problems"},
      {"variable_dialog", "file-formats"}};
  return pages;
}

/// Dialogs of Qt have no names of ours.
QString page_of_kind(const QWidget& widget) {
  if (qobject_cast<const QFileDialog*>(&widget) != nullptr) return QStringLiteral("file-formats");
  return qobject_cast<const QMessageBox*>(&widget) != nullptr ? QStringLiteral("workbench#Keys") : QString();
}

}  // namespace

QString help_of(const QWidget* widget) {
  for (const QWidget* each = widget; each != nullptr; each = each->parentWidget()) {
    if (const QString page = page_of_kind(*each); !page.isEmpty()) return page;
    const auto found = pages_of_widgets().find(each->objectName());
    if (found != pages_of_widgets().end()) return found->second;
  }
  return QStringLiteral("workbench");
}

void show_help_of(QWidget* widget) {
  if (widget == nullptr) return;
  QWidget* const window = widget->window();
  auto* help = window->findChild<HelpWindow*>(QString(), Qt::FindDirectChildrenOnly);
  if (help == nullptr) help = new HelpWindow(window);
  help->show_page(help_of(widget));
}

bool HelpKeys::eventFilter(QObject* watched, QEvent* event) {
  auto* const widget = qobject_cast<QWidget*>(watched);
  if (widget == nullptr) return false;
  if (event->type() == QEvent::QueryWhatsThis) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::WhatsThis) {
    show_help_of(widget);
    return true;
  }
  if (event->type() != QEvent::KeyPress || static_cast<QKeyEvent*>(event)->key() != Qt::Key_F1) return false;
  const auto* const dialog = qobject_cast<QDialog*>(widget->window());
  if (dialog == nullptr || qobject_cast<const HelpWindow*>(dialog) != nullptr) return false;
  show_help_of(widget);
  return true;
}

}  // namespace jointid::gui
