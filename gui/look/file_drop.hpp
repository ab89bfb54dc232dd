#pragma once

#include <QStringList>
#include <functional>

class QWidget;

namespace jointid::gui {

/// From now on files of this machine may be dropped on the widget; `open` gets them.
void let_drop_files(QWidget& widget, std::function<void(const QStringList&)> open);

}  // namespace jointid::gui
