#include <algorithm>
#include <cmath>
#include <set>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "ident/admissible/admissible_set.hpp"
#include "ident/admissible/constraint_phrases.hpp"
#include "ident/admissible/definite_block.hpp"
#include "ident/admissible/eigenfrequencies.hpp"
#include "ident/admissible/interior.hpp"
#include "ident/admissible/passive_band.hpp"
#include "ident/admissible/tie.hpp"
#include "ident/scene/scene_failure.hpp"
#include "restrictions/impedance_factor.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using restrictions::Kind;

std::vector<std::string> names_of(const Plan& plan) {
  std::vector<std::string> names;
  for (std::size_t column = 0; column < plan.columns->size(); ++column)
    names.push_back(plan.columns->name(column, plan.restriction));
  return names;
}

[[noreturn]] void refuse_asymmetric(const Scene& scene, const std::string& place) {
  fail(scene, place, "only a symmetric matrix can be required to be definite",
       "use pattern = \"symmetric\" or a symmetric matrix, or remove definite");
}

void add_definite(const Plan& plan, std::size_t joint, std::size_t first, Kind kind, AdmissibleSet& set) {
  const restrictions::JointSpec& spec = plan.scene.joints[joint];
  const auto terms = std::ranges::find(plan.restriction.matrices, kind, &restrictions::MatrixTerms::kind);
  const std::string place =
      (spec.name.empty() ? "[joint." + restrictions::key(kind) + "]" : "joint '" + spec.name + "', " + restrictions::key(kind)) +
      " definite";
  const std::string symbol = (spec.name.empty() ? "" : spec.name + ".") + restrictions::symbol(kind);
  auto bands = columns_by_band(plan, joint, kind);
  if (bands.empty()) bands[std::nullopt] = {};  // all known
  for (const auto& [band, column_of] : bands) {
    const double unit = unscale(kind, plan.omega0);
    auto block = definite_block(*terms, first, spec.dofs.size(), column_of, unit);
    if (!block) refuse_asymmetric(plan.scene, place);
    if (block->size() == 0) continue;
    const std::string where = band ? "@" + plain_number((*band)[0]) + "-" + plain_number((*band)[1]) + "Hz" : "";
    const std::string name = symbol + where;
    set.inequalities.push_back({name + " positive semidefinite", place, name + " is singular", std::move(*block)});
  }
}

std::size_t column_named(const Plan& plan, const std::vector<std::string>& names, const std::string& name, const char* place) {
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::string near = nearest_word(name, names);
  fail(plan.scene, place, "the joint has no unknown " + name,
       near.empty() ? "`jointid plan` lists them" : "did you mean " + near + "?");
}

void add_bounds(const Plan& plan, const std::vector<std::string>& names, AdmissibleSet& set) {
  for (const Bound& bound : plan.scene.identify.bounds) {
    const std::size_t column = column_named(plan, names, bound.unknown, "[identify] bounds");
    const std::string unit = plan.restriction.unknowns[plan.columns->unknown_of(column)].unit;
    const auto add = [&](double limit, double sign, const char* relation, const char* which) {
      if (!std::isfinite(limit)) return;
      SymmetricBlock block{Eigen::MatrixXd::Constant(1, 1, -sign * limit / plan.unscale(column)), {at(column)}, {{{0, 0, sign}}}};
      set.inequalities.push_back({bound.unknown + relation + plain_number(limit) + (limit == 0.0 ? "" : " " + unit),
                                  "[identify] bounds", std::string("at its ") + which + " bound", std::move(block)});
    };
    add(bound.lower, 1.0, " >= ", "lower");
    add(bound.upper, -1.0, " <= ", "upper");
  }
}

void add_inequalities(const Plan& plan, const std::vector<std::string>& names, AdmissibleSet& set) {
  for (const std::string& text : plan.scene.identify.inequalities) {
    try {
      for (const LinearInequality& each : parse_inequality(text, names)) {
        Eigen::VectorXd scaled = each.coefficients;
        for (Index column = 0; column < scaled.size(); ++column) scaled[column] *= plan.unscale(static_cast<std::size_t>(column));
        const double unit = scaled.cwiseAbs().maxCoeff();
        SymmetricBlock block{Eigen::MatrixXd::Constant(1, 1, each.constant / unit), {}, {}};
        for (Index column = 0; column < scaled.size(); ++column) {
          if (scaled[column] == 0.0) continue;
          block.unknowns.push_back(column);
          block.coefficients.push_back({{0, 0, scaled[column] / unit}});
        }
        set.inequalities.push_back({each.text, "[identify] inequalities", "at the limit of " + each.text, std::move(block)});
      }
    } catch (const InputError& error) {
      fail(plan.scene, "[identify] inequalities", error.parts().problem, error.parts().remedy);
    }
  }
}

void add_ties(const Plan& plan, const std::vector<std::string>& names, AdmissibleSet& set) {
  set.ties = plan.scene.identify.ties;
  if (set.ties.empty()) return;
  std::vector<Tie> ties;
  std::set<Index> tied;
  try {
    for (const std::string& text : set.ties) {
      Tie tie = parse_tie(text, names);
      for (Index column = 0; column < tie.coefficients.size(); ++column) {
        if (tie.coefficients[column] == 0.0) continue;
        tie.coefficients[column] *= plan.unscale(static_cast<std::size_t>(column));
        tied.insert(column);
      }
      ties.push_back(std::move(tie));
    }
    auto [offset, directions] = eliminate(std::move(ties), at(names.size()));
    set.offset = std::move(offset);
    set.directions = std::move(directions);
  } catch (const InputError& error) {
    fail(plan.scene, "[identify] ties", error.parts().problem, error.parts().remedy);
  }
  set.tied.assign(tied.begin(), tied.end());
}

/// All inequalities together must leave room; if they do not, perhaps one alone does not.
void require_room(const Scene& scene, Index unknowns, AdmissibleSet& set) {
  std::vector<SymmetricBlock> all;
  std::string texts;
  for (const Inequality& inequality : set.inequalities) {
    all.push_back(inequality.block);
    texts += (texts.empty() ? "" : ", ") + inequality.text;
  }
  if (all.empty()) return;
  if (auto inside = interior_point_by_parts(all, set, unknowns)) {
    set.inside = std::move(*inside);
    return;
  }
  for (const Inequality& inequality : set.inequalities) {
    if (interior_point({inequality.block}, set, unknowns)) continue;
    fail(scene, inequality.place,
         "no joint" + std::string(set.ties.empty() ? "" : " that meets the ties") + " has " + inequality.text +
             " with room to spare: the pattern or its known elements forbid it or force it to its edge",
         "remove it, or change the pattern (a zero on the diagonal forces its row to zero)");
  }
  fail(scene, "[identify]", "no joint meets these together with room to spare: " + texts, "remove or widen one of them");
}

bool asks(const Scene& scene) {
  const IdentifySection& of = scene.identify;
  return !of.bounds.empty() || !of.ties.empty() || !of.inequalities.empty() || of.passive_hz ||
         (!of.frequencies_hz.empty() && !frequencies_are_data(scene)) ||
         std::ranges::any_of(scene.joints, [](const restrictions::JointSpec& joint) { return !joint.definite.empty(); });
}

void require_support(const Scene& scene) {
  if (scene.identify.solver != Solver::iqml) return;
  fail(scene, "[identify]", "solver \"iqml\" knows no constraints (definite, bounds, ties, inequalities, passive)",
       "use method \"likelihood\" with solver \"auto\", or a linear method");
}

}  // namespace

std::shared_ptr<const AdmissibleSet> plan_admissible(const Plan& plan) {
  if (!asks(plan.scene)) return nullptr;
  require_support(plan.scene);
  require_damping(plan.scene);
  require_frequencies(plan);
  auto set = std::make_shared<AdmissibleSet>();
  std::size_t first = 0;
  for (std::size_t joint = 0; joint < plan.scene.joints.size(); ++joint) {
    const restrictions::JointSpec& spec = plan.scene.joints[joint];
    for (const Kind kind : spec.definite) {
      if (spec.matrices.contains(kind)) add_definite(plan, joint, first, kind, *set);
    }
    if (plan.scene.identify.passive_hz) add_passive(plan, joint, first, *set);
    first += spec.dofs.size();
  }
  const std::vector<std::string> names = names_of(plan);
  add_bounds(plan, names, *set);
  add_inequalities(plan, names, *set);
  add_ties(plan, names, *set);
  require_room(plan.scene, at(names.size()), *set);
  std::erase_if(set->inequalities,
                [](const Inequality& inequality) { return inequality.block.unknowns.empty(); });  // known to hold
  return set;
}

std::vector<std::string> constraint_phrases(const Plan& plan) {
  if (!plan.admissible) return {};
  std::vector<std::string> out = plan.admissible->ties;
  for (const double hz : plan.scene.identify.frequencies_hz) out.push_back(plain_number(hz) + " Hz is an eigenfrequency");
  for (const Inequality& inequality : plan.admissible->inequalities) out.push_back(inequality.text);
  return out;
}

}  // namespace jointid::ident
