#pragma once

#include <QString>

class QWidget;

namespace jointid::gui {

/// Gives a widget the name that layouts, tests and screen readers know it by, and what it tells under the mouse (the name, where
/// empty).
template <class Widget>
Widget* named(Widget* widget, const char* object_name, const QString& accessible_name, const QString& hint = {});

void name_widget(QWidget& widget, const char* object_name, const QString& accessible_name, const QString& hint);

template <class Widget>
Widget* named(Widget* widget, const char* object_name, const QString& accessible_name, const QString& hint) {
  name_widget(*widget, object_name, accessible_name, hint);
  return widget;
}

}  // namespace jointid::gui
