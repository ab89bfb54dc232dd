#include "coupling/propagation.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "in_memory_parts.hpp"
#include "problems/case/coupling_problem.hpp"

namespace jointid::coupling {
namespace {

/// Mean and variances over draws of what comes out, against what was predicted: rms of the quotients.
struct Compared {
  double mean_quotient = 0.0, largest = 0.0, smallest = HUGE_VAL;
};

frf::FrfSet some_lines(const frf::FrfSet& set, const std::vector<std::size_t>& lines) {
  auto source = frf::from_memory(set);
  std::vector<std::size_t> all(set.header.response.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return frf::load(*source, {lines, all, all});
}

Compared monte_carlo(const problems::CouplingProblem& problem, const Assembly& assembly, const frf::NoiseModel& noise,
                     const Options& options) {
  const std::vector<std::size_t> lines = {20, 60, 90, 140};
  std::vector<frf::FrfSet> clean;
  for (const frf::FrfSet& part : problem.parts) clean.push_back(some_lines(part, lines));
  Options with = options, without = options;
  with.uncertainty = true;
  with.noise = noise;
  without.threads = with.threads = 1;
  // From data with errors, as a user has them: whether an FRF and its transpose share theirs, shows there only.
  std::vector<frf::FrfSet> measured;
  for (std::size_t i = 0; i < clean.size(); ++i) measured.push_back(frf::polluted(clean[i], noise, 3, 0, i));
  const frf::FrfSet predicted = couple_all(problems::parts_of(problem, measured), assembly, with);
  const frf::FrfSet centre = couple_all(problems::parts_of(problem, clean), assembly, without);
  std::vector<double> re(centre.values.size(), 0.0), im(re);
  constexpr std::size_t draws = 3000;
  for (std::size_t t = 0; t < draws; ++t) {
    std::vector<frf::FrfSet> sets;
    for (std::size_t i = 0; i < clean.size(); ++i) sets.push_back(frf::polluted(clean[i], noise, 7, t, i));
    const frf::FrfSet drawn = couple_all(problems::parts_of(problem, sets), assembly, without);
    for (std::size_t i = 0; i < re.size(); ++i) {
      const Complex d = drawn.values[i] - centre.values[i];
      re[i] += d.real() * d.real() / draws;
      im[i] += d.imag() * d.imag() / draws;
    }
  }
  Compared out;
  for (std::size_t i = 0; i < re.size(); ++i) {
    for (const double quotient : {re[i] / predicted.variance[i].real(), im[i] / predicted.variance[i].imag()}) {
      out.mean_quotient += quotient / static_cast<double>(2 * re.size());
      out.largest = std::max(out.largest, quotient);
      out.smallest = std::min(out.smallest, quotient);
    }
  }
  return out;
}

/// 3000 draws give a variance to ±2.6 % (1σ); the largest of 200 lies within ±12 %.
void expect_as_drawn(const Compared& found) {
  EXPECT_NEAR(found.mean_quotient, 1.0, 0.03);
  EXPECT_LT(found.largest, 1.15);
  EXPECT_GT(found.smallest, 0.86);
}

TEST(Propagation, IndependentErrorsAreAsDrawn) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  expect_as_drawn(monte_carlo(problem, problem.declared(), {.kind = frf::NoiseKind::circular, .level = 1e-4, .reciprocal = false}, {}));
}

TEST(Propagation, ErrorsThatAnFrfAndItsTransposeShareAreAsDrawn) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-B");
  expect_as_drawn(monte_carlo(problem, problem.declared(), {.kind = frf::NoiseKind::uniform, .level = 1e-4}, {.method = Method::pcc}));
}

TEST(Propagation, WithAJointAndErrorsByPartTheyAreAsDrawn) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  Assembly assembly = problem.declared();
  assembly.join.pop_back();
  assembly.joints.push_back({.dofs = {placed("4:+Y"), placed("7:+Y")}, .stiffness = {5e4, -5e4, -5e4, 5e4}, .mass = {},
                             .viscous_damping = {40.0, -40.0, -40.0, 40.0}, .hysteretic_damping = {}});
  expect_as_drawn(monte_carlo(problem, assembly, {.kind = frf::NoiseKind::gaussian, .level = 1e-4}, {.method = Method::mtc}));
}

/// Covariances of full rank for a set of one line, as large as errors of 1e-4.
void tell_covariances(frf::FrfSet& set, std::uint64_t seed) {
  const std::size_t rows = set.header.response.size(), columns = set.header.reference.size();
  set.header.noise = frf::NoiseRecord::variance;
  set.coherence.clear();
  set.variance.resize(set.values.size());
  set.covariance.resize(frf::pair_count(rows) * columns);
  for (std::size_t c = 0; c < columns; ++c) {
    const auto root = [&](std::size_t r, std::size_t k) {
      const auto z = normal_numbers({seed, c, r}, k);
      return 1e-4 * std::abs(set.values[r * columns + c]) * (Complex(z[0], z[1]) + 1.0);  // with a part in common
    };
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t s = 0; s <= r; ++s) {
        Complex sum = 0.0;
        for (std::size_t k = 0; k < rows + 2; ++k) sum += root(r, k) * std::conj(root(s, k));
        set.covariance[frf::pair_index(r, s) * columns + c] = sum;
        if (r == s) set.variance[r * columns + c] = 0.5 * Complex(sum.real(), sum.real());
      }
    }
  }
}

/// Of forces that acted at once: covariances of all references alike but for their size.
void tell_references(frf::FrfSet& set) {
  const std::size_t rows = set.header.response.size(), columns = set.header.reference.size();
  for (std::size_t c = 0; c < columns; ++c) {
    const double larger = 1.0 + 0.3 * static_cast<double>(c);
    for (std::size_t p = 0; p < frf::pair_count(rows); ++p)
      set.covariance[p * columns + c] = larger * set.covariance[p * columns];
    for (std::size_t r = 0; r < rows; ++r) set.variance[r * columns + c] = larger * set.variance[r * columns];
    for (std::size_t d = 0; d < columns; ++d) {
      const double apart = static_cast<double>(c) - static_cast<double>(d);
      set.reference_correlation.push_back(std::polar(std::exp(-std::abs(apart)), 0.7 * apart));
    }
  }
}

std::vector<frf::FrfSet> sets_with_covariances(const problems::CouplingProblem& problem, bool references) {
  std::vector<frf::FrfSet> sets;
  for (const frf::FrfSet& part : problem.parts) {
    const frf::NoiseModel noise{.kind = frf::NoiseKind::circular, .level = 1e-6, .reciprocal = false};
    sets.push_back(frf::polluted(some_lines(part, {60}), noise, 3, 0, sets.size()));
    sets.back().header.averages = 0.0;
    tell_covariances(sets.back(), sets.size());
    if (references) tell_references(sets.back());
  }
  return sets;
}

/// Against what differences by every FRF of the parts make of their covariances.
void expect_covariances_by_differences(const problems::CouplingProblem& problem, std::vector<frf::FrfSet> sets) {
  AssemblyReader reader(problems::parts_of(problem, sets), problem.declared(), {.uncertainty = true}, "test");
  ASSERT_TRUE(reader.has_covariance());
  const std::size_t rows = reader.header().response.size(), columns = reader.header().reference.size(), line = 0;
  std::vector<std::size_t> responses(rows), references(columns);
  for (std::size_t i = 0; i < rows; ++i) responses[i] = i;
  for (std::size_t i = 0; i < columns; ++i) references[i] = i;
  std::vector<Complex> values(rows * columns), variance(values), covariance(frf::pair_count(rows) * columns);
  reader.read({{&line, 1}, responses, references}, values, variance, {}, covariance);
  std::vector<Complex> expected(covariance.size(), 0.0);
  for (frf::FrfSet& set : sets) {
    const std::size_t own_rows = set.header.response.size(), own_columns = set.header.reference.size();
    std::vector<std::vector<std::vector<Complex>>> by_column;
    const auto stored = [&](std::size_t k, std::size_t m, std::size_t l) {
      const Complex value = set.covariance[frf::pair_index(std::max(k, m), std::min(k, m)) * own_columns + l];
      return k < m ? std::conj(value) : value;
    };
    const auto add = [&](std::size_t l, std::size_t n, std::size_t k, std::size_t m, Complex c) {
      for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t s = 0; s <= r; ++s) {
          for (std::size_t j = 0; j < columns; ++j) {
            expected[frf::pair_index(r, s) * columns + j] +=
                by_column[l][k][r * columns + j] * c * std::conj(by_column[n][m][s * columns + j]);
          }
        }
      }
    };
    for (std::size_t l = 0; l < own_columns; ++l) {
      std::vector<std::vector<Complex>> by;
      for (std::size_t k = 0; k < own_rows; ++k) {
        Complex& value = set.values[k * own_columns + l];
        const Complex kept = value, step = 1e-6 * kept;
        value += step;
        by.push_back(couple_all(problems::parts_of(problem, sets), problem.declared(), {}).values);
        value = kept;
        for (std::size_t i = 0; i < values.size(); ++i) by.back()[i] = (by.back()[i] - values[i]) / step;
      }
      by_column.push_back(std::move(by));
    }
    for (std::size_t l = 0; l < own_columns; ++l) {
      for (std::size_t n = 0; n < own_columns; ++n) {
        if (l != n && set.reference_correlation.empty()) continue;
        const double larger = l == n ? 1.0 : std::sqrt(stored(0, 0, n).real() / stored(0, 0, l).real());
        const Complex between = l == n ? 1.0 : set.reference_correlation[l * own_columns + n];
        for (std::size_t k = 0; k < own_rows; ++k) {
          for (std::size_t m = 0; m < own_rows; ++m) add(l, n, k, m, between * larger * stored(k, m, l));
        }
      }
    }
  }
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t j = 0; j < columns; ++j) {
      const auto own = [&](std::size_t i) { return expected[frf::pair_index(i, i) * columns + j].real(); };
      EXPECT_NEAR((variance[r * columns + j].real() + variance[r * columns + j].imag()) / own(r), 1.0, 1e-3);
      for (std::size_t s = 0; s <= r; ++s) {
        const std::size_t at = frf::pair_index(r, s) * columns + j;
        EXPECT_NEAR(std::abs(covariance[at] - expected[at]) / std::sqrt(own(r) * own(s)), 0.0, 1e-3) << r << " " << s << " " << j;
      }
    }
  }
}

TEST(Propagation, CovariancesAreThoseByDifferences) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  expect_covariances_by_differences(problem, sets_with_covariances(problem, false));
}

TEST(Propagation, CovariancesOfReferencesOfOneMeasurementAreThoseByDifferences) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  expect_covariances_by_differences(problem, sets_with_covariances(problem, true));
}

/// E[e_i e*_k] of two FRFs of a line.
Complex common(const frf::ErrorSums& sums, std::size_t i, std::size_t k) {
  Complex sum = 0.0;
  for (const frf::ErrorSums::Term& a : sums.terms[i]) {
    for (const frf::ErrorSums::Term& b : sums.terms[k]) sum += a.error == b.error ? a.factor * std::conj(b.factor) : 0.0;
  }
  return sum;
}

/// E[e²] of an FRF.
Complex relation(const frf::ErrorSums& sums, std::size_t i) {
  Complex sum = 0.0;
  for (const frf::ErrorSums::Term& term : sums.terms[i]) sum += term.factor * term.factor * term.relation;
  return sum;
}

/// Sums of errors make the variances of both parts, and with covariances in the files the covariances, that propagate() works out
/// on another way.
void expect_sums_of(const problems::CouplingProblem& problem, const std::vector<frf::FrfSet>& sets) {
  AssemblyReader reader(problems::parts_of(problem, sets), problem.declared(), {.uncertainty = true}, "test");
  const std::size_t rows = reader.header().response.size(), columns = reader.header().reference.size(), line = 0;
  std::vector<std::size_t> responses(rows), references(columns);
  for (std::size_t i = 0; i < rows; ++i) responses[i] = i;
  for (std::size_t i = 0; i < columns; ++i) references[i] = i;
  const frf::Block block{{&line, 1}, responses, references};
  std::vector<Complex> values(rows * columns), variance(values), covariance(frf::pair_count(rows) * columns);
  reader.read(block, values, variance, {}, reader.has_covariance() ? std::span(covariance) : std::span<Complex>());
  const frf::ErrorSums sums = std::move(reader.read_errors(block).front());
  ASSERT_EQ(sums.terms.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double total = variance[i].real() + variance[i].imag();
    EXPECT_NEAR(common(sums, i, i).real(), total, 1e-8 * total) << i;
    EXPECT_NEAR(relation(sums, i).real(), variance[i].real() - variance[i].imag(), 1e-8 * total) << i;
  }
  if (!reader.has_covariance()) return;
  for (std::size_t c = 0; c < columns; ++c) {
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t s = 0; s < r; ++s) {
        const Complex expected = covariance[frf::pair_index(r, s) * columns + c];
        const std::size_t i = r * columns + c, k = s * columns + c;
        const double size = std::sqrt(common(sums, i, i).real() * common(sums, k, k).real());
        EXPECT_LT(std::abs(common(sums, i, k) - expected), 1e-8 * size) << r << " " << s << " " << c;
      }
    }
  }
}

TEST(ErrorSums, AddUpToTheVariances) {
  for (const bool reciprocal : {false, true}) {
    const problems::CouplingProblem problem = problems::make_coupling("coupling-B");
    const frf::NoiseModel noise{.kind = frf::NoiseKind::circular, .level = 1e-2, .reciprocal = reciprocal};
    std::vector<frf::FrfSet> sets;
    for (const frf::FrfSet& part : problem.parts) {
      sets.push_back(frf::polluted(some_lines(part, {60}), noise, 3, 0, sets.size()));
      frf::FrfSet& set = sets.back();
      set.header.noise = frf::NoiseRecord::variance;
      set.coherence.clear();
      set.variance.clear();
      for (const Complex& value : set.values) set.variance.emplace_back(5e-5 * std::norm(value.real()), 5e-5 * std::norm(value.imag()));
    }
    expect_sums_of(problem, sets);
  }
}

TEST(ErrorSums, HaveTheCovariancesOfFiles) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  for (const bool references : {false, true}) expect_sums_of(problem, sets_with_covariances(problem, references));
}

/// Covariances of files told by a factor: all its columns, and none of its own.
TEST(Propagation, AFactorSaysWhatItsPairsSay) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  std::vector<frf::FrfSet> paired, factored;
  for (const frf::FrfSet& part : problem.parts) {
    frf::FrfSet set = some_lines(part, {60});
    set.header.noise = frf::NoiseRecord::variance;
    set.coherence.clear();
    set.factor.rank = 2;
    for (std::size_t i = 0; i < 2 * set.values.size(); ++i) {
      const auto z = normal_numbers({5, paired.size()}, i);
      set.factor.rows.push_back(1e-8 * Complex(z[0], z[1]));
    }
    set.factor.diagonal.assign(set.values.size(), 1e-18);
    frf::FrfSet pairs = set;
    pairs.covariance = frf::covariance_pairs(set);
    pairs.factor = {};
    const std::size_t columns = set.header.reference.size();
    for (std::size_t i = 0; i < set.values.size(); ++i) {
      const double own = pairs.covariance[frf::pair_index(i / columns, i / columns) * columns + i % columns].real();
      set.variance.push_back(0.5 * Complex(own, own));
    }
    pairs.variance = set.variance;
    paired.push_back(std::move(pairs));
    factored.push_back(std::move(set));
  }
  const auto coupled = [&](const std::vector<frf::FrfSet>& sets) {
    AssemblyReader reader(problems::parts_of(problem, sets), problem.declared(), {.uncertainty = true}, "test");
    EXPECT_TRUE(reader.has_covariance());
    const std::size_t rows = reader.header().response.size(), columns = reader.header().reference.size(), line = 0;
    std::vector<std::size_t> responses(rows), references(columns);
    for (std::size_t i = 0; i < rows; ++i) responses[i] = i;
    for (std::size_t i = 0; i < columns; ++i) references[i] = i;
    std::vector<Complex> values(rows * columns), variance(values), covariance(frf::pair_count(rows) * columns);
    reader.read({{&line, 1}, responses, references}, values, variance, {}, covariance);
    return covariance;
  };
  const std::vector<Complex> of_pairs = coupled(paired), of_factor = coupled(factored);
  for (std::size_t i = 0; i < of_pairs.size(); ++i) EXPECT_NEAR(std::abs(of_factor[i] / of_pairs[i] - 1.0), 0.0, 1e-10) << i;
}

TEST(Propagation, AnUnknownVarianceStaysWhereItBelongs) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  std::vector<frf::FrfSet> sets;
  for (const frf::FrfSet& part : problem.parts) {
    sets.push_back(some_lines(part, {30}));
    sets.back().header.noise = frf::NoiseRecord::variance;
    sets.back().variance.assign(sets.back().values.size(), Complex(1e-20, 1e-20));
  }
  sets[0].variance[0] = Complex(std::nan(""), std::nan(""));  // H_11, and 1 is not coupled
  const frf::FrfSet found = couple_all(problems::parts_of(problem, sets), problem.declared(), {.uncertainty = true});
  EXPECT_TRUE(std::isnan(found.variance[0].real()));
  for (std::size_t i = 1; i < found.variance.size(); ++i) EXPECT_GT(found.variance[i].real(), 0.0) << i;
}

}  // namespace
}  // namespace jointid::coupling
