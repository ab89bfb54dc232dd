#include "friction/law/slip_laws.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "friction/path/cancellation_free.hpp"

namespace jointid::friction {
namespace {

constexpr std::array power_parameters = {LawParameter{"a", "m", 0.0, infinity, true}, LawParameter{"b", "m", 0.0, infinity},
                                         LawParameter{"c", "1", 0.0, 50.0}, LawParameter{"k", "N/m", 0.0, infinity}};
constexpr std::array power_shapes = {0.7, 1.5, 3.0};

constexpr std::array square_parameters = {LawParameter{"a", "m", 0.0, infinity, true}, LawParameter{"b", "m", 0.0, infinity},
                                          LawParameter{"k", "N/m", 0.0, infinity}};
constexpr std::array square_shapes = {0.05, 0.3};

constexpr std::array offset_parameters = {LawParameter{"a", "m", 0.0, infinity}, LawParameter{"b", "1", 0.0, 700.0},
                                          LawParameter{"c", "m", -infinity, infinity}, LawParameter{"k", "N/m", 0.0, infinity}};

/// Where T has an algebraic singularity at the beginning of slip, quadratures split at these shares of the way to macroslip.
constexpr std::array graded = {1e-8, 1e-6, 1e-4, 1e-2, 0.1};

/// With a tenth of the mean slip displacement as a: ∫u = a + b/(c + 1) is the limit over the stiffness.
std::vector<double> power_start(const Features& f, double c) {
  const double mean = f.limit / f.stiffness;
  return {0.1 * mean, 0.9 * mean * (c + 1.0), c, f.stiffness};
}

std::vector<double> square_start(const Features& f, double share) {
  const double mean = f.limit / f.stiffness;
  return {share * mean, 3.0 * (1.0 - share) * mean, f.stiffness};
}

/// ∫₀ʰ e^{bη} dη, b > 0.
double grown(double b, double h) { return std::expm1(b * h) / b; }

}  // namespace

double PowerSlip::share(const Values& p, double u) { return std::pow((u - p[0]) / p[1], 1.0 / p[2]); }

double PowerSlip::first(const Values& p, double h) { return p[0] * h + p[1] * std::pow(h, p[2] + 1.0) / (p[2] + 1.0); }

double PowerSlip::second(const Values& p, double h) {
  const double c = p[2];
  return p[0] * p[0] * h + 2.0 * p[0] * p[1] * std::pow(h, c + 1.0) / (c + 1.0) +
         p[1] * p[1] * std::pow(h, 2.0 * c + 1.0) / (2.0 * c + 1.0);
}

PowerSlip::Values PowerSlip::first_by_parameters(const Values& p, double h) {
  if (h == 0.0) return {};
  const double c = p[2], by_b = std::pow(h, c + 1.0) / (c + 1.0);
  return {h, by_b, p[1] * by_b * (std::log(h) - 1.0 / (c + 1.0))};
}

double PowerSlip::at(const Values& p, double h) { return p[0] + p[1] * std::pow(h, p[2]); }

double SquareSlip::share(const Values& p, double u) { return std::sqrt((u - p[0]) / p[1]); }

double SquareSlip::first(const Values& p, double h) { return p[0] * h + p[1] * h * h * h / 3.0; }

double SquareSlip::second(const Values& p, double h) {
  const double h3 = h * h * h;
  return p[0] * p[0] * h + 2.0 * p[0] * p[1] * h3 / 3.0 + p[1] * p[1] * h3 * h * h / 5.0;
}

SquareSlip::Values SquareSlip::first_by_parameters(const Values&, double h) { return {h, h * h * h / 3.0}; }

double SquareSlip::at(const Values& p, double h) { return p[0] + p[1] * h * h; }

double OffsetSlip::share(const Values& p, double u) { return std::log1p((u - p[2] - p[0]) / p[0]) / p[1]; }

double OffsetSlip::first(const Values& p, double h) { return p[0] * grown(p[1], h) + p[2] * h; }

double OffsetSlip::second(const Values& p, double h) {
  return p[0] * p[0] * grown(2.0 * p[1], h) + 2.0 * p[0] * p[2] * grown(p[1], h) + p[2] * p[2] * h;
}

OffsetSlip::Values OffsetSlip::first_by_parameters(const Values& p, double h) {
  return {grown(p[1], h), p[0] * exponential_excess(p[1] * h) / (p[1] * p[1]), h};
}

double OffsetSlip::at(const Values& p, double h) { return p[0] * std::exp(p[1] * h) + p[2]; }

template <>
const Law SlipLaw<PowerSlip>::law = {"power", "microslip u = a + b h^c", power_parameters, {power_shapes, power_start}};
template <>
const Law SlipLaw<SquareSlip>::law = {"square", "microslip u = a + b h^2", square_parameters, {square_shapes, square_start}};
template <>
const Law SlipLaw<OffsetSlip>::law = {"exponential-offset", "microslip u = a exp(bh) + c", offset_parameters, {{}, nullptr}};

template <class Slip>
SlipLaw<Slip>::SlipLaw(std::span<const double> values) : ListedLaw<SlipLaw<Slip>>(values) {
  std::copy_n(values.begin(), Slip::parameters, slip_.begin());
  stiffness_ = values[Slip::parameters];
  if (Slip::begin(slip_) >= 0.0) return;
  refuse(std::string(law.name) + ": slip begins at " + std::to_string(Slip::begin(slip_)) + " m, u(0) must be >= 0");
}

template <class Slip>
double SlipLaw<Slip>::share(double u) const {
  if (u <= Slip::begin(slip_)) return 0.0;
  return u < Slip::at(slip_, 1.0) ? std::min(Slip::share(slip_, u), 1.0) : 1.0;
}

template <class Slip>
Response SlipLaw<Slip>::response(double u) const {
  const double h = share(u), stick = 1.0 - h;
  return {stiffness_ * (stick > 0.0 ? Slip::first(slip_, h) + stick * u : Slip::first(slip_, h)), stiffness_ * stick};
}

template <class Slip>
double SlipLaw<Slip>::energy(double u) const {
  const double h = share(u);
  return stiffness_ * (u * Slip::first(slip_, h) - 0.5 * Slip::second(slip_, h) + 0.5 * (1.0 - h) * u * u);
}

/// Every slider loses 4u(h)(u − u(h)).
template <class Slip>
double SlipLaw<Slip>::cycle_energy(double u) const {
  const double h = share(u);
  return 4.0 * stiffness_ * (u * Slip::first(slip_, h) - Slip::second(slip_, h));
}

template <class Slip>
std::vector<double> SlipLaw<Slip>::kinks() const {
  const double begin = Slip::begin(slip_), end = Slip::at(slip_, 1.0);
  std::vector<double> all;
  if (begin > 0.0) all.push_back(begin);
  for (const double part : graded) {
    const double u = begin + part * (end - begin);
    if (u > begin && u < end) all.push_back(u);
  }
  if (end > begin) all.push_back(end);
  return all;
}

template <class Slip>
std::vector<Parameter> SlipLaw<Slip>::parameters() const {
  std::vector<double> values(slip_.begin(), slip_.end());
  values.push_back(stiffness_);
  return with_values(law, values);
}

/// ∂T/∂h vanishes as u(h) = u, so only the integral moves with the parameters.
template <class Slip>
void SlipLaw<Slip>::derivative(double u, std::span<double> out) const {
  const double h = share(u);
  const auto by = Slip::first_by_parameters(slip_, h);
  for (std::size_t i = 0; i < by.size(); ++i) out[i] = stiffness_ * by[i];
  out[by.size()] = response(u).force / stiffness_;
}

template class SlipLaw<PowerSlip>;
template class SlipLaw<SquareSlip>;
template class SlipLaw<OffsetSlip>;

}  // namespace jointid::friction
