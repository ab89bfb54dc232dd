#include "gui/plot/indicators.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/control.hpp"
#include "gui/look/said.hpp"
#include "tasks/modalfit/mode_indicators.hpp"

namespace jointid::gui {
namespace {

constexpr std::size_t most_indicators = 3;

using Group = std::vector<const Curve*>;

/// Curves of one file with the unit of its first, in the order of the files.
std::vector<Group> groups_of(const std::vector<Curve>& curves) {
  std::vector<Group> groups;
  for (const Curve& curve : curves) {
    if (curve.values.empty()) continue;
    const auto same = std::ranges::find_if(groups, [&](const Group& group) { return group.front()->file == curve.file; });
    if (same == groups.end())
      groups.push_back({&curve});
    else if (unit_of({*same->front(), curve}, frf::Quantity::receptance) != "SI")
      same->push_back(&curve);
  }
  return groups;
}

/// A curve over the lines of a group.
Curve empty_like(const Group& group, const std::string& what) {
  Curve out;
  out.name = group.front()->file + "  " + Said::tr("%1 of %2 FRFs").arg(q(what)).arg(group.size()).toStdString();
  out.response = group.front()->response;
  out.reference = group.front()->reference;
  out.frequency_hz = group.front()->frequency_hz;
  out.has_phase = false;
  out.file = group.front()->file;
  return out;
}

Curve sum_of(const Group& group) {
  Curve out = empty_like(group, "Σ|H|");
  out.values.assign(out.frequency_hz.size(), 0.0);
  for (const Curve* curve : group) {
    for (std::size_t line = 0; line < out.values.size(); ++line) {
      const double size = std::abs(curve->values[line]);
      if (std::isfinite(size)) out.values[line] += size;
    }
  }
  return out;
}

/// Places of DOFs that are met for the first time, one after another.
std::size_t place_of(const frf::Dof& dof, std::vector<frf::Dof>& all) {
  const auto found = std::ranges::find(all, dof);
  if (found == all.end()) all.push_back(dof);
  return static_cast<std::size_t>(std::ranges::find(all, dof) - all.begin());
}

std::vector<Curve> indicators_of(const Group& group, const std::function<bool()>& interrupted) {
  std::vector<frf::Dof> responses, references;
  std::map<std::pair<std::size_t, std::size_t>, const Curve*> entries;
  for (const Curve* curve : group) {
    const std::size_t row = place_of(curve->response, responses), column = place_of(curve->reference, references);
    entries[{row, column}] = curve;
  }
  const auto receptance = [&](std::size_t row, std::size_t column, std::size_t line) {
    const auto found = entries.find({row, column});
    return found == entries.end() ? Complex() : found->second->values[line];
  };
  std::vector<std::size_t> lines(group.front()->frequency_hz.size());
  std::iota(lines.begin(), lines.end(), 0U);
  std::vector<Curve> out;
  for (const auto& values :
       tasks::mode_indicators({responses.size(), references.size(), receptance}, lines, most_indicators, interrupted)) {
    out.push_back(empty_like(group, "CMIF " + std::to_string(out.size() + 1)));
    out.back().values.assign(values.begin(), values.end());
  }
  return out;
}

}  // namespace

std::vector<Curve> indicators(std::vector<Curve> curves, View view, const std::function<bool()>& interrupted) {
  if (!is_indicator(view)) return curves;
  std::vector<Curve> out;
  for (const Group& group : groups_of(curves)) {
    stop_if(interrupted);
    if (view == View::sum) {
      out.push_back(sum_of(group));
      continue;
    }
    for (Curve& each : indicators_of(group, interrupted)) out.push_back(std::move(each));
  }
  return out;
}

}  // namespace jointid::gui
