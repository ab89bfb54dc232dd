#include "records/order/order_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/error.hpp"
#include "dense/cholesky.hpp"

namespace jointid::records {
namespace {

constexpr double fewest_periods = 8.0;
constexpr double highest_share = 0.45;  ///< of the rate
constexpr int most_neighbours = 30;     ///< orders n ± j/periods whose noise counts, j up to this …
constexpr double widest = 0.45;         ///< … and at most this far

[[noreturn]] void fail(const Record& record, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, record.file, {}, std::move(problem), std::move(remedy)});
}

/// Samples, their s and φ.
struct Axis {
  Axis(const Record& record, const OrderStretch& stretch)
      : first(first_sample(record, stretch)), s(jointid::at(sample_count(record, stretch))), phase(s.size()) {
    for (Eigen::Index i = 0; i < s.size(); ++i) {
      const double tau = (static_cast<double>(first) + static_cast<double>(i)) / record.rate_hz - stretch.middle_s;
      s(i) = 2.0 * tau / stretch.length_s;
      phase(i) = stretch.phase + tau * (stretch.omega + 0.5 * stretch.rate * tau);
    }
  }
  std::size_t first;
  Eigen::VectorXd s, phase;
};

/// The functions of the fit, a column each: powers of s; of each order n their products with cos nφ and −sin nφ.
class Functions {
 public:
  Functions(const Axis& axis, int orders, int degree)
      : powers_(degree + 1), values_(axis.s.size(), static_cast<Eigen::Index>(powers_) * (1 + 2 * orders)) {
    for (Eigen::Index i = 0; i < axis.s.size(); ++i) {
      double power = 1.0;
      for (int p = 0; p < powers_; ++p, power *= axis.s(i)) {
        values_(i, p) = power;
        for (int n = 1; n <= orders; ++n) {
          values_(i, place(n, p)) = power * std::cos(n * axis.phase(i));
          values_(i, place(n, p) + 1) = -power * std::sin(n * axis.phase(i));
        }
      }
    }
  }

  /// Of the real part of X_n's coefficient of s^p; that of its imaginary part is next.
  Eigen::Index place(int n, int p) const { return powers_ + 2 * ((n - 1) * powers_ + p); }
  const Eigen::MatrixXd& values() const { return values_; }

 private:
  int powers_;
  Eigen::MatrixXd values_;
};

/// What is left of a channel at orders beside n, as mean squares of Re and Im of a phasor.
class Neighbours {
 public:
  Neighbours(const Axis& axis, double periods, int orders, int degree)
      : axis_(axis), periods_(periods), orders_(orders), first_(2 + degree) {}

  struct Noise {
    Eigen::RowVectorXd variance;  ///< of each channel
    double freedom = 0.0;
  };
  /// `left`: [sample, channel]
  Noise beside(int n, const Eigen::MatrixXd& left) const {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(left.cols());
    int count = 0;
    for (int j = first_; j <= most_neighbours && j / periods_ <= widest; ++j) {
      for (const double order : {n - j / periods_, n + j / periods_}) {
        if (!is_between(order)) continue;
        sum += squares(order, left);
        ++count;
      }
    }
    if (count > 0) sum /= 2.0 * count;
    return {sum, 2.0 * count};
  }

 private:
  bool is_between(double order) const {
    const double nearest = std::clamp(std::round(order), 0.0, static_cast<double>(orders_));
    return std::abs(order - nearest) >= 0.999 * first_ / periods_ && order > 0.0;
  }

  /// |phasor|² of each channel.
  Eigen::RowVectorXd squares(double order, const Eigen::MatrixXd& left) const {
    const Eigen::ArrayXd angle = order * axis_.phase.array();
    const Eigen::RowVectorXd real = angle.cos().matrix().transpose() * left, imaginary = angle.sin().matrix().transpose() * left;
    const double factor = 2.0 / static_cast<double>(left.rows());
    return factor * factor * (real.cwiseAbs2() + imaginary.cwiseAbs2());
  }

  const Axis& axis_;
  double periods_;
  int orders_, first_;
};

double variance_of(const Eigen::VectorXd& samples) { return (samples.array() - samples.mean()).square().mean(); }

void require_enough(const Record& record, const OrderStretch& stretch, int orders) {
  if (stretch.periods() < fewest_periods - 1e-6) {
    fail(record,
         fmt::format("{:.3g} s at {:.6g} Hz are {:.1f} periods, too few for phasors and their errors", stretch.length_s,
                     hertz(stretch.omega), stretch.periods()),
         fmt::format("record {:.0f} periods at least, or shorten `settle`", fewest_periods));
  }
  const double highest = orders * hertz(stretch.omega + 0.5 * std::abs(stretch.rate) * stretch.length_s);
  if (highest > highest_share * record.rate_hz) {
    fail(record,
         fmt::format("order {} at {:.6g} Hz is above {:.2g} of the rate of {:.6g} Hz", orders, highest, highest_share,
                     record.rate_hz),
         "name fewer harmonics, or sample faster");
  }
}

}  // namespace

std::size_t first_sample(const Record& record, const OrderStretch& stretch) {
  return static_cast<std::size_t>(std::max(0.0, std::ceil((stretch.middle_s - 0.5 * stretch.length_s) * record.rate_hz - 1e-6)));
}

std::size_t sample_count(const Record& record, const OrderStretch& stretch) {
  const std::size_t first = first_sample(record, stretch);
  const double last = (stretch.middle_s + 0.5 * stretch.length_s) * record.rate_hz - 1e-6;
  return std::min(record.samples(), static_cast<std::size_t>(std::max(0.0, std::ceil(last)))) - std::min(record.samples(), first);
}

OrderFit fit_orders(const Record& record, const OrderStretch& stretch, const std::vector<int>& harmonics, int degree,
                    NoiseOfOrders noise) {
  const int orders = harmonics.back() + 1;
  require_enough(record, stretch, orders);
  const Axis axis(record, stretch);
  const Functions functions(axis, orders, degree);
  const Eigen::Index rows = jointid::at(harmonics.size()), channels = jointid::at(record.channels.size());
  Eigen::MatrixXd samples(axis.s.size(), channels);
  for (Eigen::Index c = 0; c < channels; ++c)
    samples.col(c) = Eigen::Map<const Eigen::VectorXd>(record.channels[static_cast<std::size_t>(c)].samples.data() + axis.first,
                                                       axis.s.size());
  const Eigen::MatrixXd& f = functions.values();
  Eigen::MatrixXd right(f.cols(), channels + f.cols());
  right << f.transpose() * samples, Eigen::MatrixXd::Identity(f.cols(), f.cols());
  const Eigen::MatrixXd solved = dense::solve_positive(Eigen::MatrixXd(f.transpose() * f), right);
  const Eigen::MatrixXd found = solved.leftCols(channels), inverse = solved.rightCols(f.cols());
  const Eigen::MatrixXd left = samples - f * found;

  OrderFit fit;
  fit.value = fit.slope = fit.bend = Eigen::MatrixXcd::Zero(rows, channels);
  fit.deviation = fit.freedom = Eigen::MatrixXd::Zero(rows, channels);
  fit.explained.resize(channels);
  const auto total = static_cast<double>(axis.s.size());
  const Neighbours neighbours(axis, stretch.periods(), orders, degree);
  std::vector<Neighbours::Noise> noises;
  if (noise == NoiseOfOrders::told) {
    for (const int n : harmonics) noises.push_back(neighbours.beside(n, left));
  }
  for (Eigen::Index c = 0; c < channels; ++c) {
    const double all = variance_of(samples.col(c));
    fit.explained(c) = all > 0.0 ? 1.0 - variance_of(left.col(c)) / all : 0.0;
    for (Eigen::Index row = 0; row < rows; ++row) {
      const int n = harmonics[static_cast<std::size_t>(row)];
      const auto coefficient = [&](int p) {
        const Eigen::Index place = functions.place(n, p);
        return Complex(found(place, c), found(place + 1, c));
      };
      fit.value(row, c) = coefficient(0);
      if (degree > 0) fit.slope(row, c) = coefficient(1);
      if (degree > 1) fit.bend(row, c) = coefficient(2);
      if (noises.empty()) continue;
      const Neighbours::Noise& own = noises[static_cast<std::size_t>(row)];
      const double one = 0.5 * total * inverse(functions.place(n, 0), functions.place(n, 0));  // 1 for whole periods and degree 0
      fit.deviation(row, c) = std::sqrt(own.variance(c) * one);
      fit.freedom(row, c) = own.freedom;
    }
  }
  if (degree > 0) {
    const Eigen::Index value = functions.place(1, 0), slope = functions.place(1, 1);
    fit.slope_deviation = std::sqrt(inverse(slope, slope) / inverse(value, value));
  }
  return fit;
}

}  // namespace jointid::records
