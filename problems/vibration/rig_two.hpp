#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "problems/case/problem_info.hpp"
#include "problems/case/write_options.hpp"
#include "problems/structure/structure.hpp"

namespace jointid::problems {

/// Rig two of thesis §7.3: two steel beams, joined by rods at their ends, with a friction joint between their middles. FRFs are
/// those of sine tests with the relative displacement at the joint held at one amplitude each, where the joint acts by the first
/// harmonic of its force (describing function).
struct RigTwo {
  std::string name;  ///< "rig2" (200 N clamping force) or "rig2-264"
  std::string description;
  double clamping_force = 0.0;        ///< N
  std::vector<double> element;        ///< a, b, k of Ren's law, Table 7.7
  double limit = 0.0;                 ///< N
  std::vector<double> displacements;  ///< m
  frf::FrfSet parts;                  ///< noise-free, both middles
  std::vector<frf::FrfSet> levels;    ///< noise-free, excited at the first middle; one per displacement
  frf::FrfSet rigid;                  ///< the same with the joint clamped until it does not slip
  std::string scene;                  ///< TOML text for `jointid equivalent`
};

/// The beams, rods and blocks without the joint, and the two middles, between which it is.
Structure rig_two_structure();
std::array<frf::Dof, 2> rig_two_middles();

std::vector<ProblemInfo> list_rig_two();

/// Throws InputError (usage) with the nearest name when there is none.
RigTwo make_rig_two(const std::string& name);

/// The errors of the rig's tests. Each FRF of the parts, and each of the two of the assembly, which is never taken off the
/// shaker, has one gain error, uniform within ±1.7 % (repeats differed by 0.3 dB in all); the parts' FRFs one phase error within
/// ±0.01 rad (the damping predicted from them was too high); every value an error of 0.3 % in both parts.
RigTwo polluted(const RigTwo& rig, std::uint64_t seed);

/// Writes the FRF files, NAME.toml and truth.json into `directory` and returns the scene's path.
std::filesystem::path write(const RigTwo& rig, const std::filesystem::path& directory, const WriteOptions& options);

}  // namespace jointid::problems
