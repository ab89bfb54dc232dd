#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "minimise/gauss_newton.hpp"
#include "response/identify/fit_work.hpp"
#include "response/identify/law_unknowns.hpp"
#include "response/identify/lifted_fit.hpp"
#include "response/identify/line_correlation.hpp"

namespace jointid::response {

/// A fit with the harmonics of one model.
struct FitOfHarmonics {
  minimise::GaussNewtonResult result;
  std::vector<StatePrediction> states;
  /// Of the receptances where they are unknown, too, and their layout.
  std::optional<LineLayout> layout{};
  LineErrors errors{};
};

/// How fits are made.
struct FitWays {
  bool nuisance = false;     ///< the receptances are unknowns of their own
  FitWork work{};
  minimise::GaussNewtonOptions steps{};
};

/// Fits of the same states with one model after the other.
class HarmonicsFits {
 public:
  HarmonicsFits(std::shared_ptr<const Receptance> structure, const std::vector<MeasuredState>& states, const LawUnknowns& unknowns,
                const FitWays& ways);

  /// From the values of the unknowns: by fit_lifted, with tighter tolerances where it misses the data a little, then by harmonic
  /// balance. Where that does not end in a minimum, or no direct step starts it, by harmonic balance alone, first with the
  /// receptances as measured.
  FitOfHarmonics first(const std::vector<int>& harmonics, double enough) const;
  /// No fit: residuals and states at some values of the unknowns.
  FitOfHarmonics at(const std::vector<int>& harmonics, const Eigen::VectorXd& numbers) const;
  /// From another fit by harmonic balance; where that finds no minimum, by fit_lifted first. `enough`: GaussNewtonOptions.
  FitOfHarmonics next(const std::vector<int>& harmonics, const FitOfHarmonics& before, double enough) const;

 private:
  FitOfHarmonics plain(const std::vector<int>& harmonics, const Eigen::VectorXd& start, std::vector<StatePrediction> from,
                       double enough) const;
  FitOfHarmonics from_lifted(const std::vector<int>& harmonics, std::optional<LiftedFit> lifted, double enough) const;
  FitOfHarmonics from(const std::vector<int>& harmonics, const FitOfHarmonics& before, double enough) const;
  FitOfHarmonics with_nuisance(const std::vector<int>& harmonics, const FitOfHarmonics& before, double enough) const;
  minimise::GaussNewtonOptions steps(double enough) const;

  std::shared_ptr<const Receptance> structure_;
  const std::vector<MeasuredState>& states_;
  const LawUnknowns& unknowns_;
  FitWays ways_;
};

/// Whether the structure tells errors of its receptances at a measured harmonic, or a state those of its forces.
bool knows_errors(const Receptance& structure, const std::vector<MeasuredState>& states);

}  // namespace jointid::response
