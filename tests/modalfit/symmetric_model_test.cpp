#include "modalfit/model/symmetric_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/complex.hpp"
#include "frf/noise/noise.hpp"
#include "modalfit/model/mac.hpp"
#include "modalfit/model/rank_one.hpp"
#include "modalfit/model/synthesis.hpp"
#include "problems/case/modal_set.hpp"

namespace jointid::modalfit {
namespace {

constexpr ModelKind hysteretic_real{Damping::hysteretic, true};

TEST(RankOne, RecoversTheVectorFromSomeOfTheElements) {
  for (const bool real : {true, false}) {
    std::vector<Complex> phi = {{0.7, 0.2}, {-1.3, 0.1}, {0.4, -0.3}, {2.0, 0.05}};
    if (real) {
      for (Complex& value : phi) value = value.real();
    }
    std::vector<RankOneDatum> data;
    for (std::size_t row = 0; row < 4; ++row) {
      for (const std::size_t column : {1u, 2u}) data.push_back({row, column, phi[row] * phi[column], 1.0 + static_cast<double>(row)});
    }
    const RankOne found = fit_rank_one(data, 4, real);
    EXPECT_LT(found.misfit, 1e-25);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(std::abs(found.vector[i] - phi[i]), 1e-12);
  }
}

/// The covariance is that of many noisy elements.
TEST(RankOne, CovarianceIsTheScatterOfEstimates) {
  const std::vector<double> phi = {1.0, 0.5, -0.8};
  const std::size_t trials = 2000;
  std::vector<double> square(3);
  RankOne last;
  for (std::size_t t = 0; t < trials; ++t) {
    std::vector<RankOneDatum> data;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 2; ++column) {
        const double error = 0.02 * normal_numbers({4, t, 0}, row * 2 + column)[0];
        data.push_back({row, column, phi[row] * phi[column] + error, 1.0 / 4e-4});
      }
    }
    last = fit_rank_one(data, 3, true);
    for (std::size_t i = 0; i < 3; ++i) square[i] += std::pow(last.vector[i].real() - phi[i], 2.0);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(std::sqrt(square[i] / trials / last.covariance.variance(i)), 1.0, 0.08);
  }
}

struct Model {
  problems::ModalSet set;
  ModalFit found;
  Band band;
  SymmetricModel symmetric;
};

Model model(const std::string& name, std::uint64_t seed, ModelKind kind = hysteretic_real) {
  Model out{problems::make_modal_set(name), {}, {}, {}};
  const frf::FrfSet noisy = problems::polluted(out.set, seed, 0);
  out.band = make_band(noisy, {});
  out.found = fit(out.band, noisy.header, {.kind = kind});
  out.symmetric = make_symmetric(out.found, out.band);
  return out;
}

TEST(Symmetric, ShapesAreThoseOfTheStructureWithUnitModalMass) {
  const Model at = model("modes-30", 1);
  ASSERT_EQ(at.symmetric.modes.size(), 30u);
  for (std::size_t r = 0; r < 30; ++r) {
    std::vector<Complex> exact;
    double largest = 0.0;
    for (std::size_t i = 0; i < 12; ++i) {
      exact.push_back(at.set.modes.shapes[i * 30 + r]);
      largest = std::max(largest, std::abs(exact.back()));
    }
    EXPECT_GT(mac(at.symmetric.modes[r].shape, exact), 0.9999) << r;
    double length = 0.0, own = 0.0;
    for (std::size_t i = 0; i < 12; ++i) {
      length += std::norm(exact[i]);
      own += std::norm(at.symmetric.modes[r].shape[i]);
    }
    EXPECT_NEAR(std::sqrt(own / length), 1.0, 0.02) << r;
  }
}

/// FRFs between coordinates that were only responses.
TEST(Symmetric, RegeneratesFrfsThatWereNotMeasured) {
  const Model at = model("modes-30", 2);
  problems::ResponseRequest request;
  request.response = request.reference = at.set.modes.dofs;
  request.frequency_hz = at.band.frequency_hz;
  const frf::FrfSet exact = problems::modal_response(at.set.modes, request);
  const frf::FrfSet found = regenerate(at.symmetric, exact.header);
  double error = 0.0, size = 0.0, asymmetry = 0.0;
  for (std::size_t i = 0; i < exact.header.lines(); ++i) {
    for (std::size_t r = 3; r < 12; ++r) {
      for (std::size_t c = 3; c < 12; ++c) {
        error += std::norm(found.values[found.index(i, r, c)] - exact.values[exact.index(i, r, c)]);
        size += std::norm(exact.values[exact.index(i, r, c)]);
        const Complex there = found.values[found.index(i, r, c)], back = found.values[found.index(i, c, r)];
        asymmetry = std::max(asymmetry, std::abs(there - back) / std::abs(there));
      }
    }
  }
  EXPECT_LT(std::sqrt(error / size), 0.01);
  EXPECT_LT(asymmetry, 1e-9);
}

/// Over seeds, errors of measured FRFs agree with the variances that come with them, on average over lines.
TEST(Symmetric, VariancesAreThoseOfTheErrors) {
  double sum = 0.0, count = 0.0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Model at = model("modes-pair", seed);
    ASSERT_EQ(at.symmetric.modes.size(), 2u);
    const frf::FrfSet found = regenerate(at.symmetric, at.set.clean.header);
    for (std::size_t i = 0; i < found.values.size(); ++i) {
      const Complex error = found.values[i] - at.set.clean.values[i];
      sum += 0.5 * (std::pow(error.real(), 2.0) / found.variance[i].real() + std::pow(error.imag(), 2.0) / found.variance[i].imag());
      count += 1.0;
    }
  }
  EXPECT_GT(sum / count, 0.4);
  EXPECT_LT(sum / count, 2.0);
}

TEST(Symmetric, NeedsADrivingPoint) {
  ModalFit found;
  found.response = {frf::Dof::parse("1:+Z")};
  found.reference = {frf::Dof::parse("2:+Z")};
  EXPECT_NE(obstacle(found), "");
  found.reference = {frf::Dof::parse("1:-Z")};
  EXPECT_EQ(obstacle(found), "");
}

/// Rigid-body modes below and a mode far above the range.
struct ModesOutside {
  problems::ModalSet set = made();
  problems::ResponseRequest request{set.clean.header.response, set.clean.header.reference, set.clean.header.frequency_hz};
  frf::FrfSet exact = problems::modal_response(set.modes, request);

  static problems::ModalSet made() {
    problems::ModalSet set = problems::make_modal_set("modes-pair");
    set.modes.frequency_hz = {0.0, 100.0, 101.0, 900.0};
    set.modes.loss_factor = {0.0, 0.002, 0.002, 0.002};
    set.modes.shapes = {1.0, 1.0, 0.6, 3.0, 1.0, 0.8, -1.0, -2.0, 1.0, -0.5, 0.7, 4.0, 1.0, 0.3, 0.9, 5.0};
    return set;
  }
};

/// Noise hides what a pole beyond the range would change.
TEST(Symmetric, ResidualTermsStandForModesOutside) {
  ModesOutside of;
  const frf::FrfSet noisy = frf::polluted(of.exact, {.kind = frf::NoiseKind::circular, .level = 1e-3}, 1, 0, 0);
  Band band = make_band(noisy, {});
  const frf::FrfSet& exact = of.exact;
  problems::ResponseRequest& request = of.request;
  const problems::ModalSet& set = of.set;
  const ModalFit found = fit(band, exact.header, {.kind = hysteretic_real});
  ASSERT_EQ(found.modes.size(), 2u);
  EXPECT_NEAR(found.modes[0].pole.frequency_hz, 100.0, 1e-4);
  const frf::FrfSet of_fit = regenerate(found, exact.header, {90.0, 111.0});
  request.response = request.reference = set.modes.dofs;
  const frf::FrfSet all = problems::modal_response(set.modes, request);
  const frf::FrfSet of_model = regenerate(make_symmetric(found, band), all.header);
  const auto worst = [](const frf::FrfSet& one, const frf::FrfSet& other) {
    double error = 0.0;
    for (std::size_t i = 0; i < one.values.size(); ++i) error = std::max(error, std::abs(one.values[i] / other.values[i] - 1.0));
    return error;
  };
  EXPECT_LT(worst(of_fit, exact), 0.01);
  EXPECT_LT(worst(of_model, all), 0.01);
}

/// Without noise poles beyond the range follow them, and those inside are exact.
TEST(Symmetric, PolesBeyondTheRangeFollowExactFrfs) {
  const ModesOutside of;
  Band band = make_band(of.exact, {});
  const ModalFit found = fit(band, of.exact.header, {.kind = hysteretic_real});
  std::vector<double> inside;
  for (const Mode& mode : found.modes) {
    if (mode.inside) inside.push_back(mode.pole.frequency_hz);
  }
  ASSERT_EQ(inside.size(), 2u);
  EXPECT_NEAR(inside[0], 100.0, 1e-7);
  EXPECT_NEAR(inside[1], 101.0, 1e-7);
}

}  // namespace
}  // namespace jointid::modalfit
