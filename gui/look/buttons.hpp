#pragma once

#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSpinBox>
#include <initializer_list>

namespace jointid::gui {

/// A button; the hint is its name for screen readers, too.
QPushButton* push_button(const char* name, const QString& text, const QString& hint);

/// A whole number from `least` on, with its title before it.
QSpinBox* number_box(const char* name, const QString& title, int least, int value);

/// A frequency in Hz with a word before it; 0 stands for all lines on that side.
QDoubleSpinBox* frequency_box(const char* name, const QString& title, const QString& word);

/// Some widgets at the left and some at the right.
QLayout* row_of(std::initializer_list<QWidget*> left, std::initializer_list<QWidget*> right);

}  // namespace jointid::gui
