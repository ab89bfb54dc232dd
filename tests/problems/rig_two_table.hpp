#pragma once

#include <cmath>

#include "friction/fit/fit.hpp"
#include "problems/vibration/rig_two.hpp"
#include "tasks/equivalent_joint.hpp"

namespace jointid::problems {

/// (7.11) or (7.18) of docs/formulas.md §12, with the parts' FRFs as they are or real (7.19), residuals over the FRFs or as printed.
struct Form {
  bool rigid = true, real = true, relative = true;
};

/// k_e and d_e of a rig by displacement, from its sets in memory, lines up to 57 Hz.
inline friction::Curve equivalents(const RigTwo& rig, Form form) {
  friction::Curve curve;
  curve.name = rig.name;
  curve.kind = friction::CurveKind::equivalent;
  for (std::size_t level = 0; level < rig.levels.size(); ++level) {
    tasks::JointLines lines;
    lines.relative = form.relative;
    std::vector<std::complex<double>> h1, h3;
    for (std::size_t i = 0; rig.parts.header.frequency_hz[i] <= 57.0; ++i) {
      const auto part = [&](std::size_t r, std::size_t c) {
        const auto h = rig.parts.values[rig.parts.index(i, r, c)];
        return form.real ? tasks::real_frf(h) : h;
      };
      lines.a.push_back(part(0, 0));
      lines.b.push_back(part(1, 1));
      lines.c.push_back(part(0, 1));
      lines.h1.push_back(rig.levels[level].values[2 * i]);
      lines.h3.push_back(rig.levels[level].values[2 * i + 1]);
      h1.push_back(rig.rigid.values[2 * i]);
      h3.push_back(rig.rigid.values[2 * i + 1]);
    }
    lines.gap = form.rigid ? rigid_gap(lines, h1, h3) : difference_gap(lines);
    const tasks::EquivalentJoint joint = equivalent_joint(lines);
    curve.u.push_back(rig.displacements[level]);
    curve.value.push_back(joint.stiffness);
    curve.damping.push_back(joint.damping);
  }
  return curve;
}

/// The friction limit that Ren's law gets from them by (7.20), over the true one.
inline double limit_ratio(const RigTwo& rig, Form form) {
  const friction::Curve curve = equivalents(rig, form);
  const friction::Fit fit = friction::fit(std::span(&curve, 1), friction::family("ren"));
  return fit.status == Status::ok ? fit.curves[0].limit.value / rig.limit : std::nan("");
}

}  // namespace jointid::problems
