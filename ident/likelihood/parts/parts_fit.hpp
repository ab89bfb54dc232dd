#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "ident/likelihood/parts/group_linearisation.hpp"
#include "ident/likelihood/parts/parts_data.hpp"
#include "minimise/linear/sparse_qr.hpp"

namespace jointid::ident {

/// A fit of all groups.
struct PartsFit {
  std::vector<double> theta;                 ///< scaled unknowns
  double cost = 0.0;                         ///< Σ |error|²/variance; twice that is χ²
  std::vector<double> group_cost, line_cost;
  minimise::SparseSymmetric information;     ///< N = Σ Re AᴴM⁻¹A: half of Fisher's, were the errors of each group its own
  std::size_t iterations = 0;
  bool converged = false;
};

struct PartsFitOptions {
  std::size_t threads = 1;
  std::function<void(const PartsFit&)> step{};  ///< after each step that lowers the cost; may throw to end the fit
};

/// Steps N δ = −g, damped while they do not lower the cost, the FRFs of each group settled at every joint; variances at the corrected
/// FRFs after each descent, until the unknowns stay. Leaves the corrected FRFs in `data`.
PartsFit fit_by_parts(const Plan& plan, const PartGroups& groups, PartsData& data, std::vector<double> start,
                      const PartsFitOptions& options);

/// N⁻¹b, N with unit diagonal meanwhile; empty where N is not positive definite.
class InformationSolver {
 public:
  explicit InformationSolver(const minimise::SparseSymmetric& information);
  bool is_definite() const { return definite_; }
  std::vector<double> operator()(std::vector<double> right) const;

 private:
  std::vector<double> scale_;
  std::unique_ptr<minimise::SparseFactor> factor_;
  bool definite_ = false;
};

}  // namespace jointid::ident
