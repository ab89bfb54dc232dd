#include "ident/variance/frf_covariances.hpp"

#include <gtest/gtest.h>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "ident/likelihood/data/observations.hpp"
#include "study/recorded_noise.hpp"
#include "tests/ident/memory_systems.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

/// Complex normal numbers of variance 1.
class Normal {
 public:
  explicit Normal(unsigned seed) : random_(seed) {}
  Complex operator()() { return Complex(normal_(random_), normal_(random_)) / std::sqrt(2.0); }
  MatrixXcd matrix(Index rows, Index columns) {
    return MatrixXcd::NullaryExpr(rows, columns, [this] { return (*this)(); });
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

/// Hammer noise of 2 % with some that one sensor has alone, and constant noise that is correlated.
CovarianceLaw law_of_a_test() {
  MatrixXcd proportional = MatrixXcd::Constant(4, 4, 4e-4);
  proportional(2, 2) += 1e-4;
  MatrixXcd constant = MatrixXcd::Identity(4, 4) * 1e-5;
  constant(1, 3) = Complex(0.0, 4e-6);
  constant(3, 1) = std::conj(constant(1, 3));
  return {proportional, constant};
}

TEST(CovarianceLaw, IsFoundFromSingularCovariances) {
  Normal normal(3);
  const CovarianceLaw law = law_of_a_test();
  std::vector<CovarianceSample> samples;
  for (int line = 0; line < 600; ++line) {
    const VectorXcd frf = normal.matrix(4, 1) * std::exp(2.0 * normal().real());
    const MatrixXcd sigma = law(frf, 1.0);
    const std::vector<std::size_t> all = {0, 1, 2, 3};
    const minimise::Correlation correlation = minimise::Correlation::of(4, all, sigma, sigma.diagonal().real());
    MatrixXcd sum = MatrixXcd::Zero(4, 4);
    for (int blow = 0; blow < 3; ++blow) {  // rank 3 of 4
      VectorXcd error = normal.matrix(4, 1);
      correlation.colour({error.data(), 4});
      error = (error.array() * sigma.diagonal().array().sqrt()).matrix().eval();
      sum += error * error.adjoint() / 3.0;
    }
    samples.push_back({frf, sum});
  }
  const CovarianceLaw found = fit_covariance(samples);
  for (int i = 0; i < 20; ++i) {
    const VectorXcd frf = normal.matrix(4, 1), combination = normal.matrix(4, 1);
    const auto variance = [&](const CovarianceLaw& of) { return combination.dot(of(frf, 1.0) * combination).real(); };
    EXPECT_NEAR(variance(found) / variance(law), 1.0, 0.25);
    const VectorXcd contrast = (VectorXcd(4) << 1.0 / std::conj(frf[0]), -1.0 / std::conj(frf[1]), 0.0, 0.0).finished();  // no hammer
    EXPECT_NEAR(contrast.dot(found(frf, 1.0) * contrast).real() / contrast.dot(law(frf, 1.0) * contrast).real(), 1.0, 0.25);
  }
}

/// Errors whose real and imaginary parts differ in size, as uniform noise has them: whitened they are independent, coloured as told.
TEST(Correlation, OfErrorsThatAreNotCircularTellsPartsApart) {
  Normal normal(8);
  const MatrixXcd factor = normal.matrix(3, 5);
  const Eigen::VectorXd relations = (Eigen::VectorXd(5) << 0.9, -0.4, 0.0, 1.0, -0.9).finished();
  const MatrixXcd covariance = factor * factor.adjoint(), relation = factor * relations.cast<Complex>().asDiagonal() * factor.transpose();
  VectorXcd variance(3);
  for (Index i = 0; i < 3; ++i) {
    variance[i] = 0.5 * Complex((covariance(i, i) + relation(i, i)).real(), (covariance(i, i) - relation(i, i)).real());
  }
  const minimise::Correlation correlation = minimise::Correlation::of(4, {0, 1, 3}, covariance, relation, variance);
  EXPECT_FALSE(correlation.is_circular());
  EXPECT_TRUE(minimise::Correlation::of(4, {0, 1, 3}, covariance, {}, variance).is_circular());
  MatrixXcd found = MatrixXcd::Zero(3, 3), found_relation = found;
  for (int k = 0; k < 8; ++k) {
    std::vector<Complex> errors(4);
    errors[static_cast<std::size_t>(k / 2)] = k % 2 == 0 ? Complex(1.0) : Complex(0.0, 1.0);
    const std::vector<Complex> before = errors;
    correlation.colour(errors);
    if (k / 2 != 2) {
      VectorXcd e(3);
      for (Index i = 0; i < 3; ++i) {
        const Complex of = errors[static_cast<std::size_t>(i < 2 ? i : 3)];
        e[i] = {std::sqrt(variance[i].real()) * of.real(), std::sqrt(variance[i].imag()) * of.imag()};
      }
      found += e * e.adjoint();
      found_relation += e * e.transpose();
    } else {
      EXPECT_EQ(errors, before);
    }
    correlation.whiten(errors);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(std::abs(errors[i] - before[i]), 1e-9);
  }
  EXPECT_LT((found - covariance).norm(), 1e-9 * covariance.norm());
  EXPECT_LT((found_relation - relation).norm(), 1e-9 * covariance.norm());
}

/// FRFs with variances and covariances of full rank.
frf::FrfSet sample(const std::string& file, const Dofs& responses, const Dofs& references, unsigned seed) {
  std::mt19937_64 random(seed);
  Normal normal(seed);
  frf::FrfSet set = random_set(file, {10.0, 20.0}, responses, references, 1.0, random);
  set.header.noise = frf::NoiseRecord::variance;
  const std::size_t rows = responses.size(), columns = references.size(), pairs = frf::pair_count(rows);
  set.variance.resize(set.values.size());
  set.covariance.resize(2 * pairs * columns);
  for (std::size_t line = 0; line < 2; ++line) {
    for (std::size_t c = 0; c < columns; ++c) {
      const MatrixXcd root = 0.1 * normal.matrix(at(rows), at(2 * rows)), covariance = root * root.adjoint();
      for (std::size_t r = 0; r < rows; ++r) {
        const double part = 0.5 * covariance(at(r), at(r)).real();
        set.variance[set.index(line, r, c)] = {part, part};
        for (std::size_t s = 0; s <= r; ++s)
          set.covariance[(line * pairs + frf::pair_index(r, s)) * columns + c] = covariance(at(r), at(s));
      }
    }
  }
  return set;
}

/// With covariances a_c Σ and references that have something in common, as those of forces that act at once do.
frf::FrfSet sample_of_one_measurement(const std::string& file, const Dofs& responses, const Dofs& references, unsigned seed) {
  frf::FrfSet set = sample(file, responses, references, seed);
  Normal normal(seed + 100);
  const std::size_t rows = responses.size(), columns = references.size(), pairs = frf::pair_count(rows);
  for (std::size_t line = 0; line < 2; ++line) {
    const MatrixXcd root = normal.matrix(at(columns), at(columns + 1));
    const MatrixXcd forces = root * root.adjoint();
    for (std::size_t c = 0; c < columns; ++c) {
      const double larger = 1.0 + 0.7 * static_cast<double>(c);
      for (std::size_t p = 0; p < pairs; ++p) {
        set.covariance[(line * pairs + p) * columns + c] = larger * set.covariance[(line * pairs + p) * columns];
      }
      for (std::size_t r = 0; r < rows; ++r) set.variance[set.index(line, r, c)] = larger * set.variance[set.index(line, r, 0)];
      for (std::size_t d = 0; d < columns; ++d) {
        const Complex value = forces(at(c), at(d)) / std::sqrt(forces(at(c), at(c)).real() * forces(at(d), at(d)).real());
        set.reference_correlation.push_back(c == d ? 1.0 : value);
      }
    }
  }
  return set;
}

struct Sets {
  std::vector<frf::FrfSet> substructures, assembly;
};

/// What the likelihood observes of the first line.
LineData observed(const Sets& sets, const Dofs& coordinates, LineLayout* layout = nullptr) {
  const auto substructures = memory_system("substructures", sets.substructures, frf::Composition::uncoupled);
  const auto assembly = memory_system("assembly", sets.assembly, frf::Composition::merged);
  const Blocks all{.nn = true, .jn = true, .jj = true};
  Observations observations({}, coordinates, 3, {all, all}, *substructures, *assembly);
  Line line;
  line.frequency_hz = 10.0;
  observations.read({line}, [](std::size_t) {});
  if (layout) *layout = observations.layout();
  return observations.lines().front();
}

VectorXcd values_of(const LineData& data) {
  std::vector<Complex> all;
  for (const Channel* channel : {&data.sub_jn, &data.sub_jj, &data.asm_jn, &data.asm_jj, &data.drop_nn}) {
    all.insert(all.end(), channel->value.begin(), channel->value.end());
  }
  return Eigen::Map<VectorXcd>(all.data(), at(all.size()));
}

/// The covariance of what is observed by differences of it by each FRF of the files.
void add_by_differences(Sets sets, const Dofs& coordinates, std::vector<frf::FrfSet> Sets::*which, std::size_t k, MatrixXcd& sum) {
  frf::FrfSet& set = (sets.*which)[k];
  const VectorXcd before = values_of(observed(sets, coordinates));
  const std::size_t rows = set.header.response.size(), columns = set.header.reference.size();
  std::vector<MatrixXcd> by_column, scaled;  // what each FRF does; a covariance in parts of its first element's root
  for (std::size_t c = 0; c < columns; ++c) {
    MatrixXcd by(before.size(), at(rows)), covariance(at(rows), at(rows));
    for (std::size_t r = 0; r < rows; ++r) {
      Complex& value = set.values[set.index(0, r, c)];
      const Complex kept = value;
      value += 1e-3;
      by.col(at(r)) = (values_of(observed(sets, coordinates)) - before) / 1e-3;
      value = kept;
      for (std::size_t s = 0; s <= r; ++s) {
        covariance(at(r), at(s)) = set.covariance.empty() ? Complex(0.0) : set.covariance[frf::pair_index(r, s) * columns + c];
        if (set.covariance.empty() && r == s) covariance(at(r), at(r)) = 2.0 * set.variance[set.index(0, r, c)].real();
        covariance(at(s), at(r)) = std::conj(covariance(at(r), at(s)));
      }
    }
    sum += by * covariance * by.adjoint();
    by_column.push_back(by);
    scaled.push_back(covariance / std::sqrt(covariance(0, 0).real()));
  }
  for (std::size_t c = 0; c < columns && !set.reference_correlation.empty(); ++c) {
    for (std::size_t d = 0; d < columns; ++d) {
      if (c == d) continue;
      const MatrixXcd between = set.reference_correlation[c * columns + d] * (scaled[c] * scaled[d](0, 0).real());
      sum += by_column[c] * between * by_column[d].adjoint();
    }
  }
}

/// What the likelihood takes for the covariance of its observations is that by differences.
void expect_by_differences(const Sets& sets, const Dofs& coordinates) {
  const LineData data = observed(sets, coordinates);
  ASSERT_TRUE(data.correlation);
  const VectorXcd values = values_of(data);
  MatrixXcd expected = MatrixXcd::Zero(values.size(), values.size());
  for (std::size_t k = 0; k < sets.substructures.size(); ++k) add_by_differences(sets, coordinates, &Sets::substructures, k, expected);
  for (std::size_t k = 0; k < sets.assembly.size(); ++k) add_by_differences(sets, coordinates, &Sets::assembly, k, expected);
  std::vector<Complex> weights;
  for (const Channel* channel : {&data.sub_jn, &data.sub_jj, &data.asm_jn, &data.asm_jj, &data.drop_nn}) {
    weights.insert(weights.end(), channel->weight.begin(), channel->weight.end());
  }
  MatrixXcd found = MatrixXcd::Zero(values.size(), values.size());
  for (Index i = 0; i < values.size(); ++i) found(i, i) = 1.0;
  for (const auto& [elements, factor, parts] : data.correlation->groups()) {
    const MatrixXcd rho = factor * factor.adjoint();
    for (std::size_t i = 0; i < elements.size(); ++i) {
      for (std::size_t k = 0; k < elements.size(); ++k) found(at(elements[i]), at(elements[k])) = rho(at(i), at(k));
    }
  }
  for (Index i = 0; i < values.size(); ++i) {
    for (Index k = 0; k < values.size(); ++k) {
      const double scale = 2.0 / (weights[static_cast<std::size_t>(i)].real() * weights[static_cast<std::size_t>(k)].real());
      EXPECT_NEAR(std::abs(scale * found(i, k) - expected(i, k)), 0.0, 1e-9 * scale) << i << " " << k;
    }
  }
}

/// Two parts, FRFs there and back, signs, an assembly in two files of which one has no covariances.
TEST(FrfCovariances, AreThoseOfTheObservationsByDifferences) {
  const Dofs coordinates = dofs({"1:+X", "2:+X", "3:+X", "4:+X", "5:+X"});
  const Dofs part = dofs({"1:+X", "4:-X", "2:+X"}), other = dofs({"5:+X", "3:+X"});
  Sets sets{{sample("a", part, dofs({"2:+X", "1:-X", "4:+X"}), 1), sample("b", other, other, 2)},
            {sample("c", coordinates, dofs({"1:+X", "3:+X", "5:+X"}), 3),
             sample("d", dofs({"1:+X", "2:-X", "4:+X"}), dofs({"2:+X", "4:+X"}), 4)}};
  sets.assembly[1].covariance.clear();
  expect_by_differences(sets, coordinates);
}

/// The same with forces that acted at once in a part and on the assembly.
TEST(FrfCovariances, OfReferencesOfOneMeasurementAreThoseByDifferences) {
  const Dofs coordinates = dofs({"1:+X", "2:+X", "3:+X", "4:+X", "5:+X"});
  const Dofs part = dofs({"1:+X", "4:-X", "2:+X"}), other = dofs({"5:+X", "3:+X"});
  expect_by_differences({{sample_of_one_measurement("a", part, dofs({"2:+X", "1:-X", "4:+X"}), 1), sample("b", other, other, 2)},
                         {sample_of_one_measurement("c", coordinates, dofs({"1:+X", "3:-X", "5:+X"}), 3)}},
                        coordinates);
}

TEST(FrfCovariances, CostNothingWhereThereAreNone) {
  const Dofs coordinates = dofs({"1:+X", "2:+X", "3:+X", "4:+X", "5:+X"});
  Sets sets{{sample("a", coordinates, coordinates, 1)}, {sample("c", coordinates, coordinates, 3)}};
  sets.substructures[0].covariance.clear();
  sets.assembly[0].covariance.clear();
  EXPECT_FALSE(observed(sets, coordinates).correlation);
  // A noise model takes the place of what the files say.
  Scene scene;
  scene.noise = NoiseSection{.model = "circular", .level = 0.01, .frf_model = {.kind = frf::NoiseKind::circular, .level = 0.01}};
  scene.identify.variance = VarianceChoice::noise;
  const auto system = memory_system("a", {sample("a", coordinates, coordinates, 1)}, frf::Composition::merged);
  EXPECT_FALSE(FrfCovariances(*system, scene, coordinates, {{{0, 1}, {0, 1}}}).any());
  EXPECT_TRUE(FrfCovariances(*system, {}, coordinates, {{{0, 1}, {0, 1}}}).any());
}

TEST(RecordedNoise, ScattersByTheCovariancesOfTheSet) {
  const Dofs rows = dofs({"1:+X", "2:+X", "3:+X"});
  const frf::FrfSet clean = sample("a", rows, dofs({"1:+X", "2:+X"}), 6);
  const study::RecordedNoise noise(frf::whole(clean));
  constexpr int draws = 4000;
  MatrixXcd sum = MatrixXcd::Zero(3, 3), across = sum;
  for (std::uint64_t trial = 0; trial < draws; ++trial) {
    frf::FrfSet set = clean;
    noise.pollute(set, {9, trial, 0});
    VectorXcd error(3), other(3);
    for (std::size_t r = 0; r < 3; ++r) {
      error[at(r)] = set.values[set.index(1, r, 1)] - clean.values[clean.index(1, r, 1)];
      other[at(r)] = set.values[set.index(1, r, 0)] - clean.values[clean.index(1, r, 0)];
    }
    sum += error * error.adjoint() / draws;
    across += error * other.adjoint() / draws;
  }
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t s = 0; s <= r; ++s) {
      const auto of = [&](std::size_t i, std::size_t k) { return clean.covariance[(6 + frf::pair_index(i, k)) * 2 + 1]; };
      const double size = std::sqrt(of(r, r).real() * of(s, s).real());
      EXPECT_NEAR(std::abs(sum(at(r), at(s)) - of(r, s)) / size, 0.0, 5.0 / std::sqrt(draws));
      EXPECT_NEAR(std::abs(across(at(r), at(s))) / size, 0.0, 0.2);
    }
  }
}

TEST(RecordedNoise, ScattersByWhatReferencesHaveInCommon) {
  const frf::FrfSet clean = sample_of_one_measurement("a", dofs({"1:+X", "2:+X", "3:+X"}), dofs({"1:+X", "2:+X"}), 6);
  const study::RecordedNoise noise(frf::whole(clean));
  constexpr int draws = 4000;
  MatrixXcd across = MatrixXcd::Zero(3, 3);
  for (std::uint64_t trial = 0; trial < draws; ++trial) {
    frf::FrfSet set = clean;
    noise.pollute(set, {9, trial, 0});
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t s = 0; s < 3; ++s) {
        across(at(r), at(s)) += (set.values[set.index(1, r, 1)] - clean.values[clean.index(1, r, 1)]) *
                                std::conj(set.values[set.index(1, s, 0)] - clean.values[clean.index(1, s, 0)]) / double{draws};
      }
    }
  }
  const Complex correlation = clean.reference_correlation[4 + 2];  // of line 1, second with first
  ASSERT_GT(std::abs(correlation), 0.2);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t s = 0; s < 3; ++s) {
      const auto of = [&](std::size_t i, std::size_t k, std::size_t c) {
        const Complex value = clean.covariance[(6 + frf::pair_index(std::max(i, k), std::min(i, k))) * 2 + c];
        return i < k ? std::conj(value) : value;
      };
      const double size = std::sqrt(of(r, r, 1).real() * of(s, s, 0).real());
      const Complex expected = correlation * std::sqrt(1.7) * of(r, s, 0);  // a of both: 1.7 and 1
      EXPECT_LT(std::abs(across(at(r), at(s)) - expected), 5.0 / std::sqrt(draws) * size) << r << " " << s;
    }
  }
}

}  // namespace
}  // namespace jointid::ident
