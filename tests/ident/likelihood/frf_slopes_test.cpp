#include "ident/likelihood/data/frf_slopes.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "problems/case/catalogue.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t coordinates = 3;
const Complex first_pole(101.3, 0.8), second_pole(104.1, 1.1);

/// Residue of an FRF at a pole: other ones for each.
Complex residue(std::size_t row, std::size_t column, double of) {
  const auto place = static_cast<double>(row * (row + 1) / 2 + column);
  return {std::cos(of * place + 1.0), std::sin(2.0 * of * place)};
}

/// Two resonances and the rest of the others.
Complex frf(double f, std::size_t row, std::size_t column) {
  return residue(row, column, 1.0) / (f - first_pole) + residue(row, column, 2.3) / (f - second_pole) + residue(row, column, 0.4);
}

Complex derivative(double f, std::size_t row, std::size_t column) {
  const Complex one = f - first_pole, two = f - second_pole;
  return -residue(row, column, 1.0) / (one * one) - residue(row, column, 2.3) / (two * two);
}

MeasuredFrfs line_at(double f, double deviation) {
  MeasuredFrfs out(coordinates);
  for (std::size_t r = 0; r < coordinates; ++r) {
    for (std::size_t c = 0; c <= r; ++c) out.at(r, c) = {frf(f, r, c), Complex(1.0, 1.0) * deviation * deviation};
  }
  return out;
}

/// Of every FRF at the line `own`, over the derivative.
double largest_error(const std::vector<double>& frequency, std::size_t own, double deviation) {
  std::vector<MeasuredFrfs> lines;
  for (const double f : frequency) lines.push_back(line_at(f, deviation));
  std::vector<const MeasuredFrfs*> all;
  for (const MeasuredFrfs& line : lines) all.push_back(&line);
  const FrfSlopes slopes({0, 1, 2}, frequency, all, own);
  double largest = 0.0;
  for (std::size_t r = 0; r < coordinates; ++r) {
    for (std::size_t c = 0; c <= r; ++c) {
      const Complex expected = derivative(frequency[own], r, c);
      largest = std::max(largest, std::abs(slopes.of({r, c}) - expected) / std::abs(expected));
      EXPECT_EQ(slopes.of({c, r}), slopes.of({r, c}));
    }
  }
  return largest;
}

TEST(FrfSlopes, AreExactOfTwoResonancesFromFiveLinesWiderApartThanTheseAre) {
  const std::vector<double> frequency = {97.0, 99.5, 102.0, 105.0, 107.5};
  for (const std::size_t own : {std::size_t{0}, std::size_t{2}, std::size_t{4}})
    EXPECT_LT(largest_error(frequency, own, 1e-9), 1e-6) << own;
}

TEST(FrfSlopes, OfThreeLinesTakeOneResonance) {
  const std::vector<double> near = {101.2, 101.3, 101.4};
  EXPECT_LT(largest_error(near, 1, 1e-9), 0.02);
  EXPECT_GT(largest_error(near, 1, 1e-9), 1e-9);  // of the other one
}

TEST(FrfSlopes, AreNotKnownWhereALineIsNot) {
  std::vector<MeasuredFrfs> lines;
  const std::vector<double> frequency = {100.0, 101.0, 102.0};
  for (const double f : frequency) lines.push_back(line_at(f, 1e-3));
  lines[2].at(1, 0).value = {NAN, NAN};
  const FrfSlopes slopes({0, 1, 2}, frequency, {&lines[0], &lines[1], &lines[2]}, 1);
  EXPECT_TRUE(std::isnan(slopes.of({1, 0}).real()));
  EXPECT_TRUE(std::isfinite(slopes.of({2, 0}).real()));
}

/// A part of case A1 on its 31 lines, 20 Hz apart and its resonances half a Hz wide: exact FRFs and their derivatives by the frequency.
struct Part {
  std::vector<double> frequency;
  std::vector<Eigen::MatrixXcd> frf, derivative;
};

Part part_of_a1(std::size_t number) {
  const std::vector<problems::Case> all = problems::all_cases();
  const problems::Case& a1 = *std::ranges::find(all, "A1", &problems::Case::name);
  const problems::Structure& structure = a1.substructures[number];
  const auto size = static_cast<Eigen::Index>(structure.size());
  const auto matrix = [&](problems::Kind kind) -> Eigen::MatrixXd {
    return Eigen::Map<const Eigen::MatrixXd>(structure.matrix(kind).data(), size, size);
  };
  const Eigen::MatrixXd mass = matrix(problems::Kind::mass);
  Eigen::MatrixXcd stiffness = matrix(problems::Kind::stiffness).cast<Complex>();
  stiffness += Complex(0.0, 1.0) * matrix(problems::Kind::hysteretic_damping);
  Part out{.frequency = problems::frequencies(a1.axis), .frf = {}, .derivative = {}};
  for (const double f : out.frequency) {
    const double omega = 2.0 * std::numbers::pi * f;
    out.frf.push_back((stiffness - omega * omega * mass).inverse());
    out.derivative.push_back(4.0 * std::numbers::pi * omega * out.frf.back() * mass * out.frf.back());
  }
  return out;
}

/// Lines of a part with errors of `level` of each of the two parts of an FRF, those of `seed`.
std::vector<MeasuredFrfs> measured(const Part& part, double level, std::uint64_t seed) {
  std::vector<MeasuredFrfs> out;
  for (std::size_t l = 0; l < part.frf.size(); ++l) {
    const auto size = static_cast<std::size_t>(part.frf[l].rows());
    out.emplace_back(size);
    for (std::size_t r = 0; r < size; ++r) {
      for (std::size_t s = 0; s <= r; ++s) {
        const auto z = normal_numbers({seed, l, 0}, r * size + s);
        const Complex exact = part.frf[l](static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(s));
        const Complex value(exact.real() * (1.0 + (seed > 0 ? level * z[0] : 0.0)), exact.imag() * (1.0 + (seed > 0 ? level * z[1] : 0.0)));
        out.back().at(r, s) = {value, Complex(std::pow(level * value.real(), 2), std::pow(level * value.imag(), 2))};
      }
    }
  }
  return out;
}

/// Of the slopes of all lines, over the slopes, both in parts of the real and the imaginary parts of the FRFs as errors are; of FRFs whose
/// value on the line itself is exact, as a fit makes it nearly.
double relative_error(const Part& part, std::uint64_t seed) {
  const std::vector<MeasuredFrfs> lines = measured(part, 0.006, seed);
  std::vector<std::size_t> all;
  for (Eigen::Index r = 0; r < part.frf.front().rows(); ++r) all.push_back(static_cast<std::size_t>(r));
  double squares = 0.0, whole = 0.0;
  for (std::size_t own = 0; own < lines.size(); ++own) {
    const std::size_t count = FrfSlopes::most_lines, first = std::min(own - std::min(own, count / 2), lines.size() - count);
    std::vector<const MeasuredFrfs*> around;
    for (std::size_t k = first; k < first + count; ++k) around.push_back(&lines[k]);
    const auto begin = part.frequency.begin() + static_cast<std::ptrdiff_t>(first);
    const FrfSlopes slopes(all, {begin, begin + static_cast<std::ptrdiff_t>(count)}, around, own - first);
    for (const std::size_t r : all) {
      for (std::size_t s = 0; s <= r; ++s) {
        const auto row = static_cast<Eigen::Index>(r), column = static_cast<Eigen::Index>(s);
        const Complex exact = part.frf[own](row, column), expected = part.derivative[own](row, column);
        const Complex found = slopes.of({r, s}) - slopes.of_own_value() * (lines[own].at(r, s).value - exact);
        if (std::isnan(found.real())) continue;  // zero by symmetry
        squares += std::pow((found - expected).real() / exact.real(), 2) + std::pow((found - expected).imag() / exact.imag(), 2);
        whole += std::pow(expected.real() / exact.real(), 2) + std::pow(expected.imag() / exact.imag(), 2);
      }
    }
  }
  return std::sqrt(squares / whole);
}

/// Where a resonance is near a line the FRFs' imaginary parts are a tenth of the real ones there and a thousandth elsewhere. Their slopes
/// were 40 % off with errors of 0.6 % of each part, as the sizes of both parts together were the weights, and a stretch was found too
/// small.
TEST(FrfSlopes, OfAPartWithLittleDampingHoldInRealAndImaginaryPartsAlike) {
  for (const std::size_t number : {std::size_t{0}, std::size_t{1}}) {
    const Part part = part_of_a1(number);
    EXPECT_LT(relative_error(part, 0), 2e-3) << number;  // of exact FRFs
    for (std::uint64_t seed = 1; seed <= 5; ++seed) EXPECT_LT(relative_error(part, seed), 0.1) << number << " " << seed;
  }
}

}  // namespace
}  // namespace jointid::ident
