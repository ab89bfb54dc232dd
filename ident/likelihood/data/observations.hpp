#pragma once

#include <functional>
#include <optional>

#include "ident/likelihood/data/estimated_frfs.hpp"
#include "ident/likelihood/data/frf_slopes.hpp"
#include "ident/likelihood/data/likelihood_data.hpp"
#include "ident/likelihood/data/scaled_line.hpp"
#include "ident/likelihood/data/systematic_lines.hpp"
#include "ident/plan/line.hpp"

namespace jointid::ident {

/// Which blocks of both systems the equations of a likelihood read: those that Method One reads for them. Without any H_nj of
/// the assembly (only H_nn measured) H_bb is needed too.
struct LikelihoodBlocks {
  Blocks substructures, assembly;
};

/// All measured FRFs of a problem with their variances, brought into the form of the likelihood.
class Observations final : public LikelihoodData {
 public:
  /// The layout is first that which the headers promise, then that of what was read.
  Observations(const Scene& scene, const Dofs& coordinates, std::size_t others, const LikelihoodBlocks& blocks,
               frf::FrfSystem& substructures, frf::FrfSystem& assembly);

  std::size_t entries_per_line() const { return substructures_.entries_per_line() + assembly_.entries_per_line(); }

  /// Reads the lines of a plan, those of this process where they are shared, replacing what was read before; `between` is called
  /// between chunks of lines.
  void read(const std::vector<Line>& lines, const std::function<void(std::size_t done)>& between, const LineShares& shares = {});

  /// As SymmetricFrfs, of both systems.
  void take_pairs_apart();

  /// Takes what was read as if some coordinates (numbers in LineLayout::coordinates) had not been measured: non-joint ones at
  /// all, joint ones on the assembly. Replaces what was left out before.
  void leave_out(const std::vector<std::size_t>& coordinates);

  bool variances_by_law() const override { return substructures_.variances_by_law() || assembly_.variances_by_law(); }
  void weigh_as_measured() override;
  void weigh_at(std::size_t line, const LineState& state, const ComplexMatrix& z) override;

  /// The FRFs that a state and a joint make of a line of this process (estimated_frfs()).
  BothSystems<Complex> estimated(std::size_t line, const LineState& state, const ComplexMatrix& z) const {
    return estimated_frfs(layout_, raw_[line - own_lines_.first], data_[line].drop_nn, state, z);
  }

  std::vector<FileVariances> origins() const;

  /// As SymmetricFrfs, of both systems.
  bool has_error_sums() const { return substructures_.has_error_sums() || assembly_.has_error_sums(); }
  void forget_error_sums();
  /// Of all FRFs of all lines, in all processes.
  bool has_independent_errors() const;

  /// Of all FRFs that were read, in all processes.
  MirrorDifferences mirror_differences() const;

  /// From now on these systematic errors are unknown, gains of FRFs; none: those of the scene, which must have none. What was read stays.
  void assume(SystematicPlan gains, frf::FrfSystem& substructures, frf::FrfSystem& assembly);

  /// What the scene says of systematic errors; nullptr where that is nothing.
  const SystematicPlan* systematic_plan() const { return systematic_lines_ ? &systematic_lines_->plan() : nullptr; }

  /// Where systematic errors that the scene says nothing of would be on a line of this process, in place of those of another line.
  void write_systematic_frfs(std::size_t line, const SystematicLines& errors, SystematicFrfs& out) const;

  /// Of the measured FRFs and their weights.
  std::size_t bytes() const;

 private:
  using Raw = BothMeasured;

  struct Errors {
    std::shared_ptr<const LineErrors> substructures, assembly;
  };

  std::optional<FrfSlopes> slopes(std::size_t own_line, bool of_assembly, const std::vector<std::size_t>& coordinates) const;
  void read_chunk(std::span<const std::size_t> substructure_lines, std::span<const std::size_t> assembly_lines);
  LineData data_of(std::size_t own_line, double omega) const;
  void reweigh(const std::vector<Element>& elements, Element origin, const SymmetricFrfs& system,
               const MeasuredFrfs& measured, const Symmetric<Complex>& values, Channel& channel) const;
  void reweigh_differences(const Raw& raw, const BothSystems<Complex>& values, Channel& channel) const;

  SymmetricFrfs substructures_, assembly_;
  std::unique_ptr<SystematicLines> systematic_lines_;
  std::unique_ptr<ScaledParts> scaled_parts_;  ///< where the scene's models have errors
  std::vector<Line> plan_lines_;
  std::vector<Complex> background_;  ///< of the substructures: zero across two parts, NaN elsewhere
  std::vector<Raw> raw_;        ///< of own_lines_
  std::vector<Errors> errors_;  ///< of own_lines_, where there are covariances
  LineShares::Range own_lines_;
  MirrorDifferences differences_;
};

}  // namespace jointid::ident
