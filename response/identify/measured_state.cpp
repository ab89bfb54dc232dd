#include "response/identify/measured_state.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace jointid::response {
namespace {

[[noreturn]] void fail_state(std::size_t state, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = "",
                    .place = "measured state " + std::to_string(state + 1),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

std::string size_text(const Eigen::Index rows, const Eigen::Index columns) {
  return std::to_string(rows) + " × " + std::to_string(columns);
}

void require_sizes(const MeasuredState& state, const Receptance& structure, std::size_t place) {
  const Eigen::Index rows = at(state.harmonics.size()), columns = structure.responses();
  const std::string wanted = size_text(rows, columns) + ": harmonics × responses of the structure";
  if (state.response.rows() != rows || state.response.cols() != columns)
    fail_state(place, "its responses are " + size_text(state.response.rows(), state.response.cols()), "give " + wanted);
  if (state.deviation.rows() != rows || state.deviation.cols() != columns)
    fail_state(place, "its deviations are " + size_text(state.deviation.rows(), state.deviation.cols()), "give " + wanted);
  if (state.force.amplitudes.cols() != structure.forces() || state.force.amplitudes.rows() != at(state.force.harmonics.size()))
    fail_state(place, "its forces are " + size_text(state.force.amplitudes.rows(), state.force.amplitudes.cols()),
               "give harmonics × forces of the structure, of which there are " + std::to_string(structure.forces()));
  if (state.force_deviation.size() > 0 && (state.force_deviation.rows() != state.force.amplitudes.rows() ||
                                           state.force_deviation.cols() != state.force.amplitudes.cols()))
    fail_state(place, "the deviations of its forces are " + size_text(state.force_deviation.rows(), state.force_deviation.cols()),
               "give as many as there are forces and harmonics of them, or none");
}

void require_numbers(const MeasuredState& state, std::size_t place) {
  if (!(state.omega > 0.0)) fail_state(place, std::to_string(state.omega) + " rad/s is no frequency", "frequencies are above 0");
  if (!state.response.allFinite() || !state.force.amplitudes.allFinite())
    fail_state(place, "a phasor is not finite", "leave that line out");
  if (!((state.deviation.array() > 0.0).all() && state.deviation.allFinite()))
    fail_state(place, "a standard deviation is not above 0",
               "give how exact every phasor is; without repeats, a share of its size");
  if (!state.force_deviation.allFinite() || (state.force_deviation.array() < 0.0).any())
    fail_state(place, "a standard deviation of a force is not a number from 0 on", "give how exact the force is, 0 where it is");
}

}  // namespace

Eigen::Index measured_numbers(const MeasuredState& state) {
  const bool mean = std::ranges::find(state.harmonics, 0) != state.harmonics.end();
  return (2 * at(state.harmonics.size()) - (mean ? 1 : 0)) * state.response.cols();
}

Eigen::Index measured_numbers(const std::vector<MeasuredState>& states) {
  Eigen::Index sum = 0;
  for (const MeasuredState& state : states) sum += measured_numbers(state);
  return sum;
}

Eigen::VectorXd in_deviations(const MeasuredState& state, const Eigen::MatrixXcd& responses) {
  Eigen::VectorXd numbers(measured_numbers(state));
  Eigen::Index row = 0;
  for (Eigen::Index n = 0; n < responses.rows(); ++n) {
    for (Eigen::Index r = 0; r < responses.cols(); ++r) {
      const Complex value = responses(n, r) / state.deviation(n, r);
      numbers(row++) = value.real();
      if (state.harmonics[static_cast<std::size_t>(n)] > 0) numbers(row++) = value.imag();
    }
  }
  return numbers;
}

void add_in_deviations(const MeasuredState& state, int harmonic, const Eigen::Ref<const Eigen::MatrixXd>& responses,
                       Eigen::Ref<Eigen::MatrixXd> columns) {
  Eigen::Index row = 0;
  for (Eigen::Index n = 0; n < state.response.rows(); ++n) {
    const int number = state.harmonics[static_cast<std::size_t>(n)];
    const Eigen::Index parts = number > 0 ? 2 : 1;
    for (Eigen::Index r = 0; r < state.response.cols(); ++r, row += parts) {
      if (number == harmonic) columns.middleRows(row, parts) += responses.middleRows(2 * r, parts) / state.deviation(n, r);
    }
  }
}

void require_valid(const std::vector<MeasuredState>& states, const Receptance& structure) {
  if (states.empty()) {
    throw InputError({.kind = ErrorKind::data,
                      .file = "",
                      .place = "measured states",
                      .problem = "there is none",
                      .remedy = "give responses of the assembly at one force level at least"});
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    require_sizes(states[i], structure, i);
    require_numbers(states[i], i);
    const Harmonics ascending(states[i].harmonics);
    for (const int n : ascending.numbers()) {
      if (structure.covers(n * states[i].omega)) continue;
      fail_state(
          i, "the structure is not known at harmonic " + std::to_string(n) + " of " + std::to_string(states[i].omega) + " rad/s",
          "leave that harmonic out, or give FRFs of the parts there");
    }
  }
}

std::vector<MeasuredState> some_lines(const std::vector<MeasuredState>& states, std::size_t count, double share) {
  std::set<double> all;
  for (const MeasuredState& state : states) all.insert(state.omega);
  if (all.size() < 2 * count) return {};
  const std::vector<double> lines(all.begin(), all.end());
  std::set<double> chosen;
  for (std::size_t stretch = 0; stretch < count; ++stretch) {
    const double place = (static_cast<double>(stretch) + share) * static_cast<double>(lines.size()) / static_cast<double>(count);
    chosen.insert(lines[std::min(lines.size() - 1, static_cast<std::size_t>(place))]);
  }
  std::vector<MeasuredState> some;
  std::ranges::copy_if(states, std::back_inserter(some),
                       [&](const MeasuredState& state) { return chosen.contains(state.omega); });
  return some;
}

}  // namespace jointid::response
