#pragma once

#include <cstdint>
#include <vector>

#include "ident/likelihood/rows/element_rows.hpp"
#include "ident/likelihood/line/line_data.hpp"
#include "ident/likelihood/line/line_factors.hpp"
#include "ident/likelihood/line/line_state.hpp"
#include "ident/likelihood/rows/normal_rows.hpp"
#include "ident/plan/joint_impedance.hpp"

namespace jointid::ident {

/// The rows of measured A, B and D of a line without correlated errors, as LineModel has them, eight elements at a time: column by column
/// of X those that touch it, of which each is counted once for what all rows have in common.
class PlainRows {
 public:
  explicit PlainRows(const LineLayout& layout);

  /// Adds their squares to `normal`, which has columns for the unknowns of `joint` and of `terms` or, without them, none.
  void add_to(NormalRows& normal, const LineData& data, const LineState& state, const LineFactors& factors, const JointImpedance* joint,
              const SystematicTerms* terms);

 private:
  static constexpr std::uint32_t no_run = 0xffffffff;

  /// Elements that touch a column of X.
  struct Group {
    std::uint32_t run;             ///< the column, or none
    std::size_t first, own, more;  ///< in the slots below: those counted here, then those that another column counts
  };

  struct Cross {
    std::uint32_t element, row, column;  ///< of D
  };

  void add_group(std::uint32_t run);
  void add_slot(std::uint32_t element, std::uint32_t left, std::uint32_t right, double by_left, double by_right);
  std::size_t fill_up(std::size_t first);
  void fill_tables(const LineState& state, const LineFactors& factors);
  void fill_elements(const LineData& data, const LineState& state);
  ElementGroup group_of(std::size_t first, std::size_t count) const;
  std::span<const std::uint32_t> rows_of(std::uint32_t run) const;
  void add_runs(const Group& group, const RowShape& shape, const ElementTables& tables, const SystematicTerms* terms, NormalRows& normal);
  void put_terms(std::size_t first, std::size_t count, const RowShape& shape, const SystematicTerms& terms, RowColumns tails) const;
  void flush(std::size_t width, NormalRows& normal);

  const LineLayout& layout_;
  std::vector<std::uint32_t> y_row_, y_column_, x_row_;
  std::vector<Group> groups_;
  std::vector<Cross> crosses_;
  std::vector<std::uint32_t> element_, left_, right_;  ///< of every slot; one element more than there are fills up
  std::vector<double> by_left_, by_right_;
  std::size_t elements_ = 0, most_own_ = 0, most_more_ = 0;

  std::vector<double> left_table_, right_table_, room_;
  std::vector<Complex> weight_, base_;  ///< of every element
  std::vector<double> weight_re_, weight_im_, base_re_, base_im_;  ///< of every slot
  std::vector<double> tails_, heads_, more_tails_, more_heads_;
  std::size_t stride_ = 0, own_stride_ = 0, more_stride_ = 0;  ///< of tails_, heads_ and the others
  std::size_t rows_ = 0;                                       ///< in tails_ since they were added up
};

}  // namespace jointid::ident
