#pragma once

#include <span>
#include <vector>

#include "ident/equations/kronecker.hpp"
#include "ident/equations/rounding_scale.hpp"
#include "ident/equations/row_expander.hpp"
#include "ident/plan/unknown_columns.hpp"
#include "minimise/linear/accumulator.hpp"
#include "weighting/line_weights.hpp"

namespace jointid::ident {

/// Equations whose coefficients touch the same unknowns: those of the columns of B that belong to one group.
struct Support {
  std::vector<std::size_t> a_dofs, b_dofs;  ///< elements a_dofs × b_dofs of Z_j have coefficients
  std::vector<std::size_t> unknowns;        ///< ascending
};

/// How lines become rows; fixed by the plan.
struct AssemblySpec {
  const restrictions::Restriction* restriction = nullptr;
  const UnknownColumns* columns = nullptr;
  weighting::Weighting weighting = weighting::Weighting::none;
  double delta = 0.0;
  double omega0 = 0.0;                     ///< rad/s, reference of T_f: the highest used frequency
  std::vector<Support> supports;           ///< at least one
  std::vector<std::size_t> column_support; ///< [L] which support a column of B belongs to
  std::vector<RowExpander> expanders;      ///< one per support, made by make_expanders()
  bool is_of_part = false;  ///< A has the columns and B the rows of the only support alone
};

/// Expanders of all supports; the plan makes them once, each assembler works on copies.
void make_expanders(AssemblySpec& spec);

struct EquationCount {
  std::size_t used = 0;
  std::size_t dropped = 0;
  std::size_t rows = 0;  ///< real rows written, after compression
};

/// Turns the equations of one line after the other into weighted, compressed real rows of an accumulator:
/// missing and zero equations and the Δ filter, weights, Kronecker compression per set of columns with the same mask (or
/// none where that is cheaper by counted flops), T_f and T.
class LineAssembler {
 public:
  /// With `measures_rounding`, rounding() is kept up; it takes about as long as reading C once.
  /// `shared`: where rounding is added up instead.
  explicit LineAssembler(const AssemblySpec& spec, bool measures_rounding = false, RoundingScale* shared = nullptr);

  void add(const minimise::LineProduct& line, minimise::Accumulator& accumulator);

  /// Since construction or the last reset.
  void reset_counts() {
    count_ = {};
    lines_used_ = 0;
    rounding_ = {};
  }
  const EquationCount& count() const { return count_; }
  std::size_t lines_used() const { return lines_used_; }
  const RoundingScale& rounding() const { return rounding_; }

 private:
  struct Group {
    std::size_t support = 0;
    std::vector<std::size_t> rows, columns;
    std::vector<double> row_weight, column_weight;
    std::size_t equations_written = 0, row_length = 0;  ///< while WA waits for its factor
  };

  /// Rows to write: real ones (two per equation) or complex ones (one).
  struct Rows {
    double* data;
    std::size_t stride, count;
  };

  bool find_columns(double frequency_hz);
  void measure(const minimise::LineProduct& line);
  bool mask(const minimise::LineProduct& line);
  void weigh(const minimise::LineProduct& line, bool regular);
  void group(const minimise::LineProduct& line, bool regular);
  void compress(const minimise::LineProduct& line, const Group& group);
  SubProduct sub_product(const Group& group) const;
  void push(const minimise::LineProduct& line, const Group& group, minimise::Accumulator& accumulator);
  void push_weighted_after(const minimise::LineProduct& line, minimise::Accumulator& accumulator);
  Rows append(const Group& group, std::size_t equations, minimise::Accumulator& accumulator);
  bool is_complex(const Group& group, const minimise::Accumulator& accumulator) const;
  void expand(const Group& group, bool complex, std::size_t first, std::size_t count, const Rows& to);
  void measure_rounding(const minimise::LineProduct& line, double factor);
  void add_column_norms(const Group& group, bool complex, const Rows& rows);

  const AssemblySpec& spec_;
  bool measures_rounding_;
  RoundingScale rounding_;
  RoundingScale* shared_rounding_;
  std::vector<std::size_t> a_places_, b_places_;  ///< of the only support of a part
  std::vector<RowExpander> expanders_;  ///< one per support
  KroneckerCompressor compressor_;
  Compressed compressed_;
  weighting::LineWeights weights_;
  std::vector<double> row_max_, column_max_;
  std::vector<std::uint8_t> keep_;
  std::vector<Group> groups_;
  std::size_t group_count_ = 0;
  const Group* factored_ = nullptr;  ///< whose A the compressor last factored at this line
  std::vector<double> line_rows_, norm2_, group_norm2_;
  std::vector<minimise::Accumulator::Columns> columns_;  ///< of each support's unknowns at this line
  EquationCount count_;
  std::size_t lines_used_ = 0;
};

}  // namespace jointid::ident
