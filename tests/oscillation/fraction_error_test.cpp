#include "oscillation/pod/fraction_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.hpp"

namespace jointid::oscillation {
namespace {

/// Independent normal samples of two channels: the share's error is known.
Samples white(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Samples out(at(count), 2);
  for (Eigen::Index i = 0; i < out.rows(); ++i) out(i, 0) = 2.0 * normal(random), out(i, 1) = normal(random);
  return out;
}

/// The share s = v₁/(v₁ + v₂) of independent channels has the standard deviation 2 s(1 − s)/√n.
TEST(FractionError, OfIndependentSamplesIsTheOneOfTheTextbook) {
  double squares = 0.0, errors = 0.0;
  constexpr int trials = 60;
  for (unsigned seed = 0; seed < trials; ++seed) {
    const Fractions found = square_fractions(white(2000, seed));
    squares += std::pow(found.value(0) - 0.8, 2) / trials;
    errors += found.error(0) * found.error(0) / trials;
    EXPECT_NEAR(found.value(1), 1.0, 1e-14);
    EXPECT_NEAR(found.error(1), 0.0, 1e-14);
  }
  const double exact = 2.0 * 0.8 * 0.2 / std::sqrt(2000.0);
  EXPECT_NEAR(std::sqrt(errors) / exact, 1.0, 0.15);
  EXPECT_NEAR(std::sqrt(squares) / exact, 1.0, 0.4);
}

TEST(FractionError, ValuesAreThoseOfTheWholeRecord) {
  const Samples record = white(1003, 5);  // no multiple of the blocks
  EXPECT_NEAR(square_fractions(record, 7).value(0), pod(record).square_fractions()(0), 1e-13);
  EXPECT_THROW(square_fractions(white(19, 1)), InputError);
  EXPECT_THROW(square_fractions(record, 1), InputError);
}

TEST(RecordTriangle, GoesThroughNumbersUnchanged) {
  const Samples record = white(300, 3);
  RecordTriangle one(2), two(2), joined(2);
  one.add(record.topRows(140));
  two.add(record.bottomRows(160));
  joined.join(RecordTriangle::of_numbers(2, one.numbers()));
  joined.join(RecordTriangle::of_numbers(2, two.numbers()));
  EXPECT_EQ(joined.samples(), 300u);
  const Pod whole = pod(record), parts = pod(joined);
  EXPECT_NEAR(parts.sigma(0), whole.sigma(0), 1e-12 * whole.sigma(0));
  EXPECT_NEAR((parts.mean - whole.mean).norm(), 0.0, 1e-13);
  EXPECT_THROW(RecordTriangle::of_numbers(3, one.numbers()), InputError);
}

}  // namespace
}  // namespace jointid::oscillation
