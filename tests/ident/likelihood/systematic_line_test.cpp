// Corrected lines and the derivatives of their χ² by systematic errors, against differences.
#include <gtest/gtest.h>

#include "ident/likelihood/model/corrected_line.hpp"
#include "ident/likelihood/model/fitted_line.hpp"
#include "likelihood_line_sample.hpp"

namespace jointid::ident {
namespace {

const std::vector<SystematicUnknown> unknowns = {
    {Systematic::gain, 0.3}, {Systematic::gain, 0.2}, {Systematic::delay, 0.05}, {Systematic::mass, 0.1}};

/// Real and imaginary parts with the same errors, as the derivatives take them.
void make_circular(LineData& data) {
  for (Channel* channel : {&data.sub_jn, &data.sub_jj, &data.asm_jn, &data.asm_jj, &data.drop_nn}) {
    for (Complex& weight : channel->weight) weight = {weight.real(), weight.real() > 0.0 ? weight.real() : 0.0};
  }
}

/// Errors of some elements of every block; of D of both systems, and of FRFs measured there and back, where `with_several`.
void add_errors(LineSample& sample, bool with_several) {
  auto frfs = std::make_shared<SystematicFrfs>();
  const auto way = [&](double share, std::vector<std::size_t> which) {
    SystematicWay out{share, {}};
    for (const std::size_t u : which) out.factors.push_back({u, unknowns[u].kind == Systematic::mass ? sample.any() : Complex()});
    return out;
  };
  std::size_t element = 0;
  for (const Channel* channel : {&sample.data.sub_jn, &sample.data.sub_jj, &sample.data.asm_jn, &sample.data.asm_jj}) {
    for (std::size_t i = 0; i < channel->value.size(); ++i, ++element) {
      if (element % 3 == 0) continue;
      const bool both = with_several && element % 3 == 1;
      std::vector<SystematicWay> ways = {way(both ? 0.5 : 1.0, {0, 2})};
      if (both) ways.push_back(way(0.5, {1, 3}));
      frfs->push_back({element, 1.0, channel->value[i], 1.0, ways});
    }
  }
  for (std::size_t i = 0; with_several && i < sample.data.drop_nn.value.size(); ++i, ++element) {
    const Complex whole = sample.any();
    frfs->push_back({element, 1.0, sample.data.drop_nn.value[i] + whole, 0.3, {way(1.0, {0})}});
    frfs->push_back({element, -1.0, whole, 0.7, {way(1.0, {1, 2})}});
  }
  sample.data.systematic = frfs;
}

/// χ² of the line at the FRFs that are best for these errors.
double least_cost(const LineSample& sample, const std::vector<double>& phi, FittedLine line) {
  LineModel model(sample.layout);
  relax(corrected_line(sample.data, unknowns, phi), sample.joint.at(sample.theta), model, line);
  return line.cost;
}

void expect_gradient(LineSample& sample, const std::vector<double>& phi) {
  FittedLine line{sample.joint, {}, sample.exact, 0.0, 0.0, 1.0, {}};
  const ComplexMatrix z = sample.joint.at(sample.theta);
  const LineData data = corrected_line(sample.data, unknowns, phi);
  for (const auto numbers : {LineModel::Numbers::real, LineModel::Numbers::complex}) {
    LineModel model(sample.layout, numbers);
    for (int i = 0; i < 3; ++i) relax(data, z, model, line);
    model.linearise(data, sample.joint, z, line.state, true);
    const auto reduced = model.reduce(0.0);
    ASSERT_TRUE(reduced);
    const auto p = static_cast<Eigen::Index>(sample.joint.columns().size());
    ASSERT_EQ(reduced->gradient.size(), p + 4);
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
      constexpr double h = 1e-4;
      std::vector<double> up = phi, down = phi;
      up[u] += h;
      down[u] -= h;
      const double difference = (least_cost(sample, up, line) - least_cost(sample, down, line)) / (2.0 * h);
      EXPECT_NEAR(-2.0 * reduced->gradient[p + static_cast<Eigen::Index>(u)], difference,
                  1e-4 * (1.0 + std::abs(difference) + line.cost));
    }
  }
}

TEST(SystematicLine, GradientByDifferences) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937_64 random(seed);
    LineSample sample({.noise = 0.05, .correlated = false}, random);
    make_circular(sample.data);
    add_errors(sample, true);
    expect_gradient(sample, {0.0, 0.0, 0.0, 0.0});
  }
}

TEST(SystematicLine, GradientFarFromZero) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937_64 random(seed);
    LineSample sample({.uncoupled = true, .noise = 0.05}, random);
    make_circular(sample.data);
    add_errors(sample, false);
    expect_gradient(sample, {0.7, 0.0, -0.4, 0.0});
  }
}

TEST(SystematicLine, NothingChangesAtZero) {
  std::mt19937_64 random(3);
  LineSample sample({.missing = 0.2}, random);
  add_errors(sample, true);
  const LineData data = corrected_line(sample.data, unknowns, {});
  EXPECT_EQ(data.sub_jn.value, sample.data.sub_jn.value);
  EXPECT_EQ(data.drop_nn.value, sample.data.drop_nn.value);
  EXPECT_EQ(data.asm_jn.weight, sample.data.asm_jn.weight);
}

TEST(SystematicLine, TermsAloneAreThoseOfALineThatNothingCorrects) {
  std::mt19937_64 random(4);
  LineSample sample({.missing = 0.2}, random);
  add_errors(sample, true);
  for (SystematicFrf& each : *std::const_pointer_cast<SystematicFrfs>(sample.data.systematic)) {
    each.ways.front().factors.push_back({4, sample.any()});
    each.ways.front().factors.push_back({5, sample.any()});
  }
  std::vector<SystematicUnknown> all = unknowns;
  all.push_back({Systematic::angle, 0.2});
  all.push_back({Systematic::stretch, 0.4});
  const SystematicTerms expected = *corrected_line(sample.data, all, {}).terms;
  SystematicTerms found;
  found.first = {7};  // of another line
  found.terms.resize(3);
  write_terms(sample.data, all, found);
  EXPECT_EQ(found.unknowns, 6U);
  EXPECT_EQ(found.first, expected.first);
  ASSERT_EQ(found.terms.size(), expected.terms.size());
  for (std::size_t t = 0; t < found.terms.size(); ++t) {
    const Complex residual = sample.any();
    EXPECT_EQ(found.terms[t].unknown, expected.terms[t].unknown);
    const Complex change = expected.terms[t].derivative(residual);
    EXPECT_NEAR(std::abs(found.terms[t].derivative(residual) - change), 0.0, 1e-14 * std::abs(change)) << t;
  }
}

TEST(SystematicLine, MassIsRemovedExactly) {
  std::mt19937_64 random(5);
  LineSample sample({}, random);
  const Complex free = sample.data.asm_jn.value[0], driving_free = sample.any();
  const double omega = sample.data.omega, mass = 0.25;
  const auto loaded = [&](Complex h) { return h / (1.0 - omega * omega * mass * driving_free); };
  const std::size_t element = sample.layout.variables();
  sample.data.asm_jn.value[0] = loaded(free);
  sample.data.systematic =
      std::make_shared<SystematicFrfs>(SystematicFrfs{{element, 1.0, loaded(free), 1.0, {{1.0, {{0, loaded(driving_free)}}}}}});
  const std::vector<SystematicUnknown> one = {{Systematic::mass, 0.5}};
  const std::vector<double> phi = {mass / 0.5};
  EXPECT_NEAR(std::abs(corrected_line(sample.data, one, phi).asm_jn.value[0] - free), 0.0, 1e-12 * std::abs(loaded(free)));
}

TEST(SystematicLine, AnAngleTakesOffTheOtherAxisAndLeavesTheError) {
  std::mt19937_64 random(6);
  LineSample sample({}, random);
  const std::size_t element = sample.layout.variables();
  const Complex measured = sample.data.asm_jn.value[0], other = sample.any();
  sample.data.systematic =
      std::make_shared<SystematicFrfs>(SystematicFrfs{{element, 1.0, measured, 1.0, {{1.0, {{0, other / measured}}}}}});
  const std::vector<SystematicUnknown> one = {{Systematic::angle, 0.1}};
  const std::vector<double> phi = {0.7};
  const LineData corrected = corrected_line(sample.data, one, phi);
  EXPECT_NEAR(std::abs(corrected.asm_jn.value[0] - (measured - 0.07 * other)), 0.0, 1e-12);
  EXPECT_NEAR(std::abs(corrected.asm_jn.weight[0] - sample.data.asm_jn.weight[0]), 0.0,
              1e-12 * std::abs(sample.data.asm_jn.weight[0]));
  ASSERT_EQ(corrected.terms->terms.size(), 1U);
  EXPECT_NEAR(std::abs(corrected.terms->terms[0].derivative(sample.any()) + 0.1 * other), 0.0, 1e-12);
}

/// Two FRFs of a row and its driving point: the covariance of the corrected ones against what differences by the measured ones make of
/// their independent errors.
TEST(SystematicLine, TheNoiseOfADrivingPointIsSharedByItsRow) {
  std::mt19937_64 random(7);
  LineSample sample({}, random);
  make_circular(sample.data);
  ASSERT_GE(sample.data.asm_jn.value.size(), 2U);
  const std::vector<SystematicUnknown> one = {{Systematic::mass, 0.5}};
  const std::vector<double> phi = {0.8};
  const std::size_t first = sample.layout.variables();
  const double omega = sample.data.omega, driving_deviation = 0.3;
  const Complex driving = sample.any() / (omega * omega);
  std::vector<Complex> measured = {sample.data.asm_jn.value[0], sample.data.asm_jn.value[1], driving};
  const auto data = [&] {
    LineData out = sample.data;
    const SystematicFactor mass{0, measured[2], 4, driving_deviation * driving_deviation};
    SystematicFrfs frfs;
    for (std::size_t i = 0; i < 2; ++i) {
      out.asm_jn.value[i] = measured[i];
      frfs.push_back({first + i, 1.0, measured[i], 1.0, {{1.0, {mass}}}});
    }
    out.systematic = std::make_shared<SystematicFrfs>(frfs);
    return corrected_line(out, one, phi);
  };
  const LineData corrected = data();
  const double own[] = {1.0 / sample.data.asm_jn.weight[0].real(), 1.0 / sample.data.asm_jn.weight[1].real()};
  const double variance[] = {2.0 * own[0] * own[0], 2.0 * own[1] * own[1], driving_deviation * driving_deviation};
  Eigen::Matrix2cd expected = Eigen::Matrix2cd::Zero();
  for (std::size_t m = 0; m < 3; ++m) {
    const Complex kept = measured[m], step = 1e-6 * kept;
    measured[m] = kept + step;
    const LineData moved = data();
    measured[m] = kept;
    Eigen::Vector2cd by;
    for (std::size_t i = 0; i < 2; ++i)
      by[static_cast<Eigen::Index>(i)] = (moved.asm_jn.value[i] - corrected.asm_jn.value[i]) / step;
    expected += variance[m] * by * by.adjoint();
  }
  ASSERT_TRUE(corrected.correlation);
  ASSERT_EQ(corrected.correlation->groups().size(), 1U);
  const minimise::Correlation::Group& group = corrected.correlation->groups().front();
  EXPECT_EQ(group.elements, (std::vector<std::size_t>{first, first + 1}));
  for (Eigen::Index i = 0; i < 2; ++i) {
    const double weight = corrected.asm_jn.weight[static_cast<std::size_t>(i)].real();
    EXPECT_NEAR(2.0 / (weight * weight) / expected(i, i).real(), 1.0, 1e-5);
  }
  const Complex rho = (group.factor.row(0) * group.factor.row(1).adjoint()).value();
  EXPECT_NEAR(std::abs(rho - expected(0, 1) / std::sqrt(expected(0, 0).real() * expected(1, 1).real())), 0.0, 1e-5);
}

}  // namespace
}  // namespace jointid::ident
