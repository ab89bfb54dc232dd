#pragma once

#include <QColor>
#include <QPalette>

class QApplication;

namespace jointid::gui {

enum class Theme { light, dark };

/// Style and palette of the whole program. Qt 6.4 does not tell what the desktop prefers, so the user chooses.
void apply(Theme theme, QApplication& application);

/// Which of the two a widget has.
Theme theme_of(const QPalette& palette);

/// What plots and tables are drawn with; texts and lines are readable on the window's background.
struct Colours {
  QColor background, text, weak_text, grid;
  QColor error, warning, good;
  QColor band;  ///< of excluded lines, translucent
};

Colours colours(Theme theme);

/// Of the n-th curve of a plot; they differ in hue and lightness, and begin anew after eight.
QColor curve_colour(Theme theme, int n);

/// White or the background at 0 to deep blue (light blue on dark) at 1 and to brown (orange) at −1; the text that is readable on it.
QColor shade(Theme theme, double share);
QColor text_on(const QColor& background);

}  // namespace jointid::gui
