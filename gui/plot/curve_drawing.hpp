#pragma once

#include <string>
#include <vector>

#include "gui/look/theme.hpp"
#include "report/page/contents.hpp"

class QCPAxis;
class QCPAxisRect;
class QCustomPlot;

/// Curves of pages as diagrams of a QCustomPlot.
namespace jointid::gui {

/// Name, and logarithmic with powers of ten where it is wanted.
void set_axis(QCPAxis& axis, const report::Axis& wanted);

/// Below each other with one legend above; those over an axis of the same name share its range.
void draw_curves(QCustomPlot& plot, const std::vector<report::CurvePlot>& plots, Theme theme);

/// Behind points, over the same x-axis and an axis of its own on the right.
void draw_backdrop(QCustomPlot& plot, QCPAxisRect& rect, const report::Backdrop& backdrop, Theme theme);

/// A block per diagram, parted by an empty line: x, and a column per curve, with 17 digits.
std::string curve_table(const std::vector<report::CurvePlot>& plots, char separator);

}  // namespace jointid::gui
