#include "oscillation/delay/wolf.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "oscillation/delay/checked_series.hpp"
#include "oscillation/delay/neighbours.hpp"

namespace jointid::oscillation {
namespace {

class Wolf {
 public:
  Wolf(std::span<const double> x, const WolfOptions& options)
      : options_(options),
        points_(delay_points(x, options.embedding)),
        partners_(points_.topRows(points_.rows() - at(options.evolve) - 1)),
        neighbours_(partners_, options.theiler) {}

  WolfExponent run() {
    const auto end = static_cast<std::size_t>(partners_.rows());
    WolfExponent out;
    double bits = 0.0;
    std::optional<std::size_t> partner;
    for (std::size_t i = 0; i + options_.evolve < end;) {
      if (!partner) partner = nearest(i);
      if (!partner) {
        ++i;
        continue;
      }
      const std::size_t next = i + options_.evolve, moved = *partner + options_.evolve;
      if (moved >= static_cast<std::size_t>(points_.rows())) {  // a pair that was kept to the end of the record
        partner.reset();
        continue;
      }
      bits += std::log2(distance(next, moved) / distance(i, *partner));
      ++out.pairs;
      const std::optional<std::size_t> instead = replacement(next, moved);
      out.replaced += instead ? 1U : 0U;
      partner = instead.value_or(moved);
      i = next;
    }
    const double time = static_cast<double>(options_.evolve) * options_.sample_time * static_cast<double>(out.pairs);
    out.bits_per_second = out.pairs > 0 ? bits / time : nan;
    return out;
  }

 private:
  struct Partner {
    std::size_t index;
    double distance;
  };

  double distance(std::size_t i, std::size_t j) const { return (points_.row(at(i)) - points_.row(at(j))).norm(); }

  /// Ascending by index: of several equals the first counts.
  std::vector<Partner> shell(std::size_t i) const {
    std::vector<Partner> out;
    neighbours_.within(i, options_.largest, [&](std::size_t j) {
      if (const double length = distance(i, j); length > options_.smallest && length <= options_.largest) out.push_back({j, length});
    });
    std::ranges::sort(out, {}, &Partner::index);
    return out;
  }

  static std::optional<std::size_t> nearest(const std::vector<Partner>& of) {
    if (of.empty()) return std::nullopt;
    return std::ranges::min_element(of, {}, &Partner::distance)->index;
  }
  std::optional<std::size_t> nearest(std::size_t i) const { return nearest(shell(i)); }

  std::optional<std::size_t> replacement(std::size_t i, std::size_t now) const {
    const std::vector<Partner> all = shell(i);
    const Eigen::RowVectorXd direction = points_.row(at(now)) - points_.row(at(i));
    const double length = direction.norm();
    std::optional<std::size_t> best;
    double largest = std::cos(options_.widest_angle);
    for (const Partner& each : all) {
      const double cosine = std::abs((points_.row(at(each.index)) - points_.row(at(i))).dot(direction)) / (each.distance * length);
      if (best ? cosine > largest : cosine >= largest) best = each.index, largest = cosine;
    }
    return best ? best : nearest(all);
  }

  const WolfOptions& options_;
  RowMatrixXd points_, partners_;
  Neighbours neighbours_;
};

}  // namespace

WolfExponent wolf_exponent(std::span<const double> x, const WolfOptions& options) {
  if (options.evolve == 0) wrong_option("evolve", "is 0");
  if (!(options.sample_time > 0.0)) wrong_option("sample_time", "is not above 0");
  if (!(options.smallest >= 0.0)) wrong_option("smallest", "is below 0");
  if (!(options.largest > options.smallest)) wrong_option("largest", "is not above the smallest distance");
  check_series(x, (options.embedding.dimension - 1) * options.embedding.delay + 2 * options.evolve + 3);
  return Wolf(x, options).run();
}

}  // namespace jointid::oscillation
