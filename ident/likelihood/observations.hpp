#pragma once

#include <functional>

#include "ident/likelihood/line_data.hpp"
#include "ident/likelihood/line_state.hpp"
#include "ident/likelihood/symmetric_frfs.hpp"
#include "ident/line.hpp"

namespace jointid::ident {

/// Which blocks of both systems the equations of a likelihood read: those that Method One reads for them. Without any H_nj of
/// the assembly (only H_nn measured) H_bb is needed too.
struct LikelihoodBlocks {
  Blocks substructures, assembly;
};

/// All measured FRFs of a problem with their variances, brought into the form of the likelihood.
class Observations {
 public:
  Observations(const Scene& scene, const Dofs& coordinates, std::size_t others, const LikelihoodBlocks& blocks,
               frf::FrfSystem& substructures, frf::FrfSystem& assembly);

  std::size_t entries_per_line() const { return substructures_.entries_per_line() + assembly_.entries_per_line(); }

  /// Reads the lines of a plan, replacing what was read before; `between` is called between chunks of lines.
  void read(const std::vector<Line>& lines, const std::function<void(std::size_t done)>& between);

  const LineLayout& layout() const { return layout_; }
  const std::vector<LineData>& lines() const { return data_; }

  /// Whether some variances follow a law of the value.
  bool variances_by_law() const { return substructures_.variances_by_law() || assembly_.variances_by_law(); }

  /// Weights of line `line` from the law at the values of `state` instead of the measured ones, at most a factor of two off
  /// what they were at first.
  void weigh_at(std::size_t line, const LineState& state, const ComplexMatrix& z);

  std::vector<FileVariances> origins() const;

  /// Of the measured FRFs and their weights.
  std::size_t bytes() const;

 private:
  struct Entry {
    Measured measured;
    bool averaged = false;
  };
  /// What was measured at one line, for all elements of the symmetric blocks.
  struct Raw {
    std::vector<Entry> x, y, a, b, sub_nn, asm_nn;
  };

  void append(const SymmetricFrfs& from, std::size_t i, bool substructures, Raw& raw) const;
  void choose_layout();
  LineData data_of(const Raw& raw, double omega) const;

  SymmetricFrfs substructures_, assembly_;
  LikelihoodBlocks blocks_;
  LineLayout layout_;
  std::vector<Line> plan_lines_;
  std::vector<Complex> background_;  ///< of the substructures: zero across two parts, NaN elsewhere
  std::vector<Element> all_jn_, all_jj_, all_nn_;
  std::vector<std::size_t> x_of_, y_of_, a_of_, b_of_, d_of_;  ///< element of the layout → of all_*
  std::vector<Raw> raw_;
  std::vector<LineData> data_;
};

}  // namespace jointid::ident
