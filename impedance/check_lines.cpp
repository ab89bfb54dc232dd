#include "impedance/check_lines.hpp"

#include "base/error.hpp"
#include "ident/check/check.hpp"
#include "ident/identify.hpp"
#include "impedance/identify_lines.hpp"

namespace jointid::impedance {
namespace {

/// Some lines alone, by the likelihood, without laws.
LineScene at_some_lines(const LineScene& scene) {
  constexpr std::size_t most = 64;
  LineScene out = scene;
  out.ways = {Way::likelihood};
  out.laws.clear();
  out.smoothing.reset();
  const auto plan = ident::make_plan(scene.scene);
  if (plan->lines.size() <= most) return out;
  const double first = plan->lines.front().frequency_hz, last = plan->lines.back().frequency_hz;
  out.scene.frequency.range_hz = {first, last};
  out.scene.frequency.step_hz = (last - first) / static_cast<double>(most - 1);
  return out;
}

}  // namespace

ident::CheckResult check_lines(const LineScene& scene, const ident::Control& control) {
  ident::CheckResult out = ident::check_scene(scene.scene, control);
  if (!out.suspects.empty()) return out;
  try {
    const IdentifiedLines found = identify_lines(at_some_lines(scene), control);
    if (found.status == Status::ok) return out;
    if (!(found.freedom > 0.0)) {
      out.notes.push_back(found.message);
      return out;
    }
    out.suspects.push_back({.kind = ident::SuspectKind::nonlinear,
                            .file = "",
                            .dofs = {},
                            .evidence = "each file agrees with itself, but Z at every line does not hold: " + found.message,
                            .confidence = 0.6,
                            .remedy = ""});
    out.verdict = ident::Verdict::suspicious;
  } catch (const InputError&) {  // solve states it
  }
  return out;
}

}  // namespace jointid::impedance
