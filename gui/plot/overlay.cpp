#include "gui/plot/overlay.hpp"

#include <qcustomplot.h>

namespace jointid::gui {
namespace {

constexpr double mark_height = 0.07;  // of the diagram

/// Frequency across, share of the diagram's height down.
void place(QCPItemPosition& at, QCPAxisRect& rect, double frequency_hz, double share) {
  at.setAxisRect(&rect);
  at.setTypeX(QCPItemPosition::ptPlotCoords);
  at.setTypeY(QCPItemPosition::ptAxisRectRatio);
  at.setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  at.setCoords(frequency_hz, share);
}

void draw_band(QCPAxisRect& rect, double low, double high, const QColor& colour) {
  auto* band = new QCPItemRect(rect.parentPlot());
  band->setClipAxisRect(&rect);
  band->setLayer(QStringLiteral("background"));
  band->setPen(Qt::NoPen);
  band->setBrush(colour);
  place(*band->topLeft, rect, low, 0.0);
  place(*band->bottomRight, rect, high, 1.0);
}

void draw_points(QCustomPlot& plot, QCPLayer& layer, const Drawing& drawing, double frequency_hz) {
  for (std::size_t i = 0; i < drawing.curves.size(); ++i) {
    const Curve& curve = drawing.curves[i];
    const std::size_t line = nearest_line(curve, frequency_hz);
    const Complex value = curve.values[line] * frf::from_receptance(drawing.quantity, curve.frequency_hz[line]);
    auto* mark = new QCPItemTracer(&plot);
    mark->setLayer(&layer);
    mark->setStyle(QCPItemTracer::tsCircle);
    mark->setSize(9);
    mark->setPen(QPen(colours(drawing.theme).text));
    mark->setBrush(curve_colour(drawing.theme, static_cast<int>(i)));
    mark->position->setCoords(value.real(), value.imag());
  }
}

}  // namespace

void draw_bands(QCPAxisRect& rect, const std::vector<ident::Range>& excluded, const std::optional<ident::Range>& range,
                const ident::Range& span, Theme theme) {
  const Colours use = colours(theme);
  for (const auto& [low, high] : excluded) draw_band(rect, low, high, use.band);
  if (!range) return;
  QColor outside = use.weak_text;
  outside.setAlpha(40);
  if (span[0] < (*range)[0]) draw_band(rect, span[0], (*range)[0], outside);
  if (span[1] > (*range)[1]) draw_band(rect, (*range)[1], span[1], outside);
}

void draw_marks(QCPAxisRect& rect, const std::vector<double>& marked_hz, Theme theme) {
  for (const double frequency_hz : marked_hz) {
    auto* stroke = new QCPItemLine(rect.parentPlot());
    stroke->setClipAxisRect(&rect);
    stroke->setPen(QPen(colours(theme).error, 2));
    place(*stroke->start, rect, frequency_hz, 1.0);
    place(*stroke->end, rect, frequency_hz, 1.0 - mark_height);
  }
}

void draw_cursor(QCustomPlot& plot, QCPLayer& layer, const Drawing& drawing, double frequency_hz) {
  if (drawing.view == View::nyquist) return draw_points(plot, layer, drawing, frequency_hz);
  for (QCPAxisRect* rect : plot.axisRects()) {
    auto* line = new QCPItemStraightLine(&plot);
    line->setLayer(&layer);
    line->setClipAxisRect(rect);
    line->setPen(QPen(colours(drawing.theme).text, 1, Qt::DashLine));
    place(*line->point1, *rect, frequency_hz, 0.0);
    place(*line->point2, *rect, frequency_hz, 1.0);
  }
}

}  // namespace jointid::gui
