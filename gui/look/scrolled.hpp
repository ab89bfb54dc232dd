#pragma once

class QWidget;

namespace jointid::gui {

/// What is as large as its place, and no smaller than it needs: in a small window it is scrolled.
QWidget* scrolled(QWidget* content);

}  // namespace jointid::gui
