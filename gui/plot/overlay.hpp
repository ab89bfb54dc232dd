#pragma once

#include <optional>
#include <vector>

#include "gui/plot/panel_drawing.hpp"

class QCPAxisRect;
class QCPLayer;
class QCustomPlot;

/// What lies over or under the curves of diagrams.
namespace jointid::gui {

/// Excluded bands, and what is outside of the scene's range.
void draw_bands(QCPAxisRect& rect, const std::vector<ident::Range>& excluded, const std::optional<ident::Range>& range,
                const ident::Range& span, Theme theme);

/// Short strokes at the lower end of a diagram.
void draw_marks(QCPAxisRect& rect, const std::vector<double>& marked_hz, Theme theme);

/// Lines in all diagrams; points on the curves of a Nyquist plot.
void draw_cursor(QCustomPlot& plot, QCPLayer& layer, const Drawing& drawing, double frequency_hz);

}  // namespace jointid::gui
