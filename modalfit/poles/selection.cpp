#include "modalfit/poles/selection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "modalfit/poles/residues.hpp"

namespace jointid::modalfit {
namespace {

/// Mean square of the weighted residuals, at least 1: what is more than noise makes a mode less sure. Bounded line by line: a high peak
/// that no mode has yet does not make the others doubtful.
double misfit(const Residues& residues) {
  const double freedom = std::accumulate(residues.freedom.begin(), residues.freedom.end(), 0.0);
  const double cost = std::accumulate(residues.bounded_cost.begin(), residues.bounded_cost.end(), 0.0);
  return freedom > 0.0 ? std::max(1.0, cost / freedom) : 1.0;
}

/// The modes to drop now, least significant first.
std::vector<std::size_t> to_drop(const Residues& residues, double least, std::optional<std::size_t> modes) {
  std::vector<std::size_t> weak;
  for (std::size_t r = 0; r < residues.growth.size(); ++r) {
    if (modes || residues.growth[r] < least) weak.push_back(r);
  }
  std::ranges::sort(weak, {}, [&](std::size_t r) { return residues.growth[r]; });
  std::size_t surplus = weak.size();
  if (modes) surplus = residues.growth.size() > *modes ? residues.growth.size() - *modes : 0;
  weak.resize(std::min(surplus, (surplus + 3) / 4));
  return weak;
}

}  // namespace

std::vector<Pole> significant_poles(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind,
                                    std::vector<Pole> poles, std::optional<std::size_t> modes) {
  const double freedom = static_cast<double>(entries.size() * (kind.real_modes ? 1 : 2) + 2);
  while (!poles.empty()) {
    const Residues residues = fit_residues(band, entries, kind, poles);
    const double least = chi_square_quantile(freedom, significance_deviations) * misfit(residues);
    std::vector<std::size_t> drop = to_drop(residues, least, modes);
    if (drop.empty()) break;
    std::ranges::sort(drop, std::greater{});
    for (const std::size_t r : drop) poles.erase(poles.begin() + static_cast<std::ptrdiff_t>(r));
  }
  return poles;
}

}  // namespace jointid::modalfit
