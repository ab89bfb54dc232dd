#include "report/text/frf_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "report/text/frf_criteria.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t width = 72, height = 18;
constexpr char measured_mark = 'o', predicted_mark = '.', both_mark = '@';

double decibel(const Complex& value) { return 20.0 * std::log10(std::abs(value)); }

/// Smallest and largest finite level of both curves, widened to whole 10 dB.
std::pair<double, double> limits(const tasks::RegeneratedFrf& frf) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto* curve : {&frf.measured, &frf.predicted}) {
    for (const Complex& value : *curve) {
      const double level = decibel(value);
      if (!std::isfinite(level)) continue;
      low = std::min(low, level);
      high = std::max(high, level);
    }
  }
  return {10.0 * std::floor(low / 10.0), 10.0 * std::ceil(high / 10.0)};
}

class Canvas {
 public:
  Canvas(double low, double high) : low_(low), step_(std::max(high - low, 10.0) / (height - 1)) {}

  /// One column's level; several lines that fall into a column are several marks.
  void mark(std::size_t column, double level, char symbol) {
    if (!std::isfinite(level)) return;
    const double place = std::clamp((level - low_) / step_, 0.0, static_cast<double>(height - 1));
    char& cell = rows_[height - 1 - static_cast<std::size_t>(std::lround(place))][column];
    cell = cell == ' ' || cell == symbol ? symbol : both_mark;
  }

  std::string text() const {
    std::string out;
    for (std::size_t row = 0; row < height; ++row) {
      const double level = low_ + step_ * static_cast<double>(height - 1 - row);
      const bool labelled = row == 0 || row == height - 1 || row == height / 2;
      out += labelled ? fmt::format("{:7.0f} |", level) : std::string(8, ' ') + "|";
      out += rows_[row].substr(0, rows_[row].find_last_not_of(' ') + 1) + "\n";
    }
    return out;
  }

 private:
  double low_, step_;
  std::vector<std::string> rows_ = std::vector<std::string>(height, std::string(width, ' '));
};

}  // namespace

std::string frf_plot(const tasks::Regenerated& regenerated, const tasks::RegeneratedFrf& frf, const std::string& unit) {
  const auto [low, high] = limits(frf);
  const std::string title = fmt::format("assembly FRF {} / {}", frf.entry.response.name(), frf.entry.reference.name());
  if (!std::isfinite(low)) return "\n" + title + ": nothing to show, not measured or not synthesised\n";
  Canvas canvas(low, high);
  const std::vector<double>& axis = regenerated.frequency_hz;
  const double span = std::max(axis.back() - axis.front(), std::numeric_limits<double>::min());
  for (std::size_t line = 0; line < axis.size(); ++line) {
    const double place = (axis[line] - axis.front()) / span * static_cast<double>(width - 1);
    const auto column = static_cast<std::size_t>(std::lround(place));
    canvas.mark(column, decibel(frf.measured[line]), measured_mark);
    canvas.mark(column, decibel(frf.predicted[line]), predicted_mark);
  }
  std::string out = fmt::format("\n{}, dB re 1 {}: {} measured, {} synthesised, {} both\n", title, unit, measured_mark,
                                predicted_mark, both_mark);
  out += canvas.text();
  out += fmt::format("{:8}+{:-<{}}\n{:9}{:<{}g}{:>10g} Hz\n", "", "", width, "", axis.front(), width - 13, axis.back());
  if (const auto error = tasks::decibel_error(frf)) {
    const std::string alike = criteria_text(frf.measured, frf.predicted);
    out += fmt::format("  rms difference {:.3g} dB{}{}\n", *error, alike.empty() ? "" : ", ", alike);
  }
  return out;
}

}  // namespace jointid::report
