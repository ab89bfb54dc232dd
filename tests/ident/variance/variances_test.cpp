#include "ident/variance/variances.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "frf/noise/repeats.hpp"
#include "frf/set/h1.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "study/trial_runner.hpp"
#include "tests/ident/memory_systems.hpp"

namespace jointid::ident {
namespace {

using frf::Composition;
using frf::NoiseRecord;
using ::testing::HasSubstr;

std::vector<std::size_t> all_lines(const frf::FrfSystem& system) {
  std::vector<std::size_t> lines(system.frequency_hz().size());
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = i;
  return lines;
}

/// FRFs and variances of a rectangle at all lines of a system.
struct Rectangles {
  std::vector<Complex> frf, variance;
};

Rectangles read_all(frf::FrfSystem& system, const Dofs& rows, const Dofs& columns, const Scene& scene) {
  const auto lines = all_lines(system);
  Rectangles out;
  out.frf.resize(lines.size() * rows.size() * columns.size());
  out.variance.resize(out.frf.size());
  frf::BlockReader(system, rows, columns).read(lines, out.frf);
  Variances variances(system, rows, columns, scene);
  if (variances.needs_prepare()) variances.prepare(lines);
  variances.read(lines, out.frf, out.variance);
  return out;
}

const std::vector<double> axis = {10.0, 20.0, 40.0, 50.0};

frf::FrfSet sample(const std::string& file, const Dofs& responses, const Dofs& references) {
  std::mt19937_64 random(5);
  return random_set(file, axis, responses, references, 1.0, random);
}

frf::FrfSet with_variance(frf::FrfSet set, double first) {
  set.header.noise = NoiseRecord::variance;
  for (std::size_t i = 0; i < set.values.size(); ++i) {
    set.variance.emplace_back(first + static_cast<double>(i), first + 0.5 + static_cast<double>(i));
  }
  return set;
}

frf::FrfSet with_coherence(frf::FrfSet set, double coherence, double averages) {
  set.header.noise = NoiseRecord::coherence;
  set.header.averages = averages;
  set.coherence.assign(set.values.size(), coherence);
  return set;
}

Scene with_noise(frf::NoiseModel model) {
  Scene scene;
  scene.noise = NoiseSection{.model = frf::name(model.kind), .level = model.level, .frf_model = model};
  return scene;
}

void expect_near(Complex found, Complex expected) {
  EXPECT_NEAR(found.real(), expected.real(), 1e-12 * std::abs(expected.real()));
  EXPECT_NEAR(found.imag(), expected.imag(), 1e-12 * std::abs(expected.imag()));
}

TEST(Variances, OfAFileComeInTheOrderOfTheRectangleWithoutSigns) {
  const frf::FrfSet set = with_variance(sample("a", dofs({"1:+X", "2:+X", "3:+X"}), dofs({"1:+X", "2:+X"})), 1.0);
  const auto system = memory_system("assembly", {set}, Composition::merged);
  const auto read = read_all(*system, dofs({"3:-X", "1:+X"}), dofs({"2:-X"}), {});
  for (std::size_t line = 0; line < axis.size(); ++line) {
    EXPECT_EQ(read.variance[2 * line], set.variance[set.index(line, 2, 1)]);
    EXPECT_EQ(read.variance[2 * line + 1], set.variance[set.index(line, 0, 1)]);
  }
}

TEST(Variances, OfACoherenceAreThoseOfH1) {
  const frf::FrfSet set = with_coherence(sample("a", dofs({"1:+X"}), dofs({"1:+X"})), 0.9, 7.0);
  const auto system = memory_system("assembly", {set}, Composition::merged);
  const auto read = read_all(*system, set.header.response, set.header.reference, {});
  for (std::size_t line = 0; line < axis.size(); ++line) {
    const double part = std::norm(set.values[line]) * 0.1 / (0.9 * 6.0) / 2.0;
    expect_near(read.variance[line], {part, part});
  }
}

TEST(Variances, OfACoherenceOfZeroAreUnknown) {
  const frf::FrfSet set = with_coherence(sample("a", dofs({"1:+X"}), dofs({"1:+X"})), 0.0, 7.0);
  const auto system = memory_system("assembly", {set}, Composition::merged);
  EXPECT_TRUE(std::isnan(read_all(*system, set.header.response, set.header.reference, {}).variance[0].real()));
}

TEST(Variances, AcrossUncoupledFilesAreZeroAndOfNoFileUnknown) {
  const frf::FrfSet a = with_variance(sample("a", dofs({"1:+X", "2:+X"}), dofs({"1:+X"})), 1.0);
  const frf::FrfSet b = with_variance(sample("b", dofs({"5:+X"}), dofs({"5:+X"})), 1.0);
  const auto parts = memory_system("substructures", {a, b}, Composition::uncoupled);
  const auto read = read_all(*parts, dofs({"1:+X", "5:+X"}), dofs({"1:+X", "5:+X"}), {});
  EXPECT_EQ(read.variance[1], Complex(0.0, 0.0));
  EXPECT_EQ(read.variance[2], Complex(0.0, 0.0));
  EXPECT_EQ(read.variance[3], b.variance[0]);
  const auto whole = memory_system("assembly", {a, b}, Composition::merged);
  EXPECT_TRUE(std::isnan(read_all(*whole, dofs({"1:+X"}), dofs({"5:+X"}), {}).variance[0].real()));
}

TEST(Variances, OfATransposeGoWithItsValue) {
  const Dofs both = dofs({"1:+X", "2:+X"});
  frf::FrfSet set = with_variance(sample("a", both, both), 1.0);
  set.values[set.index(1, 0, 1)] = nan;  // its variance stays: that of 2/1 is wanted
  const auto system = memory_system("assembly", {set}, Composition::merged, true);
  const auto read = read_all(*system, dofs({"1:+X"}), dofs({"2:-X"}), {});
  EXPECT_EQ(read.variance[0], set.variance[set.index(0, 0, 1)]);
  EXPECT_EQ(read.frf[1], -set.values[set.index(1, 1, 0)]);
  EXPECT_EQ(read.variance[1], set.variance[set.index(1, 1, 0)]);
}

TEST(Variances, OfAMissingFrfAreUnknown) {
  frf::FrfSet set = with_variance(sample("a", dofs({"1:+X"}), dofs({"1:+X"})), 1.0);
  set.values[2] = nan;
  const auto system = memory_system("assembly", {set}, Composition::merged);
  const auto read = read_all(*system, set.header.response, set.header.reference, {});
  EXPECT_TRUE(std::isnan(read.variance[2].real()));
  EXPECT_FALSE(std::isnan(read.variance[1].real()));
}

TEST(Variances, FollowTheLawOfTheNoiseAtTheMeasuredValue) {
  const frf::FrfSet set = sample("a", dofs({"1:+X"}), dofs({"1:+X"}));
  for (const auto kind : {frf::NoiseKind::uniform, frf::NoiseKind::gaussian, frf::NoiseKind::circular}) {
    const auto system = memory_system("assembly", {set}, Composition::merged);
    const auto read = read_all(*system, set.header.response, set.header.reference, with_noise({.kind = kind, .level = 0.06}));
    for (std::size_t line = 0; line < axis.size(); ++line) {
      const Complex h = set.values[line];
      const bool circular = kind == frf::NoiseKind::circular;
      expect_near(read.variance[line], circular ? Complex(0.0018 * std::norm(h), 0.0018 * std::norm(h))
                                                : Complex(0.0012 * h.real() * h.real(), 0.0012 * h.imag() * h.imag()));
    }
  }
}

TEST(Variances, OfAFloorAreConstantInTheQuantityOfTheFile) {
  frf::FrfSet set = sample("a", dofs({"1:+X"}), dofs({"1:+X"}));
  set.header.quantity = frf::Quantity::accelerance;
  const frf::NoiseModel model{.kind = frf::NoiseKind::circular, .level = 0.0, .floor = 0.1};
  const auto system = memory_system("assembly", {set}, Composition::merged);
  const auto read = read_all(*system, set.header.response, set.header.reference, with_noise(model));
  double mean_square = 0.0;
  const auto to_stored = [](std::size_t line) { return std::norm(frf::from_receptance(frf::Quantity::accelerance, axis[line])); };
  for (std::size_t line = 0; line < axis.size(); ++line) mean_square += std::norm(set.values[line]) * to_stored(line) / 4.0;
  for (std::size_t line = 0; line < axis.size(); ++line) {
    const double part = 0.005 * mean_square / to_stored(line);
    expect_near(read.variance[line], {part, part});
  }
}

TEST(Variances, OfAFloorDoNotDependOnTheLinesInUse) {
  const frf::FrfSet set = sample("a", dofs({"1:+X"}), dofs({"1:+X"}));
  const auto system = memory_system("assembly", {set}, Composition::merged);
  const Scene scene = with_noise({.kind = frf::NoiseKind::circular, .level = 0.01, .floor = 0.1});
  const auto all = read_all(*system, set.header.response, set.header.reference, scene);
  Variances some(*system, set.header.response, set.header.reference, scene);
  const std::array<std::size_t, 1> third = {2};
  some.prepare(third);
  std::vector<Complex> variance(1);
  some.read(third, std::span(all.frf).subspan(2, 1), variance);
  EXPECT_EQ(variance[0], all.variance[2]);
}

TEST(Variances, AutoTakesTheFileThenTheNoiseAndAChoiceIsAChoice) {
  const frf::FrfSet with = with_coherence(sample("with", dofs({"1:+X"}), dofs({"1:+X"})), 0.9, 5.0);
  const frf::FrfSet without = sample("without", dofs({"2:+X"}), dofs({"2:+X"}));
  const auto system = memory_system("assembly", {with, without}, Composition::merged);
  const Dofs both = dofs({"1:+X", "2:+X"});
  Scene scene = with_noise({.level = 0.01});
  const auto origins = [&] { return Variances(*system, both, both, scene).origins(); };
  EXPECT_EQ(origins()[0].origin, VarianceOrigin::coherence);
  EXPECT_EQ(origins()[1].origin, VarianceOrigin::noise_model);
  EXPECT_EQ(origins()[1].file, "without");
  scene.identify.variance = VarianceChoice::noise;
  EXPECT_EQ(origins()[0].origin, VarianceOrigin::noise_model);
  scene.identify.variance = VarianceChoice::file;
  EXPECT_THROW(origins(), InputError);
}

TEST(Variances, OfOneAverageAreRefusedWithTheRemedy) {
  const frf::FrfSet set = with_coherence(sample("a.h5", dofs({"1:+X"}), dofs({"1:+X"})), 1.0, 1.0);
  const auto system = memory_system("assembly", {set}, Composition::merged);
  try {
    const Variances refused(*system, set.header.response, set.header.reference, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::data);
    EXPECT_EQ(error.parts().file, "a.h5");
    EXPECT_THAT(error.what(), HasSubstr("1 average"));
    EXPECT_THAT(error.parts().remedy, HasSubstr("[noise]"));
  }
}

TEST(Variances, ReadNothingBeforeTheyAreAsked) {
  const frf::FrfSet set = sample("a", dofs({"1:+X"}), dofs({"1:+X"}));
  const auto system = memory_system("assembly", {set}, Composition::merged);
  Variances variances(*system, set.header.response, set.header.reference, with_noise({.level = 0.01}));
  const std::vector<std::size_t> lines = {0};
  std::vector<Complex> out(1);
  variances.prepare(lines);
  variances.read(lines, std::vector<Complex>{1.0}, out);
  EXPECT_EQ(system->source(0).count().calls, 0u);
}

TEST(Variances, OfRepeatsAreThoseOfTheirMean) {
  frf::FrfSet run = sample("a", dofs({"1:+X"}), dofs({"1:+X"}));
  std::vector<std::unique_ptr<frf::FrfSource>> runs, sources;
  for (const double shift : {-1.0, 0.0, 1.0}) {
    frf::FrfSet other = run;
    for (Complex& value : other.values) value += Complex(shift, 2.0 * shift);
    runs.push_back(frf::from_memory(other));
  }
  sources.push_back(frf::mean_of_repeats(std::move(runs)));
  frf::FrfSystem system("assembly", std::move(sources), Composition::merged, false);
  const auto read = read_all(system, run.header.response, run.header.reference, {});
  EXPECT_NEAR(read.variance[0].real(), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(read.variance[0].imag(), 4.0 / 3.0, 1e-12);
  EXPECT_EQ(Variances(system, run.header.response, run.header.reference, {}).origins()[0].origin, VarianceOrigin::repeats);
}

TEST(Variances, AreSmoothedOnRequest) {
  std::mt19937_64 random(3);
  std::vector<double> lines;
  for (int i = 1; i <= 200; ++i) lines.push_back(i);
  frf::FrfSet set = random_set("a", lines, dofs({"1:+X"}), dofs({"1:+X"}), 1.0, random);
  set.header.noise = NoiseRecord::coherence;
  set.header.averages = 5.0;
  const double a = 1e-3, b = 1e-4;
  std::gamma_distribution<double> gamma(4.0);
  for (const Complex value : set.values) {
    const double residual = (a * std::norm(value) + b) * gamma(random);  // (n_d − 1)σ̂² of four degrees of freedom
    set.coherence.push_back(std::norm(value) / (std::norm(value) + residual));
  }
  const auto system = memory_system("assembly", {set}, Composition::merged);
  Scene scene;
  scene.identify.smooth_variance = true;
  const auto read = read_all(*system, set.header.response, set.header.reference, scene);
  for (std::size_t line = 0; line < lines.size(); ++line) {
    EXPECT_NEAR(2.0 * read.variance[line].real() / (a * std::norm(set.values[line]) + b), 1.0, 0.25);
  }
}

TEST(Variances, FromTheScatterNeedNothingElse) {
  const problems::Problem problem = problems::make("A1");
  const frf::FrfSet noisy = frf::polluted(problem.assembly, {.kind = frf::NoiseKind::circular, .level = 0.02}, 1, 1);
  const auto system = memory_system("assembly", {noisy}, Composition::merged);
  const Dofs some = dofs({"1:+Y", "7:+Y"});
  const auto read = read_all(*system, some, some, {});
  std::vector<double> relative;
  for (std::size_t i = 0; i < read.frf.size(); ++i) {
    relative.push_back(std::sqrt(2.0 * read.variance[i].real()) / std::abs(read.frf[i]));
  }
  std::nth_element(relative.begin(), relative.begin() + 62, relative.end());
  EXPECT_NEAR(relative[62] / 0.02, 1.0, 0.4);
  Variances variances(*system, some, some, {});
  EXPECT_EQ(variances.origins()[0].origin, VarianceOrigin::scatter);
  EXPECT_TRUE(note(variances.origins()[0]).empty());
}

/// The law holds on average over the noise: the mean of the variances found is the scatter of the polluted values.
RC_GTEST_PROP(Variances, AgreeWithTheScatterOverSeeds, ()) {
  const auto kind =
      *rc::gen::element(frf::NoiseKind::uniform, frf::NoiseKind::gaussian, frf::NoiseKind::circular, frf::NoiseKind::hammer);
  const frf::NoiseModel model{.kind = kind,
                              .level = 0.05,
                              .coherence = 0.99,
                              .averages = 6,
                              .floor = kind == frf::NoiseKind::hammer ? 0.0 : *rc::gen::element(0.0, 0.03)};
  frf::FrfSet clean;
  clean.header.frequency_hz.resize(4000);
  for (std::size_t i = 0; i < 4000; ++i) clean.header.frequency_hz[i] = 1.0 + static_cast<double>(i);
  clean.header.response = clean.header.reference = dofs({"1:+X"});
  clean.values.assign(4000, Complex(1.0, -2.0));
  const frf::FrfSet noisy = frf::polluted(clean, model, static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000)), 1);
  const auto system = memory_system("assembly", {noisy}, Composition::merged);
  const auto read = read_all(*system, clean.header.response, clean.header.reference, with_noise(model));
  double real = 0.0, imag = 0.0, found_real = 0.0, found_imag = 0.0;
  for (std::size_t i = 0; i < 4000; ++i) {
    real += std::pow(noisy.values[i].real() - 1.0, 2);
    imag += std::pow(noisy.values[i].imag() + 2.0, 2);
    found_real += read.variance[i].real();
    found_imag += read.variance[i].imag();
  }
  RC_ASSERT(std::abs(found_real / real - 1.0) < 0.15);
  RC_ASSERT(std::abs(found_imag / imag - 1.0) < 0.15);
}

/// Origins of the assembly's variances in a trial of the study of a problem.
VarianceOrigin origin_in_study(const std::string& name, const std::optional<frf::NoiseModel>& noise, VarianceChoice choice) {
  const problems::Problem problem = problems::make(name);
  Scene scene = problems::scene(problem);
  scene.identify.variance = choice;
  const study::Measurements clean{problem.substructures, {problem.assembly}};
  const auto data = noise ? study::make_trial_data(scene, clean, *noise) : problems::trial_data(scene, problem);
  study::TrialRunner runner(data);
  runner.run(1, 1);
  const Plan& plan = runner.plan();
  const Dofs some = {plan.assembly->responses().front()};
  Variances variances(*plan.assembly, some, some, plan.scene);
  const std::vector<std::size_t> lines = {plan.lines.front().assembly, plan.lines.back().assembly};
  std::vector<Complex> values(2), found(2);
  frf::BlockReader(*plan.assembly, some, some).read(lines, values);
  variances.prepare(lines);
  variances.read(lines, values, found);
  for (const Complex variance : found) EXPECT_GT(variance.real(), 0.0);
  return variances.origins()[0].origin;
}

TEST(Variances, OfATrialAreThoseOfItsNoise) {
  using enum VarianceOrigin;
  const frf::NoiseModel uniform{.level = 0.05}, hammer{.kind = frf::NoiseKind::hammer};
  EXPECT_EQ(origin_in_study("A1", {}, VarianceChoice::automatic), noise_model);
  EXPECT_EQ(origin_in_study("A1", {}, VarianceChoice::local), scatter);
  EXPECT_EQ(origin_in_study("A1", hammer, VarianceChoice::automatic), coherence);
  EXPECT_EQ(origin_in_study("rig1", {}, VarianceChoice::automatic), coherence);
  EXPECT_EQ(origin_in_study("rig1", uniform, VarianceChoice::automatic), noise_model);
  EXPECT_EQ(origin_in_study("rig1", uniform, VarianceChoice::file), noise_model);
}

}  // namespace
}  // namespace jointid::ident
