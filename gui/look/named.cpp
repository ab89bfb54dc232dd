#include "gui/look/named.hpp"

#include <QWidget>

namespace jointid::gui {

void name_widget(QWidget& widget, const char* object_name, const QString& accessible_name, const QString& hint) {
  widget.setObjectName(QString::fromLatin1(object_name));
  widget.setAccessibleName(accessible_name);
  if (!hint.isEmpty()) widget.setToolTip(hint);
}

}  // namespace jointid::gui
