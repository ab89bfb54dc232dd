#include "ident/judgement/dominant_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/eigen.hpp"
#include "ident/judgement/value_scales.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double far_apart = 8.0;  // errors of the other lines
constexpr double most_left = 0.5;  // of the sum of squares, without the group
constexpr double least_moved = 0.05;

/// By how many errors each unknown moves, at least by so much of the largest of its kind.
struct Move {
  double errors = 0.0;
  Index column = 0;
};

Move largest_move(const VectorXd& from, const VectorXd& to, const VectorXd& deviation, const VectorXd& scale) {
  Move out;
  for (Index u = 0; u < from.size(); ++u) {
    const double by = std::abs(to[u] - from[u]);
    if (!(by > least_moved * scale[u])) continue;
    const double errors = by / std::max(deviation[u], 1e-12 * scale[u]);
    if (errors > out.errors) out = {errors, u};
  }
  return out;
}

VectorXd deviations(const Eigen::MatrixXd& covariance) { return covariance.diagonal().cwiseMax(0.0).cwiseSqrt(); }

/// The scatter of the estimates without a group when another one is left out as well.
std::optional<VectorXd> deviation_of_others(const Plan& plan, LineJackknife& jackknife, std::size_t group) {
  Eigen::MatrixXd found(jackknife.all.size(), jackknife.without.cols() - 1);
  Index column = 0;
  for (std::size_t other = 0; other < jackknife.groups.size(); ++other) {
    if (other == group) continue;
    const auto without = estimate_without(plan, jackknife.systems, {group, other});
    if (!without) return std::nullopt;
    found.col(column++) = without->theta;
  }
  return deviations(jackknife_scatter(found));
}

/// A group that decides the estimate, and the errors of the others.
struct DominantGroup {
  std::size_t group = 0;
  VectorXd deviation;
};

/// The group without which the others agree best, where they disagree with it: it has most of the residuals, or makes them.
std::optional<DominantGroup> dominant_group(const Plan& plan, LineJackknife& jackknife, const VectorXd& scale) {
  const auto least = std::ranges::min_element(jackknife.residual_without);
  if (!(*least < most_left * jackknife.residual)) return std::nullopt;
  const auto group = static_cast<std::size_t>(least - jackknife.residual_without.begin());
  auto deviation = deviation_of_others(plan, jackknife, group);
  if (!deviation) return std::nullopt;
  const VectorXd without = jackknife.without.col(at(group));
  if (!(largest_move(jackknife.all, without, *deviation, scale).errors > far_apart)) return std::nullopt;
  return DominantGroup{group, std::move(*deviation)};
}

/// FRFs of a system at a line of its own and the two beside it.
struct OddFrf {
  std::string name;
  double ratio = 1.0, second = 1.0;  ///< over its neighbours, and of the next FRF
};

/// |H| over the larger neighbour, or the smaller neighbour over |H|: at least 1.
double oddness(double before, double here, double after) {
  const double low = std::min(before, after), high = std::max(before, after);
  if (!std::isfinite(low + here + high) || !(low > 0.0) || !(here > 0.0)) return 1.0;
  return std::max({1.0, here / high, low / here});
}

void look_at(frf::FrfSystem& system, std::size_t line, const Dofs& rows, const Dofs& columns, const std::string& name,
             OddFrf& worst) {
  if (line == 0 || line + 1 >= system.frequency_hz().size() || rows.empty() || columns.empty()) return;
  const std::array<std::size_t, 3> lines = {line - 1, line, line + 1};
  const std::size_t each = rows.size() * columns.size();
  std::vector<Complex> values(3 * each);
  frf::BlockReader(system, rows, columns).read(lines, values);
  for (std::size_t i = 0; i < each; ++i) {
    const double odd = oddness(std::abs(values[i]), std::abs(values[each + i]), std::abs(values[2 * each + i]));
    if (odd <= worst.ratio) {
      worst.second = std::max(worst.second, odd);
      continue;
    }
    worst = {rows[i / columns.size()].name() + "/" + columns[i % columns.size()].name() + " of the " + name, odd, worst.ratio};
  }
}

/// Names the FRF that is odd at a line, where just one is.
void name_frf(const Plan& plan, const Line& line, DominantLine& out) {
  constexpr double odd = 30.0, odder_than_next = 3.0;
  const Coordinates& own = plan.coordinates;
  const Dofs rows = joined(own.responses, own.joint), columns = joined(own.references, own.joint);
  OddFrf worst;
  look_at(*plan.assembly, line.assembly, rows, columns, "assembly", worst);
  look_at(*plan.substructures, line.substructures, rows, columns, "substructures", worst);
  if (worst.ratio < odd || worst.ratio < odder_than_next * worst.second) return;
  out.frf = worst.name;
  out.over_neighbours = worst.ratio;
}

std::optional<DominantLine> line_in(const Plan& plan, LineJackknife& jackknife, const DominantGroup& dominant, const VectorXd& scale,
                                    const Control& control) {
  const std::vector<Line>& lines = jackknife.groups[dominant.group];
  std::vector<std::vector<Line>> alone;
  for (const Line& line : lines) alone.push_back({line});
  std::vector<minimise::Accumulator> systems = systems_of(plan, alone, control);
  minimise::Accumulator others(plan.columns->size(), systems.front().reduction());
  for (std::size_t g = 0; g < jackknife.systems.size(); ++g) {
    if (g != dominant.group) others.merge(jackknife.systems[g]);
  }
  systems.push_back(std::move(others));
  std::optional<DominantLine> out;
  std::size_t found = 0;
  double most = far_apart;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto without = estimate_without(plan, systems, {i});
    if (!without) continue;
    const Move move = largest_move(jackknife.all, without->theta, dominant.deviation, scale);
    if (!(move.errors > most)) continue;
    most = move.errors;
    found = i;
    out = DominantLine{.frequency_hz = lines[i].frequency_hz,
                       .column = static_cast<std::size_t>(move.column),
                       .with = jackknife.all[move.column],
                       .without = without->theta[move.column],
                       .frf = {}};
  }
  if (out) name_frf(plan, lines[found], *out);
  return out;
}

}  // namespace

std::optional<DominantLine> dominant_line(const Plan& plan, LineJackknife& jackknife, const std::vector<double>& y,
                                          const Control& control) {
  const VectorXd scale = largest_of_kind(plan, y);
  std::size_t looked_at = 0;
  for (const auto& group : jackknife.groups) looked_at += group.size();
  const VectorXd all = Eigen::Map<const VectorXd>(y.data(), at(y.size()));
  std::optional<LineJackknife> whole;
  if (looked_at < plan.lines.size() &&
      largest_move(jackknife.all, all, deviations(jackknife_scatter(jackknife.without)), scale).errors > far_apart) {
    whole = line_jackknife(plan, plan.lines.size(), control);
    if (!whole) return std::nullopt;
  }
  LineJackknife& used = whole ? *whole : jackknife;
  const auto group = dominant_group(plan, used, scale);
  return group ? line_in(plan, used, *group, scale, control) : std::nullopt;
}

}  // namespace jointid::ident
