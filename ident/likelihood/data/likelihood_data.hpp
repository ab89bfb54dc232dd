#pragma once

#include "ident/likelihood/line/line_data.hpp"
#include "ident/likelihood/line/line_state.hpp"
#include "ident/team/line_shares.hpp"

namespace jointid::ident {

/// What the likelihood is estimated from: weighted values line by line. Of lines that another process has (shares()) only `omega` and
/// `measured` are there.
class LikelihoodData {
 public:
  virtual ~LikelihoodData() = default;

  const LineLayout& layout() const { return layout_; }
  const std::vector<LineData>& lines() const { return data_; }
  const LineShares& shares() const { return shares_; }

  /// Unknown systematic errors; FRFs as in lines() have them.
  const std::vector<SystematicUnknown>& systematic() const { return systematic_; }

  /// Whether some variances follow a law of the value.
  virtual bool variances_by_law() const = 0;

  /// Weights from the variances at the measured values.
  virtual void weigh_as_measured() = 0;

  /// Weights of line `line` from the law at the values of `state` instead of the measured ones, at most a factor of two off
  /// what they were at first.
  virtual void weigh_at(std::size_t line, const LineState& state, const ComplexMatrix& z) = 0;

 protected:
  LineLayout layout_;
  std::vector<LineData> data_;
  LineShares shares_;
  std::vector<SystematicUnknown> systematic_;
};

}  // namespace jointid::ident
