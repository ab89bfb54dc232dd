#include "impedance/line_plan.hpp"

#include <algorithm>

#include "ident/identify.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/variance_sources.hpp"

namespace jointid::impedance {
namespace {

std::size_t measured(const ident::Channel& block) {
  return static_cast<std::size_t>(std::ranges::count_if(block.weight, [](Complex weight) { return weight != Complex(0.0); }));
}

}  // namespace

LinePlan plan_lines(const LineScene& scene, bool with_bound, const ident::Control& control) {
  LinePlan out;
  const auto plan = ident::make_plan(scene.scene);
  out.dofs = scene.scene.joints.front().dofs;
  for (const ident::Line& line : plan->lines) out.frequency_hz.push_back(line.frequency_hz);
  out.elements = elements_of(scene);
  ident::Observations& observations = *ident::likelihood_plan(*plan)->observations;
  observations.read({plan->lines.front()}, [](std::size_t) {});
  const ident::LineData& first = observations.lines().front();
  out.blocks = {{"H_sub(j,n)", measured(first.sub_jn)},
                {"H_sub(j,j)", measured(first.sub_jj)},
                {"H_asm(j,n)", measured(first.asm_jn)},
                {"H_asm(j,j)", measured(first.asm_jj)},
                {"H_sub(n,n) − H_asm(n,n)", measured(first.drop_nn)}};
  out.freedom = first.redundancy(observations.layout()) - 2.0 * static_cast<double>(out.elements.size());
  out.variances = ident::variance_sources(*plan);
  out.warnings = plan->warnings;
  out.notes = plan->notes;
  if (with_bound) {
    LineScene alone = scene;
    alone.ways = {Way::likelihood};
    out.bound = identify_lines(alone, control);
  }
  return out;
}

}  // namespace jointid::impedance
