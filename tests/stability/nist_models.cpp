#include "nist_models.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace jointid::stability {
namespace {

constexpr double pi = std::numbers::pi;

template <class T>
using B = std::span<const T>;
using X = std::span<const double>;

double arctan(double x) { return std::atan(x); }

/// That of glibc loses imaginary parts as small as those of complex steps.
std::complex<double> arctan(std::complex<double> x) { return {std::atan(x.real()), x.imag() / (1.0 + x.real() * x.real())}; }

template <class T>
T exponentials(X x, B<T> b) {
  return b[0] * exp(-b[1] * x[0]) + b[2] * exp(-b[3] * x[0]) + b[4] * exp(-b[5] * x[0]);
}

template <class T>
T gauss(X x, B<T> b) {
  const auto bell = [&](std::size_t at) {
    const T u = (x[0] - b[at + 1]) / b[at + 2];
    return b[at] * exp(-u * u);
  };
  return b[0] * exp(-b[1] * x[0]) + bell(2) + bell(5);
}

template <class T>
T cubic_ratio(X given, B<T> b) {
  const double x = given[0];
  return (b[0] + x * (b[1] + x * (b[2] + x * b[3]))) / (1.0 + x * (b[4] + x * (b[5] + x * b[6])));
}

template <class T>
T enso(X given, B<T> b) {
  const double x = 2.0 * pi * given[0];
  return b[0] + b[1] * std::cos(x / 12.0) + b[2] * std::sin(x / 12.0) + b[4] * cos(x / b[3]) + b[5] * sin(x / b[3]) + b[7] * cos(x / b[6]) +
         b[8] * sin(x / b[6]);
}

template <class T>
using Model = T (*)(X, B<T>);

template <class T>
const std::map<std::string, Model<T>>& models() {
  static const std::map<std::string, Model<T>> all = {
      {"Bennett5", [](X x, B<T> b) -> T { return b[0] * pow(b[1] + x[0], -1.0 / b[2]); }},
      {"BoxBOD", [](X x, B<T> b) -> T { return b[0] * (1.0 - exp(-b[1] * x[0])); }},
      {"Chwirut1", [](X x, B<T> b) -> T { return exp(-b[0] * x[0]) / (b[1] + b[2] * x[0]); }},
      {"Chwirut2", [](X x, B<T> b) -> T { return exp(-b[0] * x[0]) / (b[1] + b[2] * x[0]); }},
      {"DanWood", [](X x, B<T> b) -> T { return b[0] * exp(b[1] * std::log(x[0])); }},
      {"ENSO", enso<T>},
      {"Eckerle4", [](X x, B<T> b) -> T { return b[0] / b[1] * exp(-0.5 * (x[0] - b[2]) * (x[0] - b[2]) / (b[1] * b[1])); }},
      {"Gauss1", gauss<T>},
      {"Gauss2", gauss<T>},
      {"Gauss3", gauss<T>},
      {"Hahn1", cubic_ratio<T>},
      {"Kirby2", [](X x, B<T> b) -> T { return (b[0] + x[0] * (b[1] + x[0] * b[2])) / (1.0 + x[0] * (b[3] + x[0] * b[4])); }},
      {"Lanczos1", exponentials<T>},
      {"Lanczos2", exponentials<T>},
      {"Lanczos3", exponentials<T>},
      {"MGH09", [](X x, B<T> b) -> T { return b[0] * (x[0] * x[0] + x[0] * b[1]) / (x[0] * x[0] + x[0] * b[2] + b[3]); }},
      {"MGH10", [](X x, B<T> b) -> T { return b[0] * exp(b[1] / (x[0] + b[2])); }},
      {"MGH17", [](X x, B<T> b) -> T { return b[0] + b[1] * exp(-x[0] * b[3]) + b[2] * exp(-x[0] * b[4]); }},
      {"Misra1a", [](X x, B<T> b) -> T { return b[0] * (1.0 - exp(-b[1] * x[0])); }},
      {"Misra1b", [](X x, B<T> b) -> T { return b[0] * (1.0 - 1.0 / ((1.0 + b[1] * x[0] / 2.0) * (1.0 + b[1] * x[0] / 2.0))); }},
      {"Misra1c", [](X x, B<T> b) -> T { return b[0] * (1.0 - 1.0 / sqrt(1.0 + 2.0 * b[1] * x[0])); }},
      {"Misra1d", [](X x, B<T> b) -> T { return b[0] * b[1] * x[0] / (1.0 + b[1] * x[0]); }},
      {"Nelson", [](X x, B<T> b) -> T { return b[0] - b[1] * x[0] * exp(-b[2] * x[1]); }},
      {"Rat42", [](X x, B<T> b) -> T { return b[0] / (1.0 + exp(b[1] - b[2] * x[0])); }},
      {"Rat43", [](X x, B<T> b) -> T { return b[0] / pow(1.0 + exp(b[1] - b[2] * x[0]), 1.0 / b[3]); }},
      {"Roszman1", [](X x, B<T> b) -> T { return b[0] - b[1] * x[0] - arctan(T(b[2] / (x[0] - b[3]))) / pi; }},
      {"Thurber", cubic_ratio<T>}};
  return all;
}

}  // namespace

double nist_model(const std::string& name, std::span<const double> x, std::span<const double> b) { return models<double>().at(name)(x, b); }

std::complex<double> nist_model(const std::string& name, std::span<const double> x, std::span<const std::complex<double>> b) {
  return models<std::complex<double>>().at(name)(x, b);
}

}  // namespace jointid::stability
