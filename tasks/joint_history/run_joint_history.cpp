#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "friction/curve/slip_shares.hpp"
#include "friction/joint/distributed_slip.hpp"
#include "friction/joint/fe_joint.hpp"
#include "friction/path/path_energy.hpp"
#include "tasks/joint_history/joint_history.hpp"

namespace jointid::tasks {
namespace {

using friction::Element;

[[noreturn]] void no_balance(double force) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "[history] forces",
                    .problem = "no displacement reaches " + std::to_string(force) + " N",
                    .remedy = "stay below the joint's limit, or give displacements"});
}

/// A joint moved step by step.
class MovedJoint {
 public:
  virtual ~MovedJoint() = default;
  virtual HistoryPoint move(double displacement, double load) = 0;
  virtual HistoryPoint push(double force) = 0;
  virtual double work() const { return 0.0; }
  virtual std::optional<NodeState> nodes() const { return std::nullopt; }
};

class MovedLaw final : public MovedJoint {
 public:
  explicit MovedLaw(const Element& law) : law_(law), energy_(law) {}

  HistoryPoint move(double displacement, double load) override {
    return {displacement, energy_.advance(displacement).force, load};
  }

  /// The branch from the open corner, then those outside of it: the path is monotone in u, so the root is bracketed.
  HistoryPoint push(double force) override {
    if (!(std::abs(force) < law_.limit())) no_balance(force);
    const friction::MasingPath& path = energy_.path();
    const double sign = force >= path.force() ? 1.0 : -1.0;
    double low = path.displacement(), step = std::max(std::abs(low), law_.displacement(std::abs(force))),
           high = low + sign * step;
    const auto beyond = [&](double u) { return sign * (path.response(u).force - force) >= 0.0; };
    while (!beyond(high)) {
      step *= 2.0;
      high = low + sign * step;
      if (!std::isfinite(high)) no_balance(force);
    }
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      if (middle == low || middle == high) break;
      (beyond(middle) ? high : low) = middle;
    }
    return move(high, 1.0);
  }

  double work() const override { return energy_.work(); }

 private:
  const Element& law_;
  friction::PathEnergy energy_;
};

class MovedSliders final : public MovedJoint {
 public:
  explicit MovedSliders(friction::Sliders sliders) : slip_(std::move(sliders)) {}

  HistoryPoint move(double displacement, double load) override {
    return {displacement, slip_.advance(displacement, load).force, load};
  }
  HistoryPoint push(double force) override { no_balance(force); }

 private:
  friction::DistributedSlip slip_;
};

class MovedMesh final : public MovedJoint {
 public:
  explicit MovedMesh(friction::JointMesh mesh) : joint_(std::move(mesh)) {}

  HistoryPoint move(double displacement, double load) override {
    const friction::EquilibriumStep step = joint_.move_to(displacement);
    return {step.displacement, step.force, load};
  }
  HistoryPoint push(double force) override {
    const friction::EquilibriumStep step = joint_.load_to(force);
    if (!step.found) no_balance(force);
    return {step.displacement, step.force, 1.0};
  }
  std::optional<NodeState> nodes() const override { return NodeState{joint_.displacements(), joint_.interface_forces()}; }

 private:
  friction::FiniteElementJoint joint_;
};

std::unique_ptr<MovedJoint> moved(const JointHistoryScene& scene) {
  if (scene.mesh) return std::make_unique<MovedMesh>(*scene.mesh);
  if (scene.sliders > 0) return std::make_unique<MovedSliders>(friction::even_sliders(*scene.law, scene.sliders));
  return std::make_unique<MovedLaw>(*scene.law);
}

double normal_load(const JointHistoryScene& scene, double theta) {
  double load = 1.0;
  for (const NormalLoad& part : scene.normal) load += part.share * std::sin(part.harmonic * theta + part.phase);
  return std::max(0.0, load);
}

double trapezoids(const std::vector<HistoryPoint>& points, std::size_t from, std::size_t to) {
  double sum = 0.0;
  for (std::size_t i = from; i < to; ++i)
    sum += 0.5 * (points[i].force + points[i + 1].force) * (points[i + 1].displacement - points[i].displacement);
  return sum;
}

void end_part(MovedJoint& joint, std::size_t from, double work_before, bool exact, JointHistory& out) {
  const std::size_t to = out.points.size() - 1;
  out.ends.push_back(to);
  out.work.push_back(exact ? joint.work() - work_before : trapezoids(out.points, from, to));
  if (auto nodes = joint.nodes()) out.nodes.push_back(std::move(*nodes));
}

void run_sine(const JointHistoryScene& scene, MovedJoint& joint, JointHistory& out) {
  const bool exact = !scene.mesh && scene.sliders == 0;
  const auto steps = static_cast<double>(scene.steps);
  for (std::size_t cycle = 0; cycle < scene.cycles; ++cycle) {
    const std::size_t from = out.points.size() - 1;
    const double before = joint.work();
    double sum = 0.0;
    for (std::size_t i = 1; i <= scene.steps; ++i) {
      const double theta = 2.0 * std::numbers::pi * static_cast<double>(i) / steps;
      out.points.push_back(joint.move(scene.amplitude * std::sin(theta), normal_load(scene, theta)));
      sum += out.points.back().force;
    }
    end_part(joint, from, before, exact, out);
    out.mean.push_back(sum / steps);
  }
}

void run_turns(const JointHistoryScene& scene, MovedJoint& joint, JointHistory& out) {
  const bool exact = !scene.mesh;
  double last = 0.0;
  for (const double turn : scene.turns) {
    const std::size_t from = out.points.size() - 1;
    for (std::size_t i = 1; i <= scene.points; ++i) {
      const double to =
          i == scene.points ? turn : last + (turn - last) * static_cast<double>(i) / static_cast<double>(scene.points);
      out.points.push_back(scene.by_force ? joint.push(to) : joint.move(to, 1.0));
    }
    last = turn;
    end_part(joint, from, 0.0, exact, out);
    if (!exact && out.work.size() > 1) out.work.back() += out.work[out.work.size() - 2];
  }
}

/// Every slipping node at its limit.
double mesh_limit(const friction::JointMesh& mesh) {
  if (mesh.end_spring > 0.0) return friction::infinity;
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.members.size(); ++i) {
    for (const std::size_t node : {i, i + 1}) {
      if (mesh.interface[node]) sum += 0.5 * mesh.members[i].length * mesh.interface[node]->limit();
    }
  }
  return sum;
}

void describe(const JointHistoryScene& scene, JointHistory& out) {
  double limit = friction::infinity;
  if (scene.mesh) {
    limit = mesh_limit(*scene.mesh);
    friction::FiniteElementJoint joint(*scene.mesh);
    const double little = 1e-9 * (std::isfinite(limit) ? limit : 1.0);
    out.stiffness = little / joint.load_to(little).displacement;
  } else {
    limit = scene.law->limit();
    out.stiffness = scene.law->response(0.0).tangent;
    for (const double u : scene.law->kinks()) out.kinks.push_back({u, scene.law->response(u).force, 1.0});
  }
  if (std::isfinite(limit)) out.limit = limit;
  for (const double share : scene.shares) out.slip_displacements.push_back(friction::slip_displacement(*scene.law, share));
}

}  // namespace

JointHistory run_joint_history(const JointHistoryScene& scene) {
  JointHistory out;
  describe(scene, out);
  const std::unique_ptr<MovedJoint> joint = moved(scene);
  out.points.push_back({0.0, 0.0, normal_load(scene, 0.0)});
  if (scene.turns.empty()) {
    run_sine(scene, *joint, out);
  } else {
    run_turns(scene, *joint, out);
  }
  return out;
}

}  // namespace jointid::tasks
