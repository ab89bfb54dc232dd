#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "friction/fit/fit_options.hpp"
#include "friction/fit/fit_start.hpp"
#include "friction/path/parameter_scale.hpp"
#include "minimise/least_squares.hpp"

namespace jointid::friction {

/// The element of one curve at unknowns q, and ∂p/∂q of its parameters [parameters, unknowns].
struct CurveState {
  std::unique_ptr<Element> element;
  Eigen::MatrixXd by_unknown;
};

/// Weighted residuals of curves over the unknowns: parameters on their scale, one per curve or one for all. Where the law has a
/// friction limit, ln limit stands for the parameter that the limit determines (the others nearly decide how far a curve rises, so
/// this straightens the valley of the sum of squares); of a preset limit there is none, and with a friction coefficient ln μ.
class FitProblem final : public minimise::LeastSquares {
 public:
  /// Throws InputError for options that do not go together.
  FitProblem(std::span<const Curve> curves, const Family& family, const FitOptions& options);

  std::size_t unknowns() const override { return names_.size(); }
  std::size_t residuals() const override { return rows_; }
  bool evaluate(std::span<const double> q, std::span<double> r, std::span<double> jacobian) const override;

  /// Unknowns of the family's starts that fit each curve best, the second best of each, …
  const std::vector<std::vector<double>>& starts() const { return starts_; }
  /// "b", or with several curves "b of 50 kg" for what is not shared.
  const std::vector<std::string>& names() const { return names_; }
  /// Nothing where some parameter leaves its bounds.
  std::optional<CurveState> state(std::size_t curve, std::span<const double> q, bool with_derivative) const;

 private:
  std::vector<std::unique_ptr<Element>> best_starts(std::size_t curve, const Family& family) const;
  double squares(std::size_t curve, const Element& element) const;
  void choose_tied();
  void number_unknowns();
  std::vector<double> unknowns_of(std::span<const std::vector<std::unique_ptr<Element>>> elements, std::size_t rank) const;
  bool is_shared(std::size_t parameter) const;
  std::optional<std::size_t> limit_unknown(std::size_t curve) const;
  double target_limit(std::size_t curve, std::span<const double> q) const;

  std::span<const Curve> curves_;
  FitOptions options_;
  std::size_t rows_ = 0;
  std::vector<std::vector<double>> weights_;         ///< by curve and row
  std::vector<std::unique_ptr<Element>> prototypes_; ///< by curve: where it starts
  std::vector<Parameter> parameters_;
  std::vector<ParameterScale> scales_;
  std::optional<std::size_t> tied_;
  std::optional<std::size_t> coefficient_;           ///< unknown that is ln μ
  std::vector<std::vector<std::size_t>> unknown_of_; ///< by curve and parameter; of the tied one that of the limit, if it is unknown
  std::vector<std::string> names_;
  std::vector<std::vector<double>> starts_;
};

/// What the residuals of a curve's rows are multiplied by.
std::vector<double> row_weights(const Curve& curve, Weighting weighting);

}  // namespace jointid::friction
