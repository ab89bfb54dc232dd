#include "ident/admissible/passive_band.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

#include "base/complex.hpp"
#include "ident/admissible/definite_block.hpp"
#include "ident/scene/scene_failure.hpp"
#include "restrictions/impedance_factor.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using ColumnsByBand = std::map<std::optional<Range>, std::map<std::size_t, std::size_t>>;

constexpr Kind viscous = Kind::viscous_damping, hysteretic = Kind::hysteretic_damping;

const restrictions::MatrixTerms& terms_of(const Plan& plan, Kind kind) {
  return *std::ranges::find(plan.restriction.matrices, kind, &restrictions::MatrixTerms::kind);
}

/// The bands of a joint's damping matrices; one without limits where there are none.
std::set<std::optional<Range>> bands_of(const ColumnsByBand& c, const ColumnsByBand& d) {
  std::set<std::optional<Range>> bands;
  for (const ColumnsByBand* each : {&c, &d}) {
    for (const auto& [band, columns] : *each) bands.insert(band);
  }
  if (bands.empty()) bands.insert(std::nullopt);
  return bands;
}

}  // namespace

ColumnsByBand columns_by_band(const Plan& plan, std::size_t joint, Kind kind) {
  ColumnsByBand out;
  for (std::size_t column = 0; column < plan.columns->size(); ++column) {
    const std::size_t unknown = plan.columns->unknown_of(column);
    if (plan.restriction.unknowns[unknown].joint != joint || plan.restriction.unknowns[unknown].kind != kind) continue;
    out[plan.columns->band_of(column)][unknown] = column;
  }
  return out;
}

std::string plain_number(double value) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

void require_damping(const Scene& scene) {
  const bool has = std::ranges::any_of(scene.joints, [](const restrictions::JointSpec& joint) {
    return joint.matrices.contains(viscous) || joint.matrices.contains(hysteretic);
  });
  if (!scene.identify.passive_hz || has) return;
  fail(scene, "[identify] passive", "no joint has viscous or hysteretic damping",
       "add a damping matrix to a joint, or leave passive out");
}

void add_passive(const Plan& plan, std::size_t joint, std::size_t first, AdmissibleSet& set) {
  const restrictions::JointSpec& spec = plan.scene.joints[joint];
  const bool has_c = spec.matrices.contains(viscous), has_d = spec.matrices.contains(hysteretic);
  if (!has_c && !has_d) return;
  ColumnsByBand of_c = columns_by_band(plan, joint, viscous), of_d = columns_by_band(plan, joint, hysteretic);
  const double unit = unscale(has_d ? hysteretic : viscous, plan.omega0);
  const std::string name = spec.name.empty() ? "Im Z" : "Im " + spec.name + ".Z";
  for (const auto& band : bands_of(of_c, of_d)) {
    Range ends = *plan.scene.identify.passive_hz;
    if (band) ends = {std::max(ends[0], (*band)[0]), std::min(ends[1], (*band)[1])};
    if (band && !(ends[0] < ends[1])) continue;
    if (!has_d || !has_c) ends[0] = ends[1];  // one of them alone has the same sign at all frequencies
    for (const double end : std::set<double>{ends[0], ends[1]}) {
      std::vector<BlockPart> parts;
      if (has_d) parts.push_back({terms_of(plan, hysteretic), of_d[band], unscale(hysteretic, plan.omega0), 1.0});
      if (has_c)
        parts.push_back({terms_of(plan, viscous), of_c[band], unscale(viscous, plan.omega0), has_d ? angular(end) : 1.0});
      auto block = definite_block(parts, first, spec.dofs.size(), unit);
      if (!block) {
        fail(plan.scene, "[identify] passive",
             "the damping matrices of " + (spec.name.empty() ? "the joint" : "joint '" + spec.name + "'") + " are not symmetric",
             "use pattern = \"symmetric\" or a symmetric matrix, or leave passive out");
      }
      if (block->size() == 0) continue;
      const std::string where = has_c && has_d ? name + " at " + plain_number(end) + " Hz" : name;
      set.inequalities.push_back(
          {where + " positive semidefinite", "[identify] passive", where + " is singular", std::move(*block)});
    }
  }
}

}  // namespace jointid::ident
