// Scenes whose files have covariances: studies, bounds, intervals.
#include <gmock/gmock.h>

#include <numeric>

#include "frf/hdf5/hdf5_writer.hpp"
#include "tests/ident/hammer_sets.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/case/in_memory.hpp"
#include "study/recorded_noise.hpp"
#include "study/trial_data.hpp"
#include "study/trial_loop.hpp"
#include "tasks/bound.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

Scene scene_of(const problems::Problem& problem) {
  Scene scene = problems::scene(problem);
  scene.identify.method = Method::likelihood;
  scene.identify.equations = {Equation::nn, Equation::nj};
  scene.noise.reset();
  scene.frequency.step_hz = 60.0;
  return scene;
}

std::vector<double> truth_of(const problems::Problem& problem) {
  std::vector<double> out;
  for (const problems::ExactUnknown& unknown : problem.unknowns) out.push_back(unknown.value);
  return out;
}

std::vector<double> bound_of(const Scene& scene, const problems::Problem& problem, const problems::Measurement& sets) {
  return tasks::cramer_rao_bound(*problems::plan(scene, sets), truth_of(problem), {});
}

/// Trials of a study drawn from the files: rms errors are those of the bound, intervals hold the truth, χ² is as expected.
TEST(CovarianceScene, StudiesDrawFromTheFilesAndReachTheBound) {
  const problems::Problem problem = problems::make("A1");
  const problems::Measurement sets = with_hammer_noise(problem);
  const TestFolder folder;
  Scene scene = scene_of(problem);
  for (std::size_t i = 0; i < sets.substructures.size(); ++i) {
    frf::write_hdf5(sets.substructures[i], folder / (std::to_string(i) + ".h5"), {.covariance = true});
  }
  frf::write_hdf5(sets.assembly, folder / "assembly.h5", {.covariance = true});
  for (std::size_t i = 0; i < sets.substructures.size(); ++i)
    scene.data.substructures[i] = {.path = folder / (std::to_string(i) + ".h5"), .options = {}};
  scene.data.assembly = {{.path = folder / "assembly.h5", .options = {}}};
  const auto data = study::load_trial_data(scene);
  EXPECT_THAT(data->notes, testing::Contains(testing::HasSubstr("from the variances and covariances of the files")));
  const std::vector<study::Trial> trials = study::run_trials(data, {.trials = 12, .seed = 4});
  const std::vector<double> bound = bound_of(scene, problem, sets), truth = truth_of(problem);
  double squares = 0.0, covered = 0.0, count = 0.0;
  for (const study::Trial& trial : trials) {
    EXPECT_TRUE(is_usable(trial.status));
    for (std::size_t u = 0; u < truth.size(); ++u) {
      if (truth[u] == 0.0) continue;
      squares += std::pow((trial.values[u] - truth[u]) / bound[u], 2);
      covered += (*trial.ci95[u])[0] <= truth[u] && truth[u] <= (*trial.ci95[u])[1] ? 1.0 : 0.0;
      count += 1.0;
    }
  }
  EXPECT_NEAR(squares / count, 1.0, 0.35);
  EXPECT_GT(covered / count, 0.88);
}

/// Noise that all responses to a blow share says less of the joint than it would if each had its own.
TEST(CovarianceScene, BoundsKnowThatResponsesShareTheHammersNoise) {
  const problems::Problem problem = problems::make("A1");
  const problems::Measurement sets = with_hammer_noise(problem);
  problems::Measurement alone = sets;
  for (frf::FrfSet& set : alone.substructures) set.covariance.clear();
  alone.assembly.covariance.clear();
  const Scene scene = scene_of(problem);
  const std::vector<double> shared = bound_of(scene, problem, sets), own = bound_of(scene, problem, alone);
  for (std::size_t u = 0; u < own.size(); ++u) EXPECT_LT(shared[u], own[u]);
  // Covariances of errors that are independent change nothing.
  problems::Measurement diagonal = sets;
  const auto make_diagonal = [](frf::FrfSet& set) {
    const std::size_t rows = set.header.response.size(), columns = set.header.reference.size(), pairs = frf::pair_count(rows);
    for (std::size_t i = 0; i < set.covariance.size(); ++i) {
      const std::size_t pair = i / columns % pairs;
      bool point = false;
      for (std::size_t r = 0; r < rows; ++r) point = point || pair == frf::pair_index(r, r);
      if (!point) set.covariance[i] = 0.0;
    }
  };
  for (frf::FrfSet& set : diagonal.substructures) make_diagonal(set);
  make_diagonal(diagonal.assembly);
  EXPECT_EQ(bound_of(scene, problem, diagonal), own);
}

/// Two results that differ by rounding at most.
void expect_same(const Solution& one, const Solution& other) {
  ASSERT_EQ(one.unknowns.size(), other.unknowns.size());
  for (std::size_t u = 0; u < one.unknowns.size(); ++u) {
    const double error = one.unknowns[u].std_error.value();
    EXPECT_NEAR(one.unknowns[u].value, other.unknowns[u].value, 1e-6 * error);
    EXPECT_NEAR(other.unknowns[u].std_error.value(), error, 1e-8 * error);
  }
  EXPECT_NEAR(one.fit.chi_square->value, other.fit.chi_square->value, 1e-8 * one.fit.chi_square->value);
}

/// Whoever reads covariances does not see whether they are stored as pairs or as a factor: likelihood, bounds, studies.
TEST(CovarianceScene, AFactorSaysWhatItsPairsSay) {
  const problems::Problem problem = problems::make("A1");
  const problems::Measurement paired = with_hammer_noise(problem);
  problems::Measurement other = paired;
  for (frf::FrfSet& set : other.substructures) set = factored(std::move(set));
  other.assembly = factored(std::move(other.assembly));
  const Scene scene = scene_of(problem);
  const std::vector<double> bound = bound_of(scene, problem, paired), of_factor = bound_of(scene, problem, other);
  for (std::size_t u = 0; u < bound.size(); ++u) EXPECT_NEAR(of_factor[u], bound[u], 1e-9 * bound[u]);
  const auto trial = [&](const problems::Measurement& sets) {
    const TestFolder folder;
    Scene from_files = scene;
    const auto write = [&](const frf::FrfSet& set, const std::string& name) {
      frf::write_hdf5(set, folder / name);
      return folder / name;
    };
    for (std::size_t i = 0; i < sets.substructures.size(); ++i) {
      from_files.data.substructures[i] = {.path = write(sets.substructures[i], std::to_string(i) + ".h5"), .options = {}};
    }
    from_files.data.assembly = {{.path = write(sets.assembly, "assembly.h5"), .options = {}}};
    return study::run_trials(study::load_trial_data(from_files), {.trials = 2, .seed = 4});
  };
  const std::vector<study::Trial> of_pairs = trial(paired), drawn_by_factor = trial(other);
  for (std::size_t t = 0; t < of_pairs.size(); ++t) {
    for (std::size_t u = 0; u < bound.size(); ++u) {
      EXPECT_NEAR(drawn_by_factor[t].values[u], of_pairs[t].values[u], 1e-5 * bound[u]);
    }
  }
  expect_same(solve(*problems::plan(scene, paired)), solve(*problems::plan(scene, other)));
}

/// With errors as its covariances say.
frf::FrfSet drawn(const frf::FrfSet& set, const RandomStream& stream) {
  std::vector<std::size_t> lines(set.header.lines()), responses(set.header.response.size()), references(set.header.reference.size());
  for (std::vector<std::size_t>* all : {&lines, &responses, &references}) std::iota(all->begin(), all->end(), std::size_t{0});
  const auto source = frf::from_memory(set);
  const frf::Block block{lines, responses, references};
  frf::Excerpt excerpt = frf::excerpt(*source, block);
  excerpt.set.covariance = study::covariance_of(*source, block);
  frf::FrfSet out = set;
  study::RecordedNoise(excerpt).pollute(out, stream);
  return out;
}

/// What the status takes the residuals of Method One for: about what noise explains, where it knows which noise the FRFs share.
double mean_misfit(const problems::Problem& problem, bool with_covariances) {
  Scene scene = scene_of(problem);
  scene.identify.method = Method::one;
  Control control;
  control.judgement = Judgement::data;
  constexpr std::uint64_t seeds = 8;
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    problems::Measurement data = with_hammer_noise(problem);
    std::uint64_t number = 0;
    for (frf::FrfSet& set : data.substructures) set = drawn(set, {seed, 0, number++});
    data.assembly = drawn(data.assembly, {seed, 0, number});
    if (!with_covariances) {
      for (frf::FrfSet& set : data.substructures) set.covariance.clear();
      data.assembly.covariance.clear();
    }
    sum += solve(*problems::plan(scene, data), control).fit.misfit.value();
  }
  return sum / static_cast<double>(seeds);
}

TEST(CovarianceScene, TheStatusKnowsWhatResponsesShare) {
  const problems::Problem problem = problems::make("A1");
  const double with = mean_misfit(problem, true), alone = mean_misfit(problem, false);
  EXPECT_NEAR(with, 1.0, 0.25);
  EXPECT_LT(std::abs(std::log(with)), std::abs(std::log(alone)));
}

}  // namespace
}  // namespace jointid::ident
