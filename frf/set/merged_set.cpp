#include "frf/set/merged_set.hpp"

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"
#include "frf/set/frf_system.hpp"
#include "frf/set/recorded_variance.hpp"

namespace jointid::frf {
namespace {

void add_dofs(std::vector<Dof>& to, const std::vector<Dof>& from) {
  for (const Dof& dof : from) {
    if (!has(to, dof)) to.push_back(dof);
  }
}

FrfSet empty_union(const std::vector<FrfSet>& sets) {
  FrfSet out;
  out.header = sets.front().header;
  for (const FrfSet& set : sets) {
    add_dofs(out.header.response, set.header.response);
    add_dofs(out.header.reference, set.header.reference);
    for (const Node& node : set.header.nodes) {
      const bool known = std::ranges::any_of(out.header.nodes, [&](const Node& other) { return other.id == node.id; });
      if (!known) out.header.nodes.push_back(node);
    }
  }
  const bool noise = std::ranges::all_of(sets, knows_noise);
  out.header.noise = noise ? NoiseRecord::variance : NoiseRecord::none;
  out.header.averages = 0.0;
  out.header.repeats = 0;
  out.values.assign(out.header.lines() * out.header.entries(), {nan, nan});
  if (noise) out.variance = out.values;
  return out;
}

void require_same_lines(const FrfSet& first, const FrfSet& set) {
  const auto partners = match_lines(first.header.frequency_hz, set.header.frequency_hz);
  if (first.header.lines() == set.header.lines() && std::ranges::find(partners, npos) == partners.end()) return;
  fail(set.header, "frequency", "its lines, " + range_text(set.header.frequency_hz) + ", are not those of " + first.header.file + ", " +
       range_text(first.header.frequency_hz), "measure or convert them to one axis");
}

void put(const FrfSet& set, FrfSet& out) {
  for (std::size_t r = 0; r < set.header.response.size(); ++r) {
    const Dof& response = set.header.response[r];
    const std::size_t row = find_coordinate(out.header.response, response);
    for (std::size_t c = 0; c < set.header.reference.size(); ++c) {
      const Dof& reference = set.header.reference[c];
      const std::size_t column = find_coordinate(out.header.reference, reference);
      const double sign = response.sign * out.header.response[row].sign * reference.sign * out.header.reference[column].sign;
      for (std::size_t line = 0; line < set.header.lines(); ++line) {
        const std::size_t from = set.index(line, r, c), to = out.index(line, row, column);
        if (std::isnan(set.values[from].real())) continue;
        if (!std::isnan(out.values[to].real())) {
          fail(set.header, "FRF " + response.name() + " / " + reference.name(), "another file has it, too", "keep it in one file");
        }
        out.values[to] = sign * set.values[from];
        if (!out.variance.empty()) out.variance[to] = recorded_variance(set, from);
      }
    }
  }
}

}  // namespace

FrfSet merged(std::vector<FrfSet> sets) {
  if (sets.size() == 1) return std::move(sets.front());
  for (const FrfSet& set : sets) require_same_lines(sets.front(), set);
  FrfSet out = empty_union(sets);
  for (const FrfSet& set : sets) put(set, out);
  return out;
}

}  // namespace jointid::frf
