#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/random.hpp"
#include "frf/noise/noise_model.hpp"
#include "frf/set/dof_errors.hpp"
#include "frf/set/excerpt.hpp"

namespace jointid::frf {

/// Pollutes the same set over and over, in place. Everything that does not depend on the trial is found once; nothing is
/// allocated afterwards unless coherences are recorded. Copies are independent: one per thread.
class Polluter {
 public:
  /// The model must be valid.
  Polluter(const Excerpt& clean, const NoiseModel& model);

  /// `set`: a copy of the clean set. Numbers come from (seed, trial, set) of the stream, counted where the entries stand in
  /// the whole set.
  void pollute(FrfSet& set, const RandomStream& stream);

 private:
  struct Draw {
    double first = 0.0, second = 0.0;
  };

  void find_draws(const Excerpt& clean);
  void find_floor(const FrfSet& clean);
  void draw_line(const RandomStream& stream, std::uint64_t line_start);
  void add_proportional_noise(FrfSet& set, std::size_t line, double level) const;
  void add_hammer_noise(FrfSet& set, const RandomStream& stream, std::size_t line, double factor) const;
  void add_floor(FrfSet& set, const RandomStream& stream, std::size_t line, double factor) const;
  double gross_factor(const RandomStream& stream, std::uint64_t line_start) const;

  NoiseModel model_;
  std::vector<std::uint64_t> line_start_, entry_;  ///< of Excerpt
  std::vector<std::uint64_t> counters_;            ///< distinct counters of a line
  std::vector<std::size_t> draw_of_;               ///< [R,C] which of them an entry draws from
  std::vector<Draw> draws_;                        ///< of the current line, one per counter
  std::vector<double> floor_;                      ///< [F,R,C] standard deviation of the complex error; empty without floor
  std::optional<DofErrors> dof_errors_;
};

}  // namespace jointid::frf
