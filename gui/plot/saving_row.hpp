#pragma once

#include <functional>

class QLabel;
class QVBoxLayout;

namespace jointid::gui {

/// Below a plot: its read-out, and the buttons NAME_copy and NAME_save, which do what is given.
void add_saving_row(QVBoxLayout& column, QLabel* readout, const char* name, const std::function<void()>& copy,
                    const std::function<void()>& save);

}  // namespace jointid::gui
