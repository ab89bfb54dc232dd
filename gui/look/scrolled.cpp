#include "gui/look/scrolled.hpp"

#include <QScrollArea>

#include "gui/look/named.hpp"

namespace jointid::gui {

QWidget* scrolled(QWidget* content) {
  auto* const area =
      named(new QScrollArea, (content->objectName() + "_scrolled").toLatin1().constData(), content->accessibleName());
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);  // what is in it has the focus
  area->setWidgetResizable(true);
  area->setWidget(content);
  return area;
}

}  // namespace jointid::gui
