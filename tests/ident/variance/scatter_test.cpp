#include "ident/variance/scatter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "base/error.hpp"
#include "frf/noise/noise.hpp"
#include "frf/noise/variance_law.hpp"
#include "tests/ident/memory_systems.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

/// estimated/true σ of every FRF at every line: quantiles.
struct Ratios {
  double low = 0.0, median = 0.0, high = 0.0;
  double unresolved = 0.0, frfs = 0.0;
};

std::vector<std::size_t> numbers(std::size_t count) {
  std::vector<std::size_t> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = i;
  return all;
}

Ratios ratios(const frf::FrfSet& clean, const frf::FrfSet& noisy, const frf::NoiseModel& model) {
  const auto source = frf::from_memory(noisy);
  const auto piece = frf::find_piece(noisy.header, 0, noisy.header.response, noisy.header.reference, false);
  const auto lines = numbers(noisy.header.lines());
  const Scatter found = estimate_scatter(*source, piece, lines);
  std::vector<double> all;
  std::vector<double> squares(piece.size(), 0.0);
  for (std::size_t i = 0; i < clean.values.size(); ++i) {
    squares[i % piece.size()] +=
        std::norm(clean.values[i]) /
        frf::squared_factor(clean.header.quantity, clean.header.frequency_hz[i / piece.size()]) /
        static_cast<double>(lines.size());
  }
  for (const std::size_t line : lines) {
    const double factor = frf::squared_factor(clean.header.quantity, clean.header.frequency_hz[line]);
    for (std::size_t entry = 0; entry < piece.size(); ++entry) {
      const Complex exact = clean.values[line * piece.size() + entry];
      const Complex law = frf::variance_law(model, squares[entry])(exact, factor), estimate = found.laws[entry](exact, factor);
      if (!(std::abs(exact) > 1e-15)) continue;  // zero by symmetry
      all.push_back(std::sqrt((estimate.real() + estimate.imag()) / (law.real() + law.imag())));
    }
  }
  std::sort(all.begin(), all.end());
  const auto quantile = [&](double q) { return all[static_cast<std::size_t>(q * static_cast<double>(all.size() - 1))]; };
  return {quantile(0.05), quantile(0.5), quantile(0.95), static_cast<double>(found.unresolved), static_cast<double>(piece.size())};
}

std::string text(const Ratios& r) {
  std::ostringstream out;
  out << r.low << " " << r.median << " " << r.high << ", unresolved " << r.unresolved << " of " << r.frfs;
  return out.str();
}

/// Every step-th line of a set.
frf::FrfSet thinned(const frf::FrfSet& set, std::size_t step) {
  std::vector<std::size_t> lines;
  for (std::size_t line = 0; line < set.header.lines(); line += step) lines.push_back(line);
  frf::FrfSet thin = lines_of(set, lines);
  thin.header.noise = frf::NoiseRecord::none;
  return thin;
}

struct Way {
  std::string name, problem;
  std::size_t step;
  frf::NoiseModel model;
  /// Bounds of estimated/true σ: 5 % quantile from, median from and to, 95 % quantile to.
  double low, median_low, median_high, high;
  double least_unresolved, most_unresolved;  ///< share of the FRFs
};

void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

class ScatterOf : public ::testing::TestWithParam<Way> {};

TEST_P(ScatterOf, KnownNoiseIsFoundOrTheEstimateIsAnUpperBound) {
  const Way& way = GetParam();
  const problems::Problem problem = problems::make(way.problem);
  for (const auto* set : {&problem.substructures[0], &problem.assembly}) {
    const frf::FrfSet clean = thinned(*set, way.step);
    const Ratios found = ratios(clean, frf::polluted(clean, way.model, 1, 1), way.model);
    RecordProperty(set == &problem.assembly ? "assembly" : "substructure", text(found));
    EXPECT_GE(found.low, way.low) << text(found);
    EXPECT_GE(found.median, way.median_low) << text(found);
    EXPECT_LE(found.median, way.median_high) << text(found);
    EXPECT_LE(found.high, way.high) << text(found);
    EXPECT_GE(found.unresolved, way.least_unresolved * found.frfs) << text(found);
    EXPECT_LE(found.unresolved, way.most_unresolved * found.frfs) << text(found);
  }
}

frf::NoiseModel circular(double level) { return {.kind = frf::NoiseKind::circular, .level = level}; }

frf::NoiseModel changed(frf::NoiseModel model, const std::function<void(frf::NoiseModel&)>& change) {
  change(model);
  return model;
}

/// 401 lines follow the structure, 31 just do, a tenth of them do not: there the estimate must be above the noise and say so.
const Way ways[] = {
    {"FineLines", "rig1", 1, circular(0.05), 0.65, 0.85, 1.2, 1.4, 0.0, 0.2},
    {"FineLinesOfLittleNoise", "rig1", 1, circular(0.001), 0.65, 0.85, 1.2, 1.5, 0.0, 0.2},
    {"GrossLines", "rig1", 1, changed(circular(0.01), [](auto& model) { model.gross.share = 0.02; }), 0.65, 0.85, 1.2, 1.5, 0.0,
     0.2},
    {"Floor", "rig1", 1, changed(circular(0.0), [](auto& model) { model.floor = 0.001; }), 0.8, 0.9, 1.4, 1.7, 0.0, 0.2},
    {"FewLines", "A1", 1, circular(0.05), 0.35, 0.8, 1.3, 3.0, 0.0, 0.3},
    {"FewLinesOfLittleNoise", "A1", 1, circular(0.001), 0.35, 0.8, 1.3, 4.0, 0.0, 0.3},
    {"FewLinesNotReciprocal", "A1", 1, changed(circular(0.01), [](auto& model) { model.reciprocal = false; }), 0.6, 0.9, 1.1, 1.5,
     0.0, 0.1},
    {"CoarseLines", "A1", 3, circular(0.001), 1.0, 100.0, 1e4, 1e5, 0.9, 1.0},
    {"CoarseLinesOfARig", "rig1", 20, circular(0.001), 1.0, 100.0, 1e4, 1e5, 0.9, 1.0},
};
INSTANTIATE_TEST_SUITE_P(Problem, ScatterOf, ::testing::ValuesIn(ways), [](const auto& row) { return row.param.name; });

TEST(Scatter, OfTooFewLinesIsAnErrorWithItsRemedy) {
  const problems::Problem problem = problems::make("A1");
  const auto source = frf::from_memory(lines_of(problem.assembly, numbers(8)));
  const frf::FrfHeader& header = source->header();
  const auto piece = frf::find_piece(header, 0, header.response, header.reference, false);
  try {
    estimate_scatter(*source, piece, numbers(8));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::data);
    EXPECT_NE(error.parts().problem.find("8 lines are too few"), std::string::npos);
    EXPECT_NE(error.parts().remedy.find("[noise]"), std::string::npos);
  }
}

TEST(Scatter, OfTransposesLooksPastTheirSigns) {
  frf::FrfSet clean = thinned(problems::make("A1").assembly, 1);
  frf::NoiseModel model = circular(0.01);
  model.reciprocal = false;
  frf::FrfSet turned = frf::polluted(clean, model, 1, 1);
  const frf::FrfSet plain = turned;
  turned.header.response[2].sign = -1;
  for (std::size_t line = 0; line < turned.header.lines(); ++line) {
    for (std::size_t c = 0; c < turned.header.reference.size(); ++c) turned.values[turned.index(line, 2, c)] *= -1.0;
  }
  const auto laws = [](const frf::FrfSet& set) {
    const auto source = frf::from_memory(set);
    const auto piece = frf::find_piece(set.header, 0, set.header.response, set.header.reference, false);
    return estimate_scatter(*source, piece, numbers(set.header.lines())).laws;
  };
  const auto expected = laws(plain), found = laws(turned);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_DOUBLE_EQ(found[i].proportional, expected[i].proportional);
}

}  // namespace
}  // namespace jointid::ident
