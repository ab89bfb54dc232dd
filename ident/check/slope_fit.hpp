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
