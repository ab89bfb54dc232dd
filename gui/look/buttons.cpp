#include "gui/look/buttons.hpp"

#include <QHBoxLayout>
#include <QLineEdit>

#include "gui/look/named.hpp"

namespace jointid::gui {
namespace {

constexpr int widest = 130;

}  // namespace

QPushButton* push_button(const char* name, const QString& text, const QString& hint) {
  return named(new QPushButton(text), name, hint, hint);
}

QSpinBox* number_box(const char* name, const QString& title, int least, int value) {
  auto* box = named(new QSpinBox, name, title, title);
  box->setRange(least, 1000000000);
  box->setValue(value);
  box->setPrefix(title + " ");
  box->setMaximumWidth(widest);
  box->findChild<QLineEdit*>()->setAccessibleName(title);
  return box;
}

QDoubleSpinBox* frequency_box(const char* name, const QString& title, const QString& word) {
  auto* box = named(new QDoubleSpinBox, name, title, QDoubleSpinBox::tr("%1; 0: all lines").arg(title));
  box->setRange(0.0, 1e7);
  box->setDecimals(3);
  box->setPrefix(word + " ");
  box->setSuffix(QStringLiteral(" Hz"));
  box->setSpecialValueText(QDoubleSpinBox::tr("%1: all lines").arg(word));
  box->findChild<QLineEdit*>()->setAccessibleName(title);
  return box;
}

QLayout* row_of(std::initializer_list<QWidget*> left, std::initializer_list<QWidget*> right) {
  auto* row = new QHBoxLayout;
  for (QWidget* each : left) row->addWidget(each);
  row->addStretch(1);
  for (QWidget* each : right) row->addWidget(each);
  return row;
}

}  // namespace jointid::gui
