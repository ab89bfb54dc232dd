#pragma once

#include "ident/likelihood/line/line_data.hpp"
#include "ident/likelihood/line/line_state.hpp"
#include "minimise/blocks.hpp"

namespace jointid::ident {

/// Residuals of lifted_start(). Parameters are X, Y and all of A as measured value + scale · u, with scale as in ExplicitLine.
class LiftedLine final : public minimise::ResidualBlock {
 public:
  LiftedLine(const LineLayout& layout, const LineData& data, const ComplexMatrix& z);

  std::size_t residuals() const override { return rows_.size(); }
  std::vector<std::size_t> sizes() const override { return {scale_.size()}; }
  void set_penalty(double penalty) { penalty_ = penalty; }

  LineState state(const double* u) const;

  bool evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  /// A real number that should be `target`; `at` in the order x, y, a, d, conditions of stacked().
  struct Row {
    std::size_t at;
    bool imaginary;
    double weight, target;
    bool condition;
  };

  double weight_of(const Row& row) const { return row.condition ? penalty_ * row.weight : row.weight; }
  void add_scales(const Channel& channel, double size);
  void add_conditions(const LineData& data, std::size_t first);
  void shift(std::size_t variable, const Complex& by, LineState& state) const;
  std::vector<Complex> stacked(const LineState& state, const ComplexMatrix& d, const ComplexMatrix& condition) const;

  const LineLayout& layout_;
  ComplexMatrix z_;
  LineState measured_;
  std::vector<double> scale_;
  std::vector<Row> rows_;
  double penalty_ = 1.0;
};

}  // namespace jointid::ident
