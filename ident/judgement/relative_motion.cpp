#include "ident/judgement/relative_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/statistics.hpp"
#include "base/text.hpp"
#include "ident/judgement/measured_rectangle.hpp"
#include "ident/scene/variance_origin.hpp"
#include "ident/variance/variances.hpp"

namespace jointid::ident {
namespace {

bool are_errors_stated(const Plan& plan) {
  for (std::size_t s = 0; s < plan.assembly->source_count(); ++s) {
    try {
      if (variance_origin(plan.scene, plan.assembly->source(s).header()) == VarianceOrigin::scatter) return false;
    } catch (const InputError&) {
      return false;
    }
  }
  return true;
}

/// A pair by the places of its DOFs among those that are read.
struct Pair {
  RelativeMotion of;
  std::size_t a = 0, b = 0;
  double sign = 1.0;
  std::vector<double> ratios;
};

std::vector<Pair> pairs_of(const Plan& plan, const Dofs& read) {
  std::vector<Pair> out;
  for (const restrictions::JointSpec& joint : plan.scene.joints) {
    for (std::size_t i = 0; i < joint.dofs.size(); ++i) {
      for (std::size_t k = i + 1; k < joint.dofs.size(); ++k) {
        const frf::Dof &a = joint.dofs[i], &b = joint.dofs[k];
        if (a.direction != b.direction || plan.substructures->source_of(a) == plan.substructures->source_of(b)) continue;
        const std::size_t first = frf::find_coordinate(read, a), second = frf::find_coordinate(read, b);
        if (first == frf::npos || second == frf::npos) continue;
        out.push_back({{joint.name, a, b}, first, second, static_cast<double>(a.sign * b.sign), {}});
      }
    }
  }
  return out;
}

std::vector<Line> some_lines(const Plan& plan, std::size_t numbers_of_line) {
  constexpr std::size_t least = 3, most = 25, numbers = 400'000;
  return spread_lines(plan.lines, std::clamp(numbers / std::max<std::size_t>(1, numbers_of_line), least, most));
}

}  // namespace

std::vector<RelativeMotion> relative_motions(const Plan& plan) {
  if (!are_errors_stated(plan)) return {};
  Dofs rows;
  for (const frf::Dof& dof : plan.coordinates.joint) {
    if (frf::has(plan.assembly->responses(), dof)) rows.push_back(dof);
  }
  std::vector<Pair> pairs = pairs_of(plan, rows);
  const Dofs& references = plan.assembly->references();
  if (pairs.empty() || references.empty()) return {};
  const std::vector<Line> lines = some_lines(plan, pairs.size() * references.size());
  std::vector<std::size_t> places;
  for (const Line& line : lines) places.push_back(line.assembly);
  frf::BlockReader reader(*plan.assembly, rows, references);
  Variances errors(*plan.assembly, rows, references, plan.scene);
  if (errors.needs_prepare()) errors.prepare(places);
  std::vector<Complex> values(rows.size() * references.size()), variances(values.size());
  for (const std::size_t line : places) {
    reader.read(std::array{line}, values);
    errors.read(std::array{line}, values, variances);
    for (Pair& pair : pairs) {
      for (std::size_t l = 0; l < references.size(); ++l) {
        const std::size_t a = pair.a * references.size() + l, b = pair.b * references.size() + l;
        const Complex sum = variances[a] + variances[b];
        const double ratio = std::abs(values[a] - pair.sign * values[b]) / std::sqrt(sum.real() + sum.imag());
        if (std::isfinite(ratio)) pair.ratios.push_back(ratio);
      }
    }
  }
  std::vector<RelativeMotion> out;
  for (Pair& pair : pairs) {
    if (pair.ratios.empty()) continue;
    pair.of.over_error = median(std::move(pair.ratios));
    out.push_back(std::move(pair.of));
  }
  return out;
}

void tell_relative_motions(const Plan& plan, Solution& out) {
  constexpr double seen = 3.0;  // standard errors
  out.relative_motions = relative_motions(plan);
  const std::vector<RelativeMotion>& all = out.relative_motions;
  const auto hidden = std::ranges::count_if(all, [&](const RelativeMotion& each) { return each.over_error < seen; });
  if (hidden == 0) return;
  const RelativeMotion& least = *std::ranges::min_element(all, {}, &RelativeMotion::over_error);
  out.warnings.push_back("Both sides of joints move as one within the errors of the FRFs. |x_a − x_b| is below " + digits(seen) +
                         " standard errors (median over lines and references) at " + std::to_string(hidden) + " of " +
                         std::to_string(all.size()) + " pairs of joint DOFs, least " + digits(least.over_error) + " at " +
                         least.a.name() + " and " + least.b.name() + (least.joint.empty() ? "" : " of " + least.joint) +
                         ". Stiffness there rests on few lines, and no condition number shows it.");
}

}  // namespace jointid::ident
