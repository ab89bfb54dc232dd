#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace jointid::problems {

/// A pulse as those of the thesis's chapter 3: three masses from rest, a joint between the second and the third, a half sine of
/// 36 N and 0.165 s on the first. The motion goes through many nested loops.
struct PulseProblem {
  std::string name;  ///< "pulse-bilinear" …
  std::string law;
  std::vector<double> parameters;
  std::array<std::array<double, 3>, 4> displacements;  ///< at pulse_times, m, by an independent program

  std::string description() const { return "three masses under a half sine, joint of law " + law; }
};

/// Length of the pulse, s: half a period of 19 rad/s.
inline constexpr double pulse_length = 0.16534698176788384;

/// About 2, 4, 8 and 16 lengths of the pulse, s.
inline constexpr std::array<double, 4> pulse_times = {0.330694, 0.661388, 1.32278, 2.64555};

const std::vector<PulseProblem>& list_pulses();

/// The one of that name, or null.
const PulseProblem* find_pulse(const std::string& name);

/// Writes NAME.toml and truth.json; the path of the scene.
std::filesystem::path write(const PulseProblem& problem, const std::filesystem::path& directory);

}  // namespace jointid::problems
