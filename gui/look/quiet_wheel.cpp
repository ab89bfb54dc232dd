#include "gui/look/quiet_wheel.hpp"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QSlider>
#include <QTabBar>

namespace jointid::gui {
namespace {

/// What is ignored here goes on to the widget around it, which scrolls.
class QuietWheel final : public QObject {
 public:
  using QObject::QObject;

 private:
  static bool is_chooser(const QObject* watched) {
    return qobject_cast<const QComboBox*>(watched) != nullptr || qobject_cast<const QAbstractSpinBox*>(watched) != nullptr ||
           qobject_cast<const QSlider*>(watched) != nullptr || qobject_cast<const QTabBar*>(watched) != nullptr;
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::Wheel) return false;
    if (!is_chooser(watched)) return false;
    event->ignore();
    return true;
  }
};

}  // namespace

void keep_wheel_from_fields(QObject& owner) { qApp->installEventFilter(new QuietWheel(&owner)); }

}  // namespace jointid::gui
