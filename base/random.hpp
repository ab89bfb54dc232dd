#pragma once

#include <array>
#include <cstdint>

namespace jointid {

/// A stream of counter-based random numbers (Philox4x64-10, Random123; Salmon et al., SC 2011): a pure
/// function of (seed, trial) and a counter. What one entry draws depends neither on the other entries nor on
/// the order or the thread in which they are drawn.
struct RandomStream {
  std::uint64_t seed = 1;
  std::uint64_t trial = 0;
  std::uint64_t set = 0;  ///< which of several data sets of a trial, e.g. substructure A, B, assembly
};

/// Four numbers uniform in the open interval (0, 1) for counter (entry, block); block 0, 1, … gives an entry
/// more.
std::array<double, 4> uniform_numbers(const RandomStream& stream, std::uint64_t entry,
                                      std::uint64_t block = 0);

/// Two independent standard normal numbers (Box–Muller) for counter (entry, block).
std::array<double, 2> normal_numbers(const RandomStream& stream, std::uint64_t entry,
                                     std::uint64_t block = 0);

}  // namespace jointid
