#include "response/identify/corrected_models.hpp"

#include <algorithm>
#include <optional>

#include "response/structure/corrected_receptance.hpp"

namespace jointid::response {
namespace {

/// With the errors of its forces taken off.
MeasuredState corrected_state(MeasuredState measured, std::size_t state, const LineLayout::Line& line,
                              const Eigen::VectorXd& errors) {
  for (const LineLayout::Force& force : line.forces) {
    if (force.state != state) continue;
    const Eigen::Index row = measured.force.row(force.number);
    for (Eigen::Index p = 0; p < measured.force_deviation.cols(); ++p) {
      const Eigen::Index place = force.first + 2 * p;
      measured.force.amplitudes(row, p) += measured.force_deviation(row, p) * Complex(errors(place), errors(place + 1));
    }
  }
  return measured;
}

}  // namespace

std::vector<StateModel> corrected_models(const std::shared_ptr<const Receptance>& structure,
                                         const std::vector<MeasuredState>& states, const LineLayout& layout,
                                         const LineErrors& errors, const std::vector<int>& harmonics) {
  std::vector<std::optional<StateModel>> models(states.size());
  for (std::size_t i = 0; i < layout.lines().size(); ++i) {
    const LineLayout::Line& line = layout.lines()[i];
    const auto corrected = std::make_shared<CorrectedReceptance>(structure);
    for (const auto& [number, first, count] : line.harmonics)
      corrected->correct(number * line.omega, errors[i].segment(first, count));
    for (const std::size_t state : line.states)
      models[state].emplace(
          corrected, line.forces.empty() ? states[state] : corrected_state(states[state], state, line, errors[i]), harmonics);
  }
  std::vector<StateModel> all;
  for (auto& model : models) all.push_back(std::move(*model));
  return all;
}

LineErrors carried(const LineLayout& from, const LineErrors& errors, const LineLayout& to) {
  LineErrors out = to.no_errors();
  for (std::size_t i = 0; i < to.lines().size(); ++i) {
    const LineLayout::Line &target = to.lines()[i], &source = from.lines()[i];
    for (const auto& [number, first, count] : target.harmonics) {
      const auto same = std::ranges::find(source.harmonics, number, &LineLayout::Harmonic::number);
      if (same != source.harmonics.end()) out[i].segment(first, count) = errors[i].segment(same->first, count);
    }
    for (const LineLayout::Force& force : target.forces) {
      const auto same = std::ranges::find_if(source.forces, [&](const LineLayout::Force& other) {
        return other.state == force.state && other.number == force.number;
      });
      if (same != source.forces.end()) out[i].segment(force.first, force.count) = errors[i].segment(same->first, force.count);
    }
  }
  return out;
}

double squared_norm(const LineErrors& errors) {
  double sum = 0.0;
  for (const Eigen::VectorXd& line : errors) sum += line.squaredNorm();
  return sum;
}

}  // namespace jointid::response
