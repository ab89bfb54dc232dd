#pragma once

#include <vector>

#include "base/random.hpp"
#include "ident/likelihood/fit/estimator.hpp"

namespace jointid::ident {

/// Values that every channel of a line would have without errors.
struct ExactLine {
  std::vector<Complex> sub_jn, sub_jj, asm_jn, asm_jj, drop_nn;
};

/// The FRFs that a fit with the result `theta` takes for true, in the order of the channels; empty for lines that it does not use.
std::vector<ExactLine> exact_lines(const LikelihoodData& data, const LinearisedLikelihood& fitted, const std::vector<double>& theta);

/// Data of a parametric bootstrap: exact values plus normal errors with the weights of the fit. Lines that the fit counts for
/// less have larger errors here: their variances are divided by the robust weight.
class SimulatedData final : public LikelihoodData {
 public:
  SimulatedData(const LikelihoodData& data, const std::vector<double>& line_weight);

  /// Draws one replicate; the errors of channel c of line i come from entry 5i + c of the stream.
  void draw(const std::vector<ExactLine>& exact, const RandomStream& stream);

  /// The weights stay as they are: they belong to the exact values already.
  bool variances_by_law() const override { return false; }
  void weigh_as_measured() override {}
  void weigh_at(std::size_t, const LineState&, const ComplexMatrix&) override {}
};

}  // namespace jointid::ident
