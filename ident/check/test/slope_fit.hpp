#pragma once

#include <cmath>
#include <utility>
#include <vector>

namespace jointid::ident {

/// A factor by least squares over lines, Σ slope / Σ square, whose standard deviation is told by the scatter of the lines.
class SlopeFit {
 public:
  void add(double slope, double square) {
    slope_ += slope;
    square_ += square;
    lines_.emplace_back(slope, square);
  }

  bool is_told() const { return square_ > 0.0; }
  double slope() const { return slope_; }
  double square() const { return square_; }
  double value() const { return slope_ / square_; }

  /// Degrees of freedom of scatter(): how many lines tell of the factor, less the factor. (Σ square)²/Σ square² − 1: where one line tells
  /// nearly all, others scatter by what they know and not by what it does.
  double freedom() const {
    double squares = 0.0;
    for (const auto& [slope, square] : lines_) squares += square * square;
    return squares > 0.0 ? square_ * square_ / squares - 1.0 : 0.0;
  }

  /// √Σ (slope − value·square)²: of the slope, and over square() of the value.
  double scatter() const {
    double sum = 0.0;
    for (const auto& [slope, square] : lines_) sum += std::pow(slope - value() * square, 2);
    return std::sqrt(sum);
  }

 private:
  double slope_ = 0.0, square_ = 0.0;
  std::vector<std::pair<double, double>> lines_;
};

}  // namespace jointid::ident
