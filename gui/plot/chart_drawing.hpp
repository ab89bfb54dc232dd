#pragma once

#include <string>
#include <vector>

#include "gui/look/theme.hpp"
#include "report/page/contents.hpp"

class QCustomPlot;

/// How points and histograms become diagrams of a QCustomPlot.
namespace jointid::gui {

void draw_scatter(QCustomPlot& plot, const report::ScatterPlot& scatter, Theme theme);

/// In rows of up to four, as many as there is room for.
void draw_histograms(QCustomPlot& plot, const std::vector<report::HistogramPlot>& histograms, Theme theme);

/// A ring round a point of the scatter plot; the one before goes.
void draw_ring(QCustomPlot& plot, const report::Point& point, Theme theme);

/// group, name, x and y of every point, or name, from, to and count of every bin, a line each.
std::string chart_table(const report::ScatterPlot& scatter, const std::vector<report::HistogramPlot>& histograms, char separator);

}  // namespace jointid::gui
