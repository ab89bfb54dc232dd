#include "gui/plot/curve.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "base/statistics.hpp"
#include "base/text.hpp"
#include "gui/look/said.hpp"
#include "report/frf_curves.hpp"
#include "report/phase_branch.hpp"
#include "gui/plot/quoted.hpp"

namespace jointid::gui {
namespace {

std::vector<double> phases(const std::vector<Complex>& values) {
  std::vector<std::size_t> all(values.size());
  std::iota(all.begin(), all.end(), 0U);
  return report::phases_deg(values, all);
}

template <class Part>
std::vector<double> parts(const std::vector<Complex>& values, Part part) {
  std::vector<double> out;
  for (const Complex& value : values) out.push_back(part(value));
  return out;
}

/// Moves all phases into the period that they cross least, and away from ±180° where the phase of a driving point stays.
void choose_branch(Panel& panel) {
  panel.top = report::branch_end_deg(panel.ordinates);
  for (std::vector<double>& phases : panel.ordinates) {
    for (double& phase : phases) phase = report::within_branch(phase, panel.top);
  }
}

/// 20 log10 of the ratio, line by line.
std::vector<double> difference(const Curve& computed, const Curve& measured) {
  std::vector<double> out;
  for (std::size_t i = 0; i < computed.values.size(); ++i) {
    const double ratio = std::abs(computed.values[i]) / std::abs(measured.values[i]);
    out.push_back(ratio > 0.0 && std::isfinite(ratio) ? 20.0 * std::log10(ratio) : nan);
  }
  return out;
}

Panel difference_panel(const std::vector<Curve>& curves) {
  Panel panel{Said::tr("computed over measured (dB)").toStdString(), false, {}, 0.0};
  const Curve* measured = nullptr;
  for (const Curve& curve : curves) {
    if (curve.is_measured) measured = &curve;
    const bool both = !curve.is_measured && measured != nullptr && measured->values.size() == curve.values.size();
    panel.ordinates.push_back(both ? difference(curve, *measured) : std::vector<double>());
  }
  return panel;
}

std::string unit(const Curve& curve, frf::Quantity quantity) {
  static const std::map<frf::Quantity, std::string> per_time = {
      {frf::Quantity::receptance, ""}, {frf::Quantity::mobility, "/s"}, {frf::Quantity::accelerance, "/s²"}};
  return (curve.response.is_rotation() ? "rad" : "m") + per_time.at(quantity) + (curve.reference.is_rotation() ? "/(N·m)" : "/N");
}

/// As a cell of CSV, quotes doubled.
std::string number_or_nothing(double number) { return std::isfinite(number) ? digits(number, "%.17g") : ""; }

}  // namespace

std::vector<Complex> converted(const Curve& curve, frf::Quantity quantity) {
  std::vector<Complex> values = curve.values;
  if (quantity == frf::Quantity::receptance) return values;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] *= frf::from_receptance(quantity, curve.frequency_hz[i]);
  return values;
}

std::string unit_of(const std::vector<Curve>& curves, frf::Quantity quantity) {
  if (curves.empty()) return "";
  const std::string first = unit(curves.front(), quantity);
  const bool alike = std::ranges::all_of(curves, [&](const Curve& curve) { return unit(curve, quantity) == first; });
  return alike ? first : "SI";
}

namespace {

/// Magnitudes of a panel in dB over one unit.
void to_decibel(Panel& panel, const std::string& name, const std::string& unit) {
  panel.logarithmic = false;
  panel.label = name + " (dB re 1 " + unit + ")";
  for (std::vector<double>& ordinates : panel.ordinates) {
    for (double& each : ordinates) each = 20.0 * std::log10(each);
  }
}

}  // namespace

std::vector<Panel> panels(const std::vector<Curve>& curves, View view, frf::Quantity quantity, bool decibel) {
  const std::string in = " (" + unit_of(curves, quantity) + ")";
  if (view == View::nyquist) return {};
  if (view == View::difference) return {difference_panel(curves)};
  if (is_indicator(view)) {
    Panel panel{(view == View::sum ? Said::tr("sum of |H|").toStdString() : "CMIF") + in, true, {}, 0.0};
    for (const Curve& curve : curves) panel.ordinates.push_back(report::magnitudes(converted(curve, quantity)));
    if (decibel) to_decibel(panel, view == View::sum ? Said::tr("sum of |H|").toStdString() : "CMIF", unit_of(curves, quantity));
    return {panel};
  }
  if (view == View::coherence) {
    Panel panel{coherence_label, false, {}, 1.0};
    for (const Curve& curve : curves) panel.ordinates.push_back(curve.coherence);
    return {panel};
  }
  const bool polar = view == View::magnitude_phase;
  Panel first{polar ? said(frf::name(quantity).c_str()).toStdString() + in : Said::tr("real part").toStdString() + in, polar, {}, 0.0};
  Panel second{polar ? phase_label : Said::tr("imaginary part").toStdString() + in, false, {}, 0.0};
  for (const Curve& curve : curves) {
    const std::vector<Complex> values = converted(curve, quantity);
    first.ordinates.push_back(polar ? report::magnitudes(values)
                                    : parts(values, [](const Complex& value) { return value.real(); }));
    second.ordinates.push_back(polar ? phases(values) : parts(values, [](const Complex& value) { return value.imag(); }));
  }
  if (polar) choose_branch(second);
  if (polar && decibel) to_decibel(first, said(frf::name(quantity).c_str()).toStdString(), unit_of(curves, quantity));
  return {first, second};
}

std::size_t nearest_line(const Curve& curve, double frequency_hz) {
  const std::vector<double>& axis = curve.frequency_hz;
  const auto above = static_cast<std::size_t>(std::ranges::lower_bound(axis, frequency_hz) - axis.begin());
  if (above == 0) return 0;
  if (above == axis.size()) return above - 1;
  return axis[above] - frequency_hz < frequency_hz - axis[above - 1] ? above : above - 1;
}

namespace {

std::string magnitude_text(const Curve& curve, const Complex& value, frf::Quantity quantity, bool decibel) {
  const std::string in = unit(curve, quantity);
  if (!decibel) return digits(std::abs(value), "%.4g") + " " + in;
  return digits(20.0 * std::log10(std::abs(value)), "%.2f") + " dB re 1 " + in;
}

std::string value_text(const Curve& curve, double at, frf::Quantity quantity, const ReadoutStyle& style) {
  const auto value = [&](std::size_t line) { return curve.values[line] * frf::from_receptance(quantity, curve.frequency_hz[line]); };
  const std::size_t line = nearest_line(curve, at);
  const double size = std::abs(value(line));
  if (!std::isfinite(size)) return Said::tr("not measured").toStdString();
  std::string text = magnitude_text(curve, value(line), quantity, style.decibel);
  if (curve.has_phase) text += " ∠ " + digits(std::arg(value(line)) * 180.0 / std::numbers::pi, "%.1f") + "°";
  if (!style.mark_hz) return text;
  const double ratio = size / std::abs(value(nearest_line(curve, *style.mark_hz)));
  return std::isfinite(ratio) && ratio > 0.0 ? text + ", Δ " + digits(20.0 * std::log10(ratio), "%+.2f") + " dB" : text;
}

}  // namespace

std::string readout(const std::vector<Curve>& curves, double frequency_hz, frf::Quantity quantity, const ReadoutStyle& style) {
  if (curves.empty()) return "";
  const double at = curves.front().frequency_hz[nearest_line(curves.front(), frequency_hz)];
  std::string text = digits(at, "%.6g") + " Hz";
  if (style.mark_hz)
    text += Said::tr(", Δ %1 Hz from %2 Hz")
                .arg(QString::fromStdString(digits(at - *style.mark_hz, "%+.6g")), QString::fromStdString(digits(*style.mark_hz, "%.6g")))
                .toStdString();
  for (std::size_t i = 0; i < std::min(style.most, curves.size()); ++i) {
    const Curve& curve = curves[i];
    text += "\n" + curve.name + ":  " + value_text(curve, at, quantity, style);
    if (!curve.coherence.empty()) text += ", γ² " + digits(curve.coherence[nearest_line(curve, at)], "%.3f");
  }
  if (curves.size() > style.most) text += "\n" + Said::tr("… and %1 more").arg(curves.size() - style.most).toStdString();
  return text;
}

std::string curves_table(const std::vector<Curve>& curves, frf::Quantity quantity, char separator) {
  std::string text = "frequency_hz";
  std::map<double, std::vector<std::string>> rows;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (const char* part : {"real", "imag"})
      text += separator + quoted(curves[i].name + " " + part + " (" + unit(curves[i], quantity) + ")");
    const std::vector<Complex> values = converted(curves[i], quantity);
    for (std::size_t line = 0; line < values.size(); ++line) {
      auto& row = rows[curves[i].frequency_hz[line]];
      row.resize(2 * curves.size());
      row[2 * i] = number_or_nothing(values[line].real());
      row[2 * i + 1] = number_or_nothing(values[line].imag());
    }
  }
  text += "\n";
  for (const auto& [frequency, cells] : rows) {
    text += digits(frequency, "%.17g");
    for (const std::string& cell : cells) text += separator + cell;
    text += "\n";
  }
  return text;
}

}  // namespace jointid::gui
