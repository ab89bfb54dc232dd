#pragma once

#include <optional>
#include <vector>

#include "frf/set/frf_system.hpp"
#include "response/structure/receptance.hpp"

namespace jointid::response {

/// The two ends of a joint; without a negative end it is fixed to ground. q = x(positive) − x(negative).
struct JointEnds {
  frf::Dof positive;
  std::optional<frf::Dof> negative;
};

/// DOFs without repeats, and the sums of them that rows or columns are: joints first, then single DOFs.
struct FrfCombination {
  std::vector<frf::Dof> dofs;
  Eigen::MatrixXd weights;  ///< [dof, row or column]
};

/// Receptances from FRFs of uncoupled parts: WᵀHW = (H_a)_jj + (H_b)_jj for a joint between two of them (R4.33). Of the files
/// only the rows joint and response and the columns joint and force are read, at all lines. There is no mass, stiffness or mode
/// shape.
class FrfReceptance final : public Receptance {
 public:
  /// Throws InputError (data) with the DOFs that are not measured, or with the first FRF without a number.
  FrfReceptance(frf::FrfSystem& parts, const std::vector<JointEnds>& joints, const std::vector<frf::Dof>& responses,
                const std::vector<frf::Dof>& forces);

  Eigen::Index joints() const override { return joints_; }
  Eigen::Index responses() const override { return responses_; }
  Eigen::Index forces() const override { return forces_; }
  bool covers(double omega) const override;
  Eigen::MatrixXcd at(double omega) const override;
  std::optional<Eigen::MatrixXcd> derivative(double) const override { return std::nullopt; }
  double nearest(double omega) const override;

  /// From the variances or coherences of the files, one error for each FRF that was read. An FRF that is a copy of its transpose
  /// shares its error.
  std::vector<ReceptanceError> errors(double omega) const override;
  /// Whether every file has variances or coherences.
  bool knows_errors() const { return !variances_.empty(); }

  const std::vector<double>& frequency_hz() const { return frequency_hz_; }

  /// The FRFs read, row_dofs() × column_dofs() of a line, and their variances (empty if a file has none).
  const std::vector<frf::Dof>& row_dofs() const { return rows_.dofs; }
  const std::vector<frf::Dof>& column_dofs() const { return columns_.dofs; }
  const Eigen::MatrixXcd& measured(std::size_t line) const { return measured_[line]; }
  const std::vector<Eigen::MatrixXcd>& variances() const { return variances_; }

 private:
  std::size_t nearest_line(double omega) const;

  Eigen::Index joints_, responses_, forces_;
  std::vector<double> frequency_hz_;
  std::vector<Eigen::MatrixXcd> lines_;     ///< as at() gives them
  std::vector<Eigen::MatrixXcd> measured_;  ///< of the FRFs between the DOFs of rows_ and columns_
  FrfCombination rows_, columns_;
  std::vector<Eigen::MatrixXcd>
      variances_;                   ///< [line] of the FRFs between the DOFs of rows_ and columns_; none when a file has none
  std::vector<Eigen::Index> twin_;  ///< of each FRF, by column, the place of the transpose that is a copy of it, or −1
};

}  // namespace jointid::response
