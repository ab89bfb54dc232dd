#include "laws/task/simulated_levels.hpp"

#include <memory>
#include <set>
#include <utility>

#include "base/eigen.hpp"
#include "base/random.hpp"
#include "response/structure/corrected_receptance.hpp"

namespace jointid::laws {
namespace {

/// Standard normal numbers of one stream, one after the other.
class Numbers {
 public:
  explicit Numbers(RandomStream stream) : stream_(stream) {}
  double next() {
    if (second_) return *std::exchange(second_, std::nullopt);
    const auto [first, second] = normal_numbers(stream_, entry_++);
    second_ = second;
    return first;
  }

 private:
  RandomStream stream_;
  std::uint64_t entry_ = 0;
  std::optional<double> second_;
};

std::shared_ptr<const response::Receptance> drawn_parts(const AssumedStates& assumed, std::uint64_t seed, std::size_t trial) {
  std::set<double> lines;
  for (const response::MeasuredState& state : assumed.data.states) {
    for (const int n : assumed.harmonics) lines.insert(assumed.data.structure->nearest(n * state.omega));
  }
  Numbers noise({.seed = seed, .trial = trial, .set = 0});
  auto drawn = std::make_shared<response::CorrectedReceptance>(assumed.data.structure);
  for (const double omega : lines) {
    const std::size_t errors = assumed.data.structure->errors(omega).size();
    if (errors == 0) continue;
    Eigen::VectorXd deviations(2 * at(errors));
    for (double& each : deviations) each = noise.next();
    drawn->correct(omega, deviations);
  }
  return drawn;
}

/// The forces that were measured, about the true ones.
void draw_forces(std::uint64_t seed, std::size_t trial, std::vector<response::MeasuredState>& states) {
  Numbers noise({.seed = seed, .trial = trial, .set = 2});
  for (response::MeasuredState& state : states) {
    for (Eigen::Index k = 0; k < state.force_deviation.size(); ++k) {
      const double real = noise.next(), imaginary = noise.next();
      state.force.amplitudes(k) += state.force_deviation(k) * Complex(real, imaginary);
    }
  }
}

}  // namespace

std::optional<LevelStates> simulated_levels(const AssumedStates& assumed, std::uint64_t seed, std::size_t trial) {
  LevelStates data = assumed.data;
  const auto truth = drawn_parts(assumed, seed, trial);
  Numbers noise({.seed = seed, .trial = trial, .set = 1});
  for (response::MeasuredState& state : data.states) {
    const auto exact = responses_of(assumed, truth, state);
    if (!exact) return std::nullopt;
    for (Eigen::Index k = 0; k < exact->size(); ++k) {
      const double real = noise.next(), imaginary = noise.next();
      state.response(k) = (*exact)(k) + state.deviation(k) * Complex(real, imaginary);
    }
  }
  draw_forces(seed, trial, data.states);
  return data;
}

}  // namespace jointid::laws
