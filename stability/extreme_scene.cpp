#include "stability/extreme_scene.hpp"

#include "ident/identify.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace jointid::stability {
namespace {

using problems::Structure;
using restrictions::Kind;

constexpr double spring = 1e6;  // N/m
constexpr std::size_t masses = 4;

frf::Dof coordinate(std::int64_t node) { return {node, frf::Direction::y, +1}; }

std::vector<frf::Dof> nodes_from(std::int64_t first) {
  return {coordinate(first), coordinate(first + 1), coordinate(first + 2), coordinate(first + 3)};
}

/// A chain of nodes first … first+3, its ground spring at node `grounded`, and the soft or stiff link between two neighbours.
Structure chain(std::int64_t first, std::int64_t grounded, std::int64_t link, const ExtremeScene& scene) {
  std::mt19937_64 random(scene.seed + static_cast<std::uint64_t>(first));
  std::uniform_real_distribution<double> uniform(0.5, 1.5);
  std::vector<frf::Node> nodes;
  for (std::int64_t node = first; node < first + 4; ++node) nodes.push_back({node, {0.1 * static_cast<double>(node), 0.0, 0.0}});
  Structure out(nodes, nodes_from(first));
  for (std::size_t i = 0; i < masses; ++i) {
    const auto node = first + static_cast<std::int64_t>(i);
    const double step = 1.0 + 0.07 * static_cast<double>(node);
    out.add(Kind::mass, {coordinate(node), {}}, scene.seed == 0 ? step : uniform(random));
    const double stiffness = spring * (scene.seed == 0 ? 1.0 / step : uniform(random));
    if (node < first + 3)
      out.add(Kind::stiffness, {coordinate(node), coordinate(node + 1)}, node == link ? stiffness / scene.gap : stiffness);
    if (node < first + 2) out.add(Kind::stiffness, {coordinate(node), coordinate(node + 2)}, 0.4 * stiffness);
  }
  if (!scene.free_free) out.add(Kind::stiffness, {coordinate(grounded), {}}, spring);
  out.add_proportional_damping(scene.loss_factor);
  return out;
}

struct Joint {
  std::vector<frf::Dof> dofs = {coordinate(3), coordinate(4), coordinate(5), coordinate(6)};
  double first, second, loss;

  explicit Joint(const ExtremeScene& scene)
      : first(scene.joint_stiffness * spring), second(scene.second_spring * first), loss(scene.joint_loss) {}

  double value(Kind kind, double stiffness) const { return kind == Kind::stiffness ? stiffness : loss * stiffness; }

  std::vector<ExactSpring> springs() const {
    std::vector<ExactSpring> out;
    for (const Kind kind : {Kind::stiffness, Kind::hysteretic_damping}) {
      out.push_back({kind, dofs[0], dofs[2], value(kind, first)});
      out.push_back({kind, dofs[1], dofs[3], value(kind, second)});
    }
    return out;
  }

  /// Springs as listed, or the upper triangle row by row.
  std::vector<double> unknowns(Kind kind, Form form) const {
    const double a = value(kind, first), b = value(kind, second);
    if (form == Form::springs) return {a, b};
    return {a, 0.0, -a, 0.0, b, 0.0, -b, a, 0.0, b};
  }

  restrictions::JointSpec spec(Form form) const {
    restrictions::JointSpec out;
    out.dofs = dofs;
    for (const Kind kind : {Kind::stiffness, Kind::hysteretic_damping}) {
      if (form == Form::springs) {
        out.matrices[kind] = std::vector<restrictions::Spring>{{dofs[0], dofs[2]}, {dofs[1], dofs[3]}};
      } else {
        out.matrices[kind] = restrictions::Pattern::symmetric;
      }
    }
    return out;
  }
};

std::vector<double> lines(const ExtremeScene& scene, const std::vector<Structure>& structures) {
  std::vector<double> out;
  const double low = scene.lowest_hz, high = scene.highest_hz, last = std::max<double>(1.0, static_cast<double>(scene.lines - 1));
  for (std::size_t i = 0; i < scene.lines; ++i) {
    const double share = static_cast<double>(i) / last;
    out.push_back(scene.logarithmic ? low * std::pow(high / low, share) : std::lerp(low, high, share));
  }
  if (!scene.on_resonance) return out;
  for (const Structure& structure : structures) {
    for (std::size_t mode = 0; mode < structure.size(); ++mode) {
      const double frequency = exact_natural_frequency(structure, mode);
      if (frequency > low && frequency < high) out.push_back(frequency);
    }
  }
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

void add(const std::vector<ExactSpring>& springs, Structure& structure) {
  for (const auto& [kind, first, second, value] : springs) structure.add(kind, {first, second}, value);
}

/// 50 digits for as many lines as they are affordable for, else LU with refinement: FRFs that are right to the last bit but one.
frf::FrfSet responses(Structure structure, const std::vector<ExactSpring>& springs, const problems::ResponseRequest& request,
                      Storage storage) {
  if (request.frequency_hz.size() <= most_exact_lines) return exact_responses(structure, springs, request, storage);
  add(springs, structure);
  return problems::frequency_response(structure, request);
}

}  // namespace

ExtremeProblem make(const ExtremeScene& given) {
  const std::vector<Structure> parts = {chain(1, 1, 3, given), chain(5, 8, 5, given)};
  const Structure apart = problems::merged(parts[0], parts[1]);
  const Joint joint(given);
  Structure assembly = apart;
  add(joint.springs(), assembly);
  const std::vector<double> frequency_hz = lines(given, {parts[0], parts[1], assembly});
  ExtremeProblem out;
  for (const Structure& part : parts) {
    out.sets.substructures.push_back(responses(part, {}, {part.dofs(), part.dofs(), frequency_hz, 0.0}, given.storage));
  }
  out.sets.assembly.push_back(responses(apart, joint.springs(), {apart.dofs(), apart.dofs(), frequency_hz, 0.0}, given.storage));
  out.scene.file = "stability";
  out.scene.joints = {joint.spec(given.form)};
  out.scene.identify.method = given.method;
  out.scene.identify.weighting = given.weighting;
  if (given.method == ident::Method::one) out.scene.identify.equations = {ident::Equation::nn, ident::Equation::nj};
  if (given.method == ident::Method::likelihood) {
    frf::NoiseModel model;
    model.kind = frf::NoiseKind::circular;
    model.level = 1e-3;
    out.scene.noise = ident::NoiseSection{.model = "circular", .level = model.level, .frf_model = model};
  }
  for (const Kind kind : {Kind::stiffness, Kind::hysteretic_damping}) {
    const std::vector<double> values = joint.unknowns(kind, given.form);
    out.truth.insert(out.truth.end(), values.begin(), values.end());
  }
  return out;
}

std::unique_ptr<ident::Plan> ExtremeProblem::plan(ident::Solver solver) const {
  ident::Scene chosen = scene;
  chosen.identify.solver = solver;
  return ident::make_plan(chosen, sets.substructures, sets.assembly);
}

}  // namespace jointid::stability
