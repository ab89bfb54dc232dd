#include "ident/likelihood/findings/simulated_data.hpp"

#include <array>
#include <cmath>

#include "base/eigen.hpp"

namespace jointid::ident {
namespace {

std::vector<Complex> values_at(const std::vector<Element>& elements, const ComplexMatrix& matrix) {
  std::vector<Complex> out;
  for (const Element& e : elements) out.push_back(matrix(at(e.row), at(e.column)));
  return out;
}

ExactLine exact_line(const LineLayout& layout, const LineState& state, const ComplexMatrix& za) {
  ExactLine out{values_at(layout.sub_jn, state.sub_jn),
                values_at(layout.sub_jj, state.sub_jj),
                values_at(layout.asm_jn, state.asm_jn),
                {},
                {}};
  if (!layout.asm_jj.empty()) out.asm_jj = values_at(layout.asm_jj, state.asm_jj);
  for (const Element& e : layout.drop_nn) out.drop_nn.push_back(predicted_difference(state, za, e));
  return out;
}

double error(double normal, double weight) { return weight > 0.0 ? normal / weight : 0.0; }

/// Errors in parts of their deviations, for the channels of a line one after the other.
std::vector<Complex> draw_errors(const std::array<std::pair<const std::vector<Complex>*, Channel*>, 5>& channels,
                                 const minimise::Correlation* correlation, const RandomStream& stream,
                                 std::uint64_t first_entry) {
  std::vector<Complex> errors;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    for (std::size_t i = 0; i < channels[c].second->value.size(); ++i) {
      const auto normal = normal_numbers(stream, first_entry + c, i);
      errors.emplace_back(normal[0], normal[1]);
    }
  }
  if (correlation) correlation->colour(errors);
  return errors;
}

}  // namespace

std::vector<ExactLine> exact_lines(const LikelihoodData& data, const LinearisedLikelihood& fitted, const std::vector<double>& theta) {
  std::vector<ExactLine> out;
  for (std::size_t i = 0; i < data.lines().size(); ++i) {
    const LineState& state = fitted.state_of(i);
    if (state.sub_jn.rows() == 0) {
      out.emplace_back();
      continue;
    }
    out.push_back(exact_line(data.layout(), state, fitted.impedance_of(i, theta) * state.asm_jn));
  }
  return out;
}

SimulatedData::SimulatedData(const LikelihoodData& data, const std::vector<double>& line_weight) {
  layout_ = data.layout();
  data_ = data.lines();
  for (std::size_t i = 0; i < data_.size(); ++i) {
    LineData& line = data_[i];
    for (Channel* channel : {&line.sub_jn, &line.sub_jj, &line.asm_jn, &line.asm_jj, &line.drop_nn}) {
      for (Complex& weight : channel->weight) weight *= std::sqrt(line_weight[i]);
    }
  }
}

void SimulatedData::draw(const std::vector<ExactLine>& exact, const RandomStream& stream) {
  for (std::size_t i = 0; i < data_.size(); ++i) {
    LineData& line = data_[i];
    const std::array<std::pair<const std::vector<Complex>*, Channel*>, 5> channels = {{{&exact[i].sub_jn, &line.sub_jn},
                                                                                       {&exact[i].sub_jj, &line.sub_jj},
                                                                                       {&exact[i].asm_jn, &line.asm_jn},
                                                                                       {&exact[i].asm_jj, &line.asm_jj},
                                                                                       {&exact[i].drop_nn, &line.drop_nn}}};
    const std::vector<Complex> errors = draw_errors(channels, line.correlation.get(), stream, 5 * i);
    std::size_t next = 0;
    for (const auto& [values, channel] : channels) {
      for (std::size_t k = 0; k < channel->value.size(); ++k, ++next) {
        if (values->empty()) continue;  // a line that is not used
        const Complex weight = channel->weight[k];
        channel->value[k] = (*values)[k] + Complex(error(errors[next].real(), weight.real()), error(errors[next].imag(), weight.imag()));
      }
    }
  }
}

}  // namespace jointid::ident
