#include "ident/judgement/loose_joints.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/statistics.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t enough_joints = 5;  ///< that their median and scatter say something of sound ones
constexpr double least_deviation = 1e-9;  ///< exact data

double density(double x, double deviation) {
  return std::exp(-0.5 * std::pow(x / deviation, 2)) / (deviation * std::sqrt(2.0 * std::numbers::pi));
}

double normal_share_below(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

/// What all shares say together of those of sound joints.
struct Sound {
  double centre = 1.0, scatter = 0.0;  ///< beyond each one's own error
};

Sound sound_joints(const std::vector<NominalShare>& shares) {
  if (shares.size() < enough_joints) return {};
  std::vector<double> values, distances, variances;
  for (const NominalShare& each : shares) values.push_back(each.share);
  const double centre = median(values);
  for (const NominalShare& each : shares) {
    distances.push_back(std::abs(each.share - centre));
    variances.push_back(each.deviation * each.deviation);
  }
  const double whole = 1.4826 * median(std::move(distances));
  return {centre, std::sqrt(std::max(0.0, whole * whole - median(std::move(variances))))};
}

}  // namespace

std::vector<double> looseness(const std::vector<NominalShare>& shares) {
  constexpr int rounds = 50;
  const Sound sound = sound_joints(shares);
  std::vector<double> as_sound, as_loose, out(shares.size(), 0.0);
  for (const auto& [share, own] : shares) {
    const double deviation = std::max(std::hypot(own, sound.scatter), least_deviation);
    as_sound.push_back(density(share - sound.centre, deviation));
    const double inside = normal_share_below((sound.centre - share) / deviation) - normal_share_below(-share / deviation);
    as_loose.push_back(inside / std::max(sound.centre, least_deviation));
  }
  const double most = 0.5, least = 0.5 / static_cast<double>(std::max<std::size_t>(1, shares.size()));
  double loose = std::clamp(0.1, least, most);
  for (int round = 0; round < rounds; ++round) {
    double sum = 0.0;
    for (std::size_t e = 0; e < shares.size(); ++e) {
      const double a = loose * as_loose[e], b = (1.0 - loose) * as_sound[e];
      out[e] = a + b > 0.0 ? a / (a + b) : (shares[e].share < sound.centre ? 1.0 : 0.0);
      sum += out[e];
    }
    loose = std::clamp(sum / static_cast<double>(shares.size()), least, most);
  }
  return out;
}

void find_loose_joints(const Plan& plan, Solution& out) {
  if (!plan.scene.identify.loose || out.unknowns.empty()) return;
  std::vector<NominalShare> shares;
  for (std::size_t column = 0; column < out.unknowns.size(); ++column) {
    const restrictions::Unknown& unknown = plan.restriction.unknowns[plan.columns->unknown_of(column)];
    const std::string& joint = plan.scene.joints[unknown.joint].name;
    const Estimate& estimate = out.unknowns[column];
    if (unknown.kind == restrictions::Kind::stiffness) {
      shares.push_back({estimate.value, estimate.error().value_or(0.0)});
      out.loose.push_back({.joint = joint, .lost = 1.0 - estimate.value, .std_error = estimate.std_error});
    } else if (unknown.kind == restrictions::Kind::hysteretic_damping && unknown.name.ends_with("loss")) {
      const auto own = std::ranges::find(out.loose, joint, &LooseJoint::joint);
      if (own != out.loose.end() && own->lost < 1.0) own->loss_factor = estimate.value / (1.0 - own->lost);
    }
  }
  const std::vector<double> probability = looseness(shares);
  for (std::size_t e = 0; e < out.loose.size(); ++e) out.loose[e].probability = probability[e];
  std::ranges::stable_sort(out.loose, [](const LooseJoint& a, const LooseJoint& b) {
    return a.probability != b.probability ? a.probability > b.probability : a.lost > b.lost;
  });
}

}  // namespace jointid::ident
