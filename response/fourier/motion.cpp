#include "response/fourier/motion.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace jointid::response {
namespace {

constexpr int samples_per_harmonic = 16;
constexpr int most_angle_halvings = 100;
constexpr double angle_resolution = 4.0 * std::numeric_limits<double>::epsilon();  ///< of θ, rad

/// Re Σ c_k z^k by Horner's rule, written out as the compiler does not for std::complex.
double real_polynomial(const std::vector<Complex>& coefficients, double cosine, double sine) {
  double re = 0.0, im = 0.0;
  for (std::size_t k = coefficients.size(); k-- > 0;) {
    const double next = re * cosine - im * sine + coefficients[k].real();
    im = re * sine + im * cosine + coefficients[k].imag();
    re = next;
  }
  return re;
}

/// The same at many angles, given by their cosines and sines.
Eigen::ArrayXd real_polynomial(const std::vector<Complex>& coefficients, const Eigen::ArrayXd& cosine, const Eigen::ArrayXd& sine) {
  Eigen::ArrayXd re = Eigen::ArrayXd::Zero(cosine.size()), im = re, next(cosine.size());
  for (std::size_t k = coefficients.size(); k-- > 0;) {
    next = re * cosine - im * sine + coefficients[k].real();
    im = re * sine + im * cosine + coefficients[k].imag();
    re = next;
  }
  return re;
}

/// The root of a function with its slope between two places where it has different signs: Newton's steps, halves where they
/// leave.
template <class Function>
double root(const Function& function, double from, double to, double value_from) {
  double theta = 0.5 * (from + to);
  for (int i = 0; i < most_angle_halvings; ++i) {
    const auto [value, slope] = function(theta);
    if (value == 0.0) return theta;
    ((value > 0.0) == (value_from > 0.0) ? from : to) = theta;
    double next = theta - value / slope;
    if (!(next > from && next < to)) next = 0.5 * (from + to);
    if (std::abs(next - theta) <= angle_resolution) return next;
    theta = next;
  }
  return theta;
}

}  // namespace

void fill_powers(double theta, std::vector<Complex>& powers) {
  const double cosine = std::cos(theta), sine = std::sin(theta);
  double re = 1.0, im = 0.0;
  for (Complex& power : powers) {
    power = {re, im};
    const double next = re * cosine - im * sine;
    im = re * sine + im * cosine;
    re = next;
  }
}

Motion::Motion(Harmonics harmonics, Eigen::VectorXcd amplitudes)
    : harmonics_(std::move(harmonics)), amplitudes_(std::move(amplitudes)) {
  value_.resize(static_cast<std::size_t>(harmonics_.largest()) + 1);
  first_ = second_ = value_;
  for (Eigen::Index i = 0; i < harmonics_.size(); ++i) {
    const int n = harmonics_[i];
    const std::size_t k = static_cast<std::size_t>(n);
    if (n == 0) amplitudes_(i) = amplitudes_(i).real();
    value_[k] = amplitudes_(i);
    first_[k] = Complex(0.0, n) * amplitudes_(i);
    second_[k] = -static_cast<double>(n) * n * amplitudes_(i);
  }
}

double Motion::value(double theta) const { return real_polynomial(value_, std::cos(theta), std::sin(theta)); }

Motion::Slopes Motion::slopes(double theta) const {
  const double cosine = std::cos(theta), sine = std::sin(theta);
  return {real_polynomial(first_, cosine, sine), real_polynomial(second_, cosine, sine)};
}

Eigen::VectorXd Motion::by_unknowns(double theta) const {
  Eigen::VectorXd column(harmonics_.unknowns());
  std::vector<Complex> powers(value_.size());
  fill_powers(theta, powers);
  for (Eigen::Index i = 0; i < harmonics_.size(); ++i) {
    const Complex power = powers[static_cast<std::size_t>(harmonics_[i])];
    column(harmonics_.offset(i)) = power.real();
    if (harmonics_[i] > 0) column(harmonics_.offset(i) + 1) = -power.imag();
  }
  return column;
}

double Motion::reversal(double from, double to, double slope_from) const {
  const auto slope = [this](double theta) {
    const Slopes at = slopes(theta);
    return std::pair(at.first, at.second);
  };
  return root(slope, from, to, slope_from);
}

/// Where q̈ changes its sign, by halves: to a part of the interval that tells the sign of q̇.
double Motion::extreme_slope(double from, double to) const {
  const bool rising = slopes(from).second > 0.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (from + to);
    ((slopes(middle).second > 0.0) == rising ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

std::vector<double> Motion::reversals(double start, double span) const {
  std::vector<double> found;
  const double end = start + span;
  const int samples = static_cast<int>(std::ceil(samples_per_harmonic * harmonics_.largest() * span / (2.0 * std::numbers::pi)));
  const double step = span / samples;
  std::vector<Complex> turns(static_cast<std::size_t>(samples) + 1);
  fill_powers(step, turns);
  Eigen::ArrayXd cosine(samples + 1), sine(samples + 1);
  for (int i = 0; i <= samples; ++i) {
    const Complex at = std::polar(1.0, start) * turns[static_cast<std::size_t>(i)];
    cosine(i) = at.real();
    sine(i) = at.imag();
  }
  const Eigen::ArrayXd first = real_polynomial(first_, cosine, sine), second = real_polynomial(second_, cosine, sine);
  const auto add = [&](double theta) {
    if (theta < end) found.push_back(theta);
  };
  for (int i = 1; i <= samples; ++i) {
    const double from = start + (i - 1) * step, to = i == samples ? end : start + i * step;
    const Slopes before = {first(i - 1), second(i - 1)}, after = {first(i), second(i)};
    if ((before.first > 0.0) != (after.first > 0.0)) {
      add(reversal(from, to, before.first));
    } else if (before.first * before.second < 0.0 && after.first * after.second > 0.0) {
      const double middle = extreme_slope(from, to), slope = slopes(middle).first;
      if ((slope > 0.0) != (before.first > 0.0)) {
        add(reversal(from, middle, before.first));
        add(reversal(middle, to, slope));
      }
    }
  }
  return found;
}

double Motion::crossing(double from, double to, double target) const {
  const double value_from = value(from) - target, value_to = value(to) - target;
  if (value_from == 0.0 || (value_from > 0.0) == (value_to > 0.0)) return std::abs(value_from) <= std::abs(value_to) ? from : to;
  const auto distance = [&](double theta) {
    const double cosine = std::cos(theta), sine = std::sin(theta);
    return std::pair(real_polynomial(value_, cosine, sine) - target, real_polynomial(first_, cosine, sine));
  };
  return root(distance, from, to, value_from);
}

}  // namespace jointid::response
