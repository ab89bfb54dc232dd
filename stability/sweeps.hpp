#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stability/measurement.hpp"

namespace jointid::stability {

/// One quantity taken to its extremes, everything else as in ExtremeScene.
struct Sweep {
  std::string name;   ///< as on the command line
  std::string title;
  std::string varied; ///< what Measured::value is, with its unit
};

/// All sweeps in the order of the table.
const std::vector<Sweep>& sweeps();

/// How the solutions of random scenes kept their promises.
struct Count {
  std::size_t scenes = 0, right = 0, told = 0, silent_wrong = 0, false_alarm = 0, refused = 0;
  std::vector<std::uint64_t> silent;  ///< indices of the scenes
};

/// How the caller watches a run.
struct Watch {
  std::function<void(const std::string& what)> progress;
  std::function<bool()> interrupted;
  std::function<void(const Measured& row)> measured{};     ///< given every row as soon as it is there
  std::function<void(const Count& count)> counted{};        ///< given the count after every random scene
};

/// Runs the named sweeps, all when none is named. Throws InputError (usage) for a name that is none, Interrupted on request.
std::vector<Measured> run_sweeps(const std::vector<std::string>& names, const Watch& watch = {});

/// Scenes first … first+count−1 of a seed, see draw(). `refused`: the plan itself says no, by InputError.
Count count_verdicts(std::uint64_t seed, std::uint64_t first, std::size_t count, const Watch& watch = {});

}  // namespace jointid::stability
