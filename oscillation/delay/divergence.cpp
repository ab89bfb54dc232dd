#include "oscillation/delay/divergence.hpp"

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"
#include "oscillation/delay/checked_series.hpp"
#include "oscillation/delay/neighbours.hpp"

namespace jointid::oscillation {
namespace {

/// Points and their neighbours, of those that can be followed for all steps.
struct Followed {
  Followed(std::span<const double> x, const DivergenceOptions& options) : points(delay_points(x, options.embedding)) {
    if (!(options.sample_time > 0.0)) wrong_option("sample_time", "is not above 0");
    if (static_cast<std::size_t>(points.rows()) < options.steps + 2) {
      wrong_option("steps", std::to_string(options.steps) + " are more than " + std::to_string(points.rows()) + " points allow");
    }
    starts = points.topRows(points.rows() - at(options.steps));
  }
  RowMatrixXd points, starts;
};

DivergenceCurve empty_curve(const DivergenceOptions& options, double radius) {
  DivergenceCurve curve{options.embedding.dimension, radius, {}, {}};
  for (std::size_t k = 0; k <= options.steps; ++k) curve.time.push_back(static_cast<double>(k) * options.sample_time);
  return curve;
}

/// Means of the logarithms that there are.
struct LogMeans {
  explicit LogMeans(std::size_t size) : sum(size, 0.0), count(size, 0.0) {}
  void add(std::size_t k, double distance) {
    if (distance > 0.0) sum[k] += std::log(distance), count[k] += 1.0;
  }
  std::vector<double> means() const {
    std::vector<double> out(sum.size(), nan);
    for (std::size_t k = 0; k < sum.size(); ++k) {
      if (count[k] > 0.0) out[k] = sum[k] / count[k];
    }
    return out;
  }
  std::vector<double> sum, count;
};

RecordExponent judged(std::vector<DivergenceCurve> curves, const PlateauOptions& options, double agreement) {
  RecordExponent out;
  out.curves = std::move(curves);
  double low = 0.0, high = 0.0, sum = 0.0;
  for (const DivergenceCurve& curve : out.curves) {
    out.plateaus.push_back(find_plateau(curve.time, curve.mean_log, options));
    if (!out.plateaus.back()) {
      out.reason = "no plateau in " + std::to_string(curve.dimension) + " dimensions";
      continue;
    }
    const double slope = out.plateaus.back()->slope;
    low = sum == 0.0 ? slope : std::min(low, slope);
    high = std::max(high, slope);
    sum += slope;
  }
  if (!out.reason.empty()) return out;
  const double mean = sum / static_cast<double>(out.curves.size());
  out.spread = 0.5 * (high - low);
  if (out.spread > agreement * mean) {
    out.reason = "the slopes of the dimensions differ";
    return out;
  }
  out.nats_per_second = mean;
  return out;
}

}  // namespace

DivergenceCurve rosenstein_curve(std::span<const double> x, const DivergenceOptions& options) {
  const Followed followed(x, options);
  const Neighbours neighbours(followed.starts, options.theiler);
  const auto count = static_cast<std::size_t>(followed.starts.rows());
  LogMeans logs(options.steps + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto near = neighbours.nearest(i, count);
    if (!near) continue;
    for (std::size_t k = 0; k <= options.steps; ++k) {
      logs.add(k, (followed.points.row(at(i + k)) - followed.points.row(at(near->index + k))).norm());
    }
  }
  DivergenceCurve curve = empty_curve(options, 0.0);
  curve.mean_log = logs.means();
  return curve;
}

DivergenceCurve kantz_curve(std::span<const double> x, const DivergenceOptions& options, double radius) {
  if (!(radius > 0.0)) wrong_option("radius", "is not above 0");
  const Followed followed(x, options);
  const Neighbours neighbours(followed.starts, options.theiler);
  const Eigen::Index last = followed.points.cols() - 1;
  LogMeans logs(options.steps + 1);
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < static_cast<std::size_t>(followed.starts.rows()); ++i) {
    near.clear();
    neighbours.within(i, radius, [&](std::size_t j) { near.push_back(j); });
    if (near.size() < 5) continue;
    for (std::size_t k = 0; k <= options.steps; ++k) {
      double mean = 0.0;
      for (const std::size_t j : near) mean += std::abs(followed.points(at(i + k), last) - followed.points(at(j + k), last));
      logs.add(k, mean / static_cast<double>(near.size()));
    }
  }
  DivergenceCurve curve = empty_curve(options, radius);
  curve.mean_log = logs.means();
  return curve;
}

RecordExponent largest_exponent_rosenstein(std::span<const double> x, const DivergenceOptions& options,
                                           const PlateauOptions& plateau, double agreement) {
  std::vector<DivergenceCurve> curves;
  DivergenceOptions each = options;
  for (std::size_t more = 0; more < 3; ++more) {
    each.embedding.dimension = options.embedding.dimension + more;
    curves.push_back(rosenstein_curve(x, each));
  }
  return judged(std::move(curves), plateau, agreement);
}

RecordExponent largest_exponent_kantz(std::span<const double> x, const DivergenceOptions& options, const PlateauOptions& plateau,
                                      double agreement) {
  check_series(x, 2);
  const double sigma = deviation(x);
  std::vector<DivergenceCurve> curves;
  DivergenceOptions each = options;
  for (std::size_t more = 0; more < 3; ++more) {
    each.embedding.dimension = options.embedding.dimension + more;
    for (const double share : {0.1, 0.2}) curves.push_back(kantz_curve(x, each, share * sigma));
  }
  return judged(std::move(curves), plateau, agreement);
}

}  // namespace jointid::oscillation
