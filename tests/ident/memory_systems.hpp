#pragma once

#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "ident/identify.hpp"
#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// "4:+Y", … as DOFs.
inline Dofs dofs(const std::vector<std::string>& names) {
  Dofs result;
  for (const std::string& name : names) result.push_back(frf::Dof::parse(name));
  return result;
}

/// The FRF response/reference of some sets at a line, with the signs of the DOFs asked for; `absent` where no set has it.
inline Complex frf_at(const std::vector<frf::FrfSet>& sets, std::size_t line, const frf::Dof& response,
                      const frf::Dof& reference, Complex absent = std::numeric_limits<double>::quiet_NaN()) {
  for (const frf::FrfSet& set : sets) {
    const std::size_t r = frf::find_coordinate(set.header.response, response);
    const std::size_t c = frf::find_coordinate(set.header.reference, reference);
    if (r == frf::npos || c == frf::npos) continue;
    const int sign = response.sign * set.header.response[r].sign * reference.sign * set.header.reference[c].sign;
    return static_cast<double>(sign) * set.values[set.index(line, r, c)];
  }
  return absent;
}

/// A set of some DOFs (in their order and with their signs) of another.
inline frf::FrfSet part_of(const frf::FrfSet& set, const Dofs& responses, const Dofs& references) {
  frf::FrfSet part;
  part.header = set.header;
  part.header.response = responses;
  part.header.reference = references;
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (const frf::Dof& r : responses) {
      for (const frf::Dof& c : references) part.values.push_back(frf_at({set}, line, r, c));
    }
  }
  return part;
}

/// A set without its lines but those listed.
inline frf::FrfSet lines_of(const frf::FrfSet& set, const std::vector<std::size_t>& lines) {
  frf::FrfSet part;
  part.header = set.header;
  part.header.frequency_hz.clear();
  for (const std::size_t line : lines) {
    part.header.frequency_hz.push_back(set.header.frequency_hz[line]);
    const auto first = set.values.begin() + static_cast<std::ptrdiff_t>(set.index(line, 0, 0));
    part.values.insert(part.values.end(), first, first + static_cast<std::ptrdiff_t>(set.header.entries()));
  }
  return part;
}

/// FRFs of complex normal numbers times `scale`, every line with a magnitude of its own.
inline frf::FrfSet random_set(const std::string& file, const std::vector<double>& frequency_hz, const Dofs& responses,
                              const Dofs& references, double scale, std::mt19937_64& random) {
  frf::FrfSet set;
  set.header.file = file;
  set.header.frequency_hz = frequency_hz;
  set.header.response = responses;
  set.header.reference = references;
  std::normal_distribution<double> normal;
  for (std::size_t line = 0; line < frequency_hz.size(); ++line) {
    const double level = scale * std::exp(normal(random));
    for (std::size_t i = 0; i < set.header.entries(); ++i) {
      set.values.emplace_back(level * normal(random), level * normal(random));
    }
  }
  return set;
}

using frf::memory_system;
/// A plan on sets in memory.
inline std::unique_ptr<Plan> memory_plan(const Scene& scene, const std::vector<frf::FrfSet>& substructures,
                                         const std::vector<frf::FrfSet>& assembly) {
  return make_plan(
      scene,
      memory_system("substructures", substructures, frf::Composition::uncoupled, scene.data.reciprocity),
      memory_system("assembly", assembly, frf::Composition::merged, scene.data.reciprocity));
}

/// The sets of both systems, and a scene for them.
struct MemoryScene {
  std::vector<frf::FrfSet> substructures, assembly;
  Scene scene = {};

  std::unique_ptr<Plan> plan() const { return plan(scene); }
  std::unique_ptr<Plan> plan(const Scene& other) const { return memory_plan(other, substructures, assembly); }
};

/// A joint with one matrix.
inline restrictions::JointSpec joint_of(const Dofs& joint, restrictions::Kind kind, restrictions::MatrixSpec spec) {
  restrictions::JointSpec result;
  result.dofs = joint;
  result.matrices[kind] = std::move(spec);
  return result;
}

inline constexpr weighting::Weighting all_weightings[] = {weighting::Weighting::none, weighting::Weighting::wa,
                                                          weighting::Weighting::wb, weighting::Weighting::wbg,
                                                          weighting::Weighting::wbs};

}  // namespace jointid::ident
