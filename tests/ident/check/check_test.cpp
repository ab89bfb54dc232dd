// Mistakes in measured FRFs: what a check says of planted ones, of clean scenes, and of its parts alone.
#include "ident/check/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "base/error.hpp"
#include "tests/ident/hammer_sets.hpp"
#include "ident/check/trial/axis_shift.hpp"
#include "ident/check/test/delay_fit.hpp"
#include "ident/check/test/file_tests.hpp"
#include "ident/check/rigid_mass.hpp"
#include "ident/check/test/span_test.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/planted.hpp"
#include "problems/problem.hpp"

namespace {

using namespace jointid;
using ident::SuspectKind;

frf::NoiseModel separate_errors(double level) { return {.kind = frf::NoiseKind::circular, .level = level, .reciprocal = false}; }

const problems::Problem& problem_named(const std::string& name) {
  static std::map<std::string, problems::Problem> made;
  const auto known = made.find(name);
  return known != made.end() ? known->second : made.emplace(name, problems::make(name)).first->second;
}

ident::CheckResult checked(const problems::Problem& problem, problems::Measurement data) {
  return problems::check(problems::scene(problem), std::move(data));
}

problems::Measurement noisy(const problems::Problem& problem, const frf::NoiseModel& noise) {
  problems::Measurement data;
  for (std::size_t i = 0; i < problem.substructures.size(); ++i) {
    data.substructures.push_back(frf::polluted(problem.substructures[i], noise, 1, 0, i));
  }
  data.assembly = frf::polluted(problem.assembly, noise, 1, 0, problem.substructures.size());
  return data;
}

std::vector<ident::CheckedFile> files_of(const problems::Problem& problem) {
  const auto plan = problems::plan(problems::scene(problem), {problem.substructures, problem.assembly});
  return ident::read_checked_files({plan->scene, *plan->substructures, *plan->assembly, plan->lines}, {64}, {});
}

struct PlantedIn : testing::TestWithParam<std::tuple<const char*, SuspectKind>> {};

TEST_P(PlantedIn, comes_first) {
  const auto [name, kind] = GetParam();
  const problems::Planted planted =
      problems::plant(problem_named(name), kind, separate_errors(0.01), 1 + static_cast<std::uint64_t>(kind));
  const ident::CheckResult result = checked(problem_named(name), planted.data);
  EXPECT_NE(result.verdict, ident::Verdict::clean);
  ASSERT_FALSE(result.suspects.empty());
  const ident::Suspect& first = result.suspects.front();
  EXPECT_TRUE(problems::is_found(planted, result.suspects))
      << ident::name(first.kind) << " in " << first.file << ": " << first.evidence;
}

INSTANTIATE_TEST_SUITE_P(check, PlantedIn,
                         testing::Combine(testing::Values("A1", "rig1"), testing::ValuesIn(problems::plantable())),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param)) + "_" + ident::name(std::get<1>(info.param));
                         });

TEST(check, remedy_names_file_channel_and_key) {
  const problems::Planted planted = problems::plant(problem_named("rig1"), SuspectKind::sign, separate_errors(0.01), 1);
  const ident::CheckResult result = checked(problem_named("rig1"), planted.data);
  ASSERT_FALSE(result.suspects.empty());
  EXPECT_EQ(result.suspects.front().remedy,
            "[data.files.\"" + planted.files.front() + "\"]\nflip = [\"" + planted.dofs.front().name() + "\"]");
}

/// The lines of a remedy that are comments, but for those in prose.
std::string uncommented(const std::string& remedy) {
  std::string out;
  std::istringstream lines(remedy);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# ") && !line.starts_with("# or")) out += line.substr(2) + "\n";
  }
  return out;
}

TEST(check, a_gain_of_a_few_percent_may_be_an_unknown) {
  const problems::Problem& problem = problem_named("rig1");
  const problems::Planted planted = problems::plant(problem, SuspectKind::gain, separate_errors(0.01), 1);
  const ident::CheckResult result = checked(problem, planted.data);
  ASSERT_FALSE(result.suspects.empty());
  ASSERT_EQ(result.suspects.front().kind, SuspectKind::gain);
  const ident::Scene scene = ident::parse_scene(problem.scene + "\n" + uncommented(result.suspects.front().remedy), "rig1.toml");
  ASSERT_EQ(scene.data.gains.size(), 1u);
  EXPECT_EQ(frf::names(scene.data.gains.front().dofs), frf::names(planted.dofs));
  EXPECT_GT(scene.data.gains.front().gain, 0.01);
  EXPECT_LT(scene.data.gains.front().gain, 0.1);
}

TEST(check, clean_scenes_are_clean) {
  for (const char* name : {"A1", "A3", "A8", "C1", "E1", "G4", "H1", "H3"}) {
    const problems::Problem& problem = problem_named(name);
    for (const frf::NoiseModel& noise : {frf::NoiseModel{}, separate_errors(0.01)}) {
      const ident::CheckResult result = checked(problem, noisy(problem, noise));
      EXPECT_EQ(result.verdict, ident::Verdict::clean)
          << name << ": " << (result.suspects.empty() ? "" : result.suspects.front().evidence);
    }
  }
}

/// All responses to a blow share 10 % noise of the hammer.
problems::Measurement hammered(const problems::Measurement& exact, std::uint64_t seed, bool covariances) {
  problems::Measurement data;
  std::uint64_t number = 0;
  const auto noisy_set = [&](const frf::FrfSet& set) {
    return ident::with_drawn_hammer_noise(set, 0.1, 0.0005, {seed, number++}, covariances);
  };
  for (const frf::FrfSet& set : exact.substructures) data.substructures.push_back(noisy_set(set));
  data.assembly = noisy_set(exact.assembly);
  return data;
}

TEST(check, covariances_find_what_the_hammers_noise_hides) {
  const problems::Problem& problem = problem_named("rig1");
  std::size_t with = 0, alone = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const problems::Planted planted = problems::plant(problem, SuspectKind::gain, {.level = 0.0}, seed);
    for (const bool covariances : {true, false}) {
      const ident::CheckResult result = checked(problem, hammered(planted.data, seed, covariances));
      const bool named = !result.suspects.empty() && result.suspects.front().kind == SuspectKind::gain &&
                         frf::has(result.suspects.front().dofs, planted.dofs.front());
      (covariances ? with : alone) += named ? 1 : 0;
    }
  }
  EXPECT_EQ(with, 4u);
  EXPECT_LT(alone, 3u);
}

TEST(check, covariances_say_that_the_hammers_noise_is_no_wrong_gain) {
  const problems::Problem& problem = problem_named("bolts");
  std::size_t alone = 0;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const problems::Measurement exact{problem.substructures, problem.assembly};
    const ident::CheckResult result = checked(problem, hammered(exact, seed, true));
    EXPECT_EQ(result.verdict, ident::Verdict::clean) << (result.suspects.empty() ? "" : result.suspects.front().evidence);
    alone += checked(problem, hammered(exact, seed, false)).verdict == ident::Verdict::clean ? 0U : 1U;
  }
  EXPECT_GE(alone, 1u);
}

TEST(check, a_mistaken_label_may_be_one_that_the_scene_needs) {
  const problems::Problem& problem = problem_named("A1");
  problems::Measurement data = noisy(problem, separate_errors(0.01));
  const frf::Dof right = problem.joint_dofs.front(), wrong = frf::Dof::parse("99:+Y");
  auto& responses = data.assembly.header.response;
  *std::ranges::find_if(responses, [&](const frf::Dof& dof) { return dof.same_coordinate(right); }) = wrong;
  ident::Scene scene = problems::scene(problem);
  scene.identify.equations = {ident::Equation::jj};
  EXPECT_THROW(problems::plan(scene, data), jointid::InputError);
  const ident::CheckResult result = problems::check(scene, std::move(data));
  ASSERT_FALSE(result.suspects.empty());
  EXPECT_EQ(result.suspects.front().kind, SuspectKind::label);
  EXPECT_EQ(frf::names(result.suspects.front().dofs), (std::vector<std::string>{wrong.name(), right.name()}));
}

TEST(check, reads_every_frf_at_most_once) {
  const problems::Problem& problem = problem_named("rig1");
  const auto plan = problems::plan(problems::scene(problem), noisy(problem, separate_errors(0.01)));
  (void)ident::check_data(*plan);
  const frf::FrfSource& source = plan->assembly->source(0);
  EXPECT_EQ(source.count().entries, source.header().lines() * source.header().entries());
}

TEST(check, missing_numbers_are_no_mistake) {
  const problems::Problem& problem = problem_named("A1");
  problems::Measurement data = noisy(problem, separate_errors(0.01));
  const std::size_t columns = data.assembly.header.reference.size();
  for (std::size_t c = 0; c < columns; ++c) data.assembly.values[data.assembly.index(3, 2, c)] = std::nan("");
  for (std::size_t l = 0; l < data.assembly.header.lines(); ++l) {
    for (std::size_t c = 0; c < columns; ++c) data.assembly.values[data.assembly.index(l, 0, c)] = std::nan("");
  }
  EXPECT_EQ(checked(problem, std::move(data)).verdict, ident::Verdict::clean);
}

TEST(span_test, exact_frfs_leave_nothing_whatever_the_joint) {
  const problems::Problem& problem = problem_named("B");
  const auto files = files_of(problem);
  const auto setups = ident::span_setups(files, problem.joint_dofs);
  ASSERT_EQ(setups.size(), 4u);  // two parts, both directions
  for (const auto& setup : setups)
    EXPECT_NEAR(ident::span_test(setup, files, ident::SpanDetail::level).level, 1e-3, 1e-5);  // the floor
}

TEST(span_test, finds_the_factor_of_a_row) {
  const problems::Problem& problem = problem_named("A1");
  auto files = files_of(problem);
  for (auto& line : files.back().frfs) line.row(1) *= 0.8;
  const auto setup = ident::span_setups(files, problem.joint_dofs).front();
  const ident::SpanTest test = ident::span_test(setup, files, ident::SpanDetail::rows);
  EXPECT_NEAR(test.gain[1], 1.25, 1e-6);
  EXPECT_NEAR(test.share[1], 1.0, 1e-6);
}

TEST(reciprocity_test, finds_the_mass_that_travels_with_the_sensor) {
  const problems::Planted planted = problems::plant(problem_named("rig1"), SuspectKind::mass, {.level = 0.0}, 1);
  const auto plan = problems::plan(problems::scene(problem_named("rig1")), planted.data);
  const auto files = ident::read_checked_files({plan->scene, *plan->substructures, *plan->assembly, plan->lines}, {64}, {});
  EXPECT_NEAR(ident::reciprocity_test(files.back(), true).mass, 0.003, 1e-8);
}

TEST(delay_fit, finds_the_delay_and_its_scatter) {
  std::vector<ident::PhaseSample> samples;
  for (int i = 1; i <= 50; ++i) {
    const double omega = 200.0 * i;
    samples.push_back({omega, std::polar(1.0, -35e-6 * omega)});
  }
  const ident::DelayFit fit = ident::fit_delay(samples);
  EXPECT_NEAR(fit.delay, 35e-6, 1e-12);
  EXPECT_LT(fit.deviation, 1e-10);
}

TEST(shifted_frfs, are_those_of_the_structure_at_the_other_frequencies) {
  ident::CheckedFile file;
  file.responses = file.references = {frf::Dof::parse("1:+Y")};
  const auto mode = [](double resonance, double hz) {
    return 1.0 / (std::complex<double>(resonance * resonance, 90.0) - hz * hz);
  };
  const auto receptance = [&](double hz) { return mode(300.0, hz) + 0.5 * mode(340.0, hz); };
  for (int i = 0; i < 20; ++i) {
    file.frequency_hz.push_back(250.0 + 5.0 * i);
    file.frfs.push_back(Eigen::MatrixXcd::Constant(1, 1, receptance(file.frequency_hz.back())));
  }
  const auto shifted = ident::shifted_frfs(file, {4, 10, 15}, 0.004);
  EXPECT_NEAR(std::abs(shifted[1](0, 0) / receptance(300.0 * 1.004) - 1.0), 0.0, 1e-6);
}

/// A free beam of 2.4 kg and 0.05 kg m² with points at -0.3, 0.1 and 0.4 m from its middle, and one elastic mode; 10 to 60 Hz.
ident::CheckedFile free_beam(double grounded_hz = 0.0) {
  const Eigen::Vector3d ones = Eigen::Vector3d::Ones(), place(-0.3, 0.1, 0.4), shape(1.0, -0.8, 1.3);
  ident::CheckedFile file;
  for (const char* dof : {"1:+Y", "2:+Y", "3:+Y"}) file.responses.push_back(frf::Dof::parse(dof));
  file.references = file.responses;
  const auto square = [](double hz) { return std::pow(2.0 * M_PI * hz, 2); };
  for (double hz = 10.0; hz <= 60.0; hz += 2.0) {
    const std::complex<double> damped(1.0, 0.002);
    const Eigen::Matrix3d rigid = ones * ones.transpose() / 2.4 + place * place.transpose() / 0.05;
    file.frequency_hz.push_back(hz);
    file.frfs.push_back(rigid.cast<std::complex<double>>() / (damped * square(grounded_hz) - square(hz)) +
                        (shape * shape.transpose() / 2.0).cast<std::complex<double>>() / (damped * square(300.0) - square(hz)));
  }
  return file;
}

TEST(rigid_body_mass, is_that_of_a_free_structure_and_of_no_other) {
  const auto mass = ident::rigid_body_mass(free_beam());
  ASSERT_TRUE(mass);
  EXPECT_NEAR(*mass, 2.4, 0.03);
  EXPECT_FALSE(ident::rigid_body_mass(free_beam(25.0)));
  EXPECT_FALSE(ident::rigid_body_mass(free_beam(500.0)));
}

TEST(find_wrong_masses, tells_units_and_puts_the_file_right) {
  for (const auto& [unit, weighed, words] :
       {std::tuple(1.0, 2.5, ""), std::tuple(9.80665, 2.4, "g in place of m/s²"), std::tuple(1000.0, 2.4, "mm in place of m"),
        std::tuple(1.0, 1.6, "1.6 kg were weighed")}) {
    ident::CheckedFile file = free_beam();
    file.mass = weighed;
    for (auto& line : file.frfs) line *= unit == 9.80665 ? 1.0 / unit : unit;
    std::vector<ident::CheckedFile> files = {file};
    const auto suspects = ident::find_wrong_masses(files, {});
    ASSERT_EQ(suspects.size(), std::string(words).empty() ? 0u : 1u) << unit;
    if (suspects.empty()) continue;
    EXPECT_EQ(suspects.front().kind, unit == 1.0 ? SuspectKind::gain : SuspectKind::unit);
    EXPECT_THAT(suspects.front().evidence, testing::HasSubstr(words));
    if (unit != 1.0) {
      EXPECT_NEAR(std::abs(files.front().frfs.front()(0, 1) / free_beam().frfs.front()(0, 1)), 1.0, 1e-12);
    }
  }
}

}  // namespace
