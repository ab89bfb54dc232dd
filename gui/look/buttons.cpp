#include "gui/look/buttons.hpp"

#include <QLineEdit>

#include "gui/look/named.hpp"

namespace jointid::gui {

QPushButton* push_button(const char* name, const QString& text, const QString& hint) {
  return named(new QPushButton(text), name, hint, hint);
}

QSpinBox* number_box(const char* name, const QString& title, int least, int value) {
  auto* box = named(new QSpinBox, name, title, title);
  box->setRange(least, 1000000000);
  box->setValue(value);
  box->setPrefix(title + " ");
  box->findChild<QLineEdit*>()->setAccessibleName(title);
  return box;
}

}  // namespace jointid::gui
