#include "impedance/line_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/statistics.hpp"
#include "ident/scene/scene_failure.hpp"
#include "impedance/line/closed_forms.hpp"
#include "restrictions/unit.hpp"

namespace jointid::impedance {
namespace {

using Index = Eigen::Index;

Index index(std::size_t i) { return static_cast<Index>(i); }

/// z between halves out of a whole symmetric Z.
LawLayout between_halves(const LineScene& scene) {
  const auto& facing = scene.facing;
  const Index size = index(2 * facing.size());
  LawLayout out;
  out.place.resize(size * (size + 1) / 2, index(facing.size() * (facing.size() + 1) / 2));
  Index s = 0;
  const auto& dofs = scene.scene.joints.front().dofs;
  for (std::size_t i = 0; i < facing.size(); ++i) {
    for (std::size_t k = i; k < facing.size(); ++k) {
      Eigen::MatrixXd e = Eigen::MatrixXd::Zero(size, size);
      for (const auto& [p, q] : {std::pair(i, k), std::pair(k, i)}) {
        e(index(facing[p].first), index(facing[q].first)) = e(index(facing[p].second), index(facing[q].second)) = 1.0;
        e(index(facing[p].first), index(facing[q].second)) = e(index(facing[p].second), index(facing[q].first)) = -1.0;
      }
      out.place.col(s++) = triangle_of(e.cast<Complex>()).real();
      out.names.push_back(fmt::format("z({},{})", i + 1, k + 1));
      out.units.push_back(restrictions::unit(restrictions::Kind::stiffness, dofs[facing[i].first], dofs[facing[k].first]));
    }
  }
  return out;
}

void add_masses(const LineScene& scene, const WayResult& result, LawLayout& out) {
  const auto& dofs = scene.scene.joints.front().dofs;
  out.mass = Eigen::MatrixXd::Zero(index(result.elements.size()), index(dofs.size()));
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    const std::string whole = fmt::format("Z({},{})", i + 1, i + 1), own = fmt::format("m({})", i + 1);
    const auto found =
        std::ranges::find_if(result.elements, [&](const ElementName& e) { return e.name == whole || e.name == own; });
    if (found == result.elements.end()) {
      ident::fail(scene.scene, "[joint] law_masses", "the structure has no diagonal element of its own for " + dofs[i].name(),
                  "use lines = \"masses\" or \"symmetric\"");
    }
    out.mass(found - result.elements.begin(), index(i)) = 1.0;
    out.mass_names.push_back("m of " + dofs[i].name());
    out.mass_units.push_back(restrictions::unit(restrictions::Kind::mass, dofs[i], dofs[i]));
  }
}

/// The lines that contribute most to the difference of two χ², as a band.
std::string telling_band(const IdentifiedLines& found, const LawFit& best, const LawFit& other) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < best.by_line.size(); ++i) {
    if (std::isfinite(best.by_line[i]) && std::isfinite(other.by_line[i])) order.push_back(i);
  }
  std::ranges::sort(order, std::greater(), [&](std::size_t i) { return other.by_line[i] - best.by_line[i]; });
  double sum = 0.0;
  for (const std::size_t i : order) sum += std::max(0.0, other.by_line[i] - best.by_line[i]);
  std::size_t first = found.frequency_hz.size(), last = 0;
  double half = 0.0;
  for (const std::size_t i : order) {
    first = std::min(first, i);
    last = std::max(last, i);
    half += std::max(0.0, other.by_line[i] - best.by_line[i]);
    if (half >= 0.5 * sum) break;
  }
  return first > last ? ""
                      : fmt::format("; half of what separates them is from {:.4g} to {:.4g} Hz", found.frequency_hz[first],
                                    found.frequency_hz[last]);
}

}  // namespace

LawLayout law_layout(const LineScene& scene, const WayResult& result) {
  const bool whole_with_halves = result.structure == Structure::symmetric && !scene.facing.empty();
  LawLayout out;
  if (whole_with_halves) {
    out = between_halves(scene);
  } else {
    for (const ElementName& element : result.elements) {
      if (element.name.starts_with("m(")) continue;
      out.names.push_back(element.name);
      out.units.push_back(element.unit);
    }
    out.place = Eigen::MatrixXd::Zero(index(result.elements.size()), index(out.names.size()));
    for (std::size_t e = 0, s = 0; e < result.elements.size(); ++e) {
      if (!result.elements[e].name.starts_with("m(")) out.place(index(e), index(s++)) = 1.0;
    }
  }
  out.mass = Eigen::MatrixXd(index(result.elements.size()), 0);
  if (scene.law_masses) add_masses(scene, result, out);
  out.shared = scene.law_per_joint;
  return out;
}

void add_laws(const LineScene& scene, IdentifiedLines& out) {
  if (scene.laws.empty()) return;
  const WayResult& result = out.ways.front();
  std::vector<double> omega;
  for (const double hz : out.frequency_hz) omega.push_back(angular(hz));
  out.laws = fit_laws(scene.laws, law_layout(scene, result), omega, result.lines);
  const LawFit& best = out.laws.front();
  if (!best.converged) {
    if (out.status == Status::ok) out.status = Status::doubtful;
    out.message += std::string(out.message.empty() ? "" : " ") + "No law could be fitted to the lines.";
    return;
  }
  if (best.freedom > 0.0 && best.chi_square > chi_square_quantile(best.freedom, 5.0)) {
    if (out.status == Status::ok) out.status = Status::doubtful;
    out.message +=
        (out.message.empty() ? "" : " ") +
        fmt::format("No law of these explains the lines: the best, \"{}\", has χ²/f = {:.3g}. Z at the lines stays valid.",
                    name(best.law), best.chi_square / best.freedom);
  }
  if (out.laws.size() < 2 || !out.laws[1].converged) return;
  const double difference = out.laws[1].aic - best.aic;
  out.notes.push_back(fmt::format("Law \"{}\" by AIC; the runner-up is \"{}\", ΔAIC = {:.1f}{}{}.", name(best.law),
                                  name(out.laws[1].law), difference, telling_band(out, best, out.laws[1]),
                                  difference < 4.0 ? ". The lines do not separate them" : ""));
}

void add_smooth(const LineScene& scene, IdentifiedLines& out) {
  if (!scene.smoothing) return;
  constexpr std::size_t fewest = 8;
  const WayResult& result = out.ways.front();
  for (std::size_t e = 0; e < result.elements.size(); ++e) {
    SmoothElement one{e, {}, {}};
    std::vector<double> hz;
    for (std::size_t i = 0; i < result.lines.size(); ++i) {
      const auto& line = result.lines[i];
      if (!line || !std::isfinite(std::abs(line->z(index(e)))) || !(line->variance(index(e)) > 0.0)) continue;
      one.lines.push_back(i);
      hz.push_back(out.frequency_hz[i]);
    }
    if (one.lines.size() < fewest) continue;
    Eigen::VectorXcd z(index(one.lines.size()));
    Eigen::VectorXd variance(z.size());
    for (Index q = 0; q < z.size(); ++q) {
      const LineValue& line = *result.lines[one.lines[static_cast<std::size_t>(q)]];
      z(q) = line.z(index(e));
      variance(q) = line.variance(index(e));
    }
    const std::size_t splines = scene.splines > 0 ? scene.splines : std::clamp<std::size_t>(one.lines.size() / 3, 12, 40);
    one.fit = fit_spline(hz, z, variance, splines, *scene.smoothing, scene.lambda);
    if (one.fit.z.size() > 0) out.smooth.push_back(std::move(one));
  }
  out.notes.push_back(
      out.smooth.empty()
          ? fmt::format("No element was smoothed: that needs {} lines with a value.", fewest)
          : "Bands of the spline cover 95 % on average over the lines, not at each; smoothed values are no data for a law.");
}

}  // namespace jointid::impedance
