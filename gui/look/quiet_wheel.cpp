#include "gui/look/quiet_wheel.hpp"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>

namespace jointid::gui {
namespace {

/// What is ignored here goes on to the widget around it, which scrolls.
class QuietWheel final : public QObject {
 public:
  using QObject::QObject;

 private:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::Wheel) return false;
    if (qobject_cast<QComboBox*>(watched) == nullptr && qobject_cast<QAbstractSpinBox*>(watched) == nullptr) return false;
    event->ignore();
    return true;
  }
};

}  // namespace

void keep_wheel_from_fields(QObject& owner) { qApp->installEventFilter(new QuietWheel(&owner)); }

}  // namespace jointid::gui
