#include "gui/look/status_label.hpp"

#include <QEvent>

#include "gui/look/theme.hpp"

namespace jointid::gui {

void StatusLabel::set_bad(bool bad) {
  bad_ = bad;
  colour();
}

/// The palette of its own has this colour alone; all others remain those of the application.
void StatusLabel::colour() {
  const Colours use = colours(theme_of(palette()));
  const QColor wanted = bad_ ? use.error : use.text;
  if (palette().color(QPalette::WindowText) == wanted) return;
  QPalette own;
  own.setColor(QPalette::WindowText, wanted);
  setPalette(own);
}

void StatusLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colour();
}

}  // namespace jointid::gui
