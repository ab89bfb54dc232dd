#pragma once

#include <QString>
#include <string>

#include "gui/look/theme.hpp"
#include "gui/plot/curve.hpp"
#include "ident/scene/scene.hpp"

class QCPAxis;
class QCPAxisRect;
class QCPGraph;
class QCustomPlot;

/// How curves become diagrams of a QCustomPlot.
namespace jointid::gui {

struct Drawing {
  const std::vector<Curve>& curves;
  View view;
  frf::Quantity quantity;
  ident::Range shown_hz;
  Theme theme;
  bool decibel = false;
};

/// Numbers at axes as in tables and read-outs, in every language: 0.4 and 10⁻⁵.
void speak_numbers(QCustomPlot& plot);

/// The text of an axis in the language of the window, where that knows it, or the name before its unit.
QString axis_text(const std::string& label);

/// The curve of a Drawing that a graph shows.
std::size_t curve_of(const QCPGraph& graph);

/// Ticks with as many digits as tell neighbours apart.
void tell_ticks_apart(QCPAxis& axis);

/// Colours of axes and grids; ticks that tell neighbours apart.
void style_axes(QCPAxisRect& rect, Theme theme);

/// What to do, in the middle of an empty plot.
void draw_hint(QCustomPlot& plot, const QString& hint, Theme theme);

/// One legend above all, with names in lines of two.
void add_legend(QCustomPlot& plot, Theme theme);

/// As many names beside each other as the plot is wide.
void wrap_legend(QCustomPlot& plot);

/// The diagrams of the view below each other, with their names above.
void draw_panels(QCustomPlot& plot, const Drawing& drawing);

void draw_nyquist(QCustomPlot& plot, const Drawing& drawing);

/// A diagram of draw_panels() over the shown frequencies, with all that the curves do there.
void fit_axes(QCPAxisRect& rect, const ident::Range& shown_hz);

/// Where all values are one: a fifth of it on either side, or a power of ten; 1 about 0. Other values leave the axis as it is.
void give_room(QCPAxis& axis, const std::vector<double>& values);

/// From the first to the last frequency of all curves; of a single line a hertz around it.
ident::Range span_of(const std::vector<Curve>& curves);

}  // namespace jointid::gui
