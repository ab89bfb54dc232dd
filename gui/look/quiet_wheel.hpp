#pragma once

class QObject;

namespace jointid::gui {

/// As long as `owner` lives the wheel scrolls past choices, number fields, sliders and tabs, in place of changing them.
void keep_wheel_from_fields(QObject& owner);

}  // namespace jointid::gui
