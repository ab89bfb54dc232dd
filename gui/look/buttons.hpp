#pragma once

#include <QPushButton>
#include <QSpinBox>

namespace jointid::gui {

/// A button; the hint is its name for screen readers, too.
QPushButton* push_button(const char* name, const QString& text, const QString& hint);

/// A whole number from `least` on, with its title before it.
QSpinBox* number_box(const char* name, const QString& title, int least, int value);

}  // namespace jointid::gui
