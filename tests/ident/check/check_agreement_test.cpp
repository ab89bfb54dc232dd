// Files against their own noise, groups of references, and numbers that stand twice: what a check says of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "frf/file/write.hpp"
#include "frf/noise/noise.hpp"
#include "ident/check/agreement.hpp"
#include "ident/check/check.hpp"
#include "ident/check/inquiry.hpp"
#include "ident/check/real_frfs.hpp"
#include "ident/check/repeated_numbers.hpp"
#include "ident/check/rest.hpp"
#include "ident/check/rigid_mass.hpp"
#include "ident/check/test/reference_groups.hpp"
#include "ident/check/test/span_test.hpp"
#include "ident/check/trial/group_trials.hpp"
#include "ident/check/trial/trials.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/variance/noise_laws.hpp"
#include "ident/whole_check.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "tests/test_folder.hpp"

namespace {

using namespace jointid;
using ident::CheckedFile;
using ident::SuspectKind;
using testing::HasSubstr;

/// FRFs of six points of a structure of three modes with 0.3 % noise, 60 lines; `shift` of the modes, relative.
CheckedFile structure(double shift, std::uint64_t seed, double noise = 0.003) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  CheckedFile file;
  file.name = "S.h5";
  file.assembly = true;
  for (int node = 1; node <= 6; ++node) file.responses.push_back(frf::Dof::parse(std::to_string(node) + ":+Z"));
  file.references = file.responses;
  for (int l = 0; l < 60; ++l) {
    const double hz = 20.0 + 4.0 * l;
    Eigen::MatrixXcd h = Eigen::MatrixXcd::Zero(6, 6);
    for (int m = 1; m <= 3; ++m) {
      Eigen::VectorXcd shape(6);
      for (int i = 0; i < 6; ++i) shape[i] = std::cos(m * (0.4 + 0.37 * i));
      h += shape * shape.transpose() / (std::pow(70.0 * m * (1.0 + shift), 2) * Complex(1.0, 0.02) - hz * hz);
    }
    for (Complex& value : h.reshaped()) value *= 1.0 + noise / std::sqrt(2.0) * Complex(normal(generator), normal(generator));
    file.frequency_hz.push_back(hz);
    file.frfs.push_back(h);
  }
  return file;
}

ident::CheckResult checked(std::vector<CheckedFile> files) { return ident::inquire(std::move(files), {}, {}, false); }

TEST(mirror_agreement, is_one_for_noise_whatever_its_size_was_said_to_be) {
  CheckedFile file = structure(0.0, 1);
  EXPECT_NEAR(ident::mirror_agreement(file).ratio, 1.0, 0.15);
  file.noise = std::make_shared<const ident::NoiseLaws>(
      ident::NoiseLaws{Eigen::MatrixXd::Constant(6, 6, 9e-6), Eigen::MatrixXd::Zero(6, 6)});
  const ident::Agreement recorded = ident::mirror_agreement(file);
  EXPECT_TRUE(recorded.recorded);
  EXPECT_NEAR(recorded.ratio, 1.0, 0.15);
  EXPECT_FALSE(recorded.contradicts());
}

TEST(check, names_references_measured_after_the_structure_changed) {
  CheckedFile file = structure(0.0, 1);
  const CheckedFile later = structure(0.004, 2);
  for (std::size_t l = 0; l < file.frfs.size(); ++l) file.frfs[l].rightCols(2) = later.frfs[l].rightCols(2);
  const ident::CheckResult result = checked({file});
  ASSERT_EQ(result.suspects.size(), 1u);
  EXPECT_EQ(result.verdict, ident::Verdict::suspicious);
  EXPECT_EQ(ident::title(result.suspects[0]), "not_reciprocal 5:+Z, 6:+Z in S.h5");
  EXPECT_THAT(result.suspects[0].evidence, HasSubstr("mostly in references 5:+Z, 6:+Z against the others"));
  ASSERT_EQ(result.reciprocity.size(), 1u);
  EXPECT_LT(result.reciprocity[0].rms[0][1], 0.01);
  EXPECT_GT(result.reciprocity[0].rms[0][5], 0.05);
  EXPECT_EQ(checked({structure(0.0, 3)}).verdict, ident::Verdict::clean);
}

TEST(check, names_the_one_number_that_is_off) {
  CheckedFile file = structure(0.0, 1);
  file.frfs[31](1, 4) *= 20.0;
  const ident::CheckResult result = checked({file});
  ASSERT_EQ(result.suspects.size(), 1u);
  EXPECT_EQ(ident::title(result.suspects[0]), "outlier 2:+Z, 5:+Z in S.h5");
  EXPECT_THAT(result.suspects[0].evidence, HasSubstr("2:+Z over 5:+Z at 144 Hz"));
}

/// Among 15 pairs with 2 % noise, a pair that is 12 % off leaves χ² over degrees of freedom at 2: only its own lines tell of it.
TEST(check, names_the_one_frf_that_has_a_gain_of_its_own) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CheckedFile file = structure(0.0, seed, 0.02);
    EXPECT_EQ(checked({file}).verdict, ident::Verdict::clean) << seed;
    for (Eigen::MatrixXcd& line : file.frfs) line(1, 4) *= 1.12;
    EXPECT_FALSE(ident::mirror_agreement(file).contradicts()) << seed;
    const auto pair = ident::factor_of_one_pair(file, 1.0);
    ASSERT_TRUE(pair) << seed;
    EXPECT_NEAR(pair->factor, 1.12, 5.0 * pair->deviation + 1e-3) << seed;
    const ident::CheckResult result = checked({file});
    ASSERT_EQ(result.suspects.size(), 1u) << seed;
    EXPECT_EQ(ident::title(result.suspects[0]), "gain 2:+Z, 5:+Z in S.h5");
    EXPECT_THAT(result.suspects[0].evidence, HasSubstr("one FRF: that of 2:+Z over 5:+Z is 1.1"));
    EXPECT_EQ(result.verdict, ident::Verdict::suspicious);
  }
}

TEST(check, takes_noise_of_a_few_lines_for_no_gain_of_one_frf) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CheckedFile file = structure(0.0, seed, 0.2);
    EXPECT_FALSE(ident::factor_of_one_pair(file, 1.0)) << seed;
    file.frfs.resize(5);
    file.frequency_hz.resize(5);
    EXPECT_FALSE(ident::factor_of_one_pair(file, 1.0)) << seed;
  }
}

TEST(check, names_references_and_frfs_that_are_copies) {
  CheckedFile column = structure(0.0, 1), cell = column;
  for (Eigen::MatrixXcd& line : column.frfs) line.col(4) = line.col(1).eval();
  for (Eigen::MatrixXcd& line : cell.frfs) line(3, 2) = line(0, 2);
  const auto columns = ident::find_copied_columns(column), cells = ident::find_copied_columns(cell);
  ASSERT_EQ(columns.size(), 1u);
  EXPECT_EQ(ident::title(columns[0]), "copy 2:+Z, 5:+Z in S.h5");
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(ident::title(cells[0]), "copy 1:+Z, 4:+Z in S.h5");
  EXPECT_THAT(cells[0].evidence, HasSubstr("to the reference 3:+Z"));
  EXPECT_TRUE(ident::find_copied_columns(structure(0.0, 1)).empty());
}

TEST(check, names_an_assembly_of_real_frfs_whose_parts_are_damped) {
  CheckedFile part = structure(0.0, 1);
  part.assembly = false;
  for (Eigen::MatrixXcd& line : part.frfs) line *= Complex(1.0, -0.02);
  CheckedFile whole = part;
  whole.name = "AB.h5";
  whole.assembly = true;
  EXPECT_TRUE(ident::find_real_assemblies({part, whole}).empty());
  for (Eigen::MatrixXcd& line : whole.frfs) line = line.real().cast<Complex>().eval();
  const auto found = ident::find_real_assemblies({part, whole});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(ident::title(found[0]), "quantity in AB.h5");
  EXPECT_FALSE(ident::are_all_real({part, whole}));
  for (Eigen::MatrixXcd& line : part.frfs) line = line.real().cast<Complex>().eval();
  EXPECT_TRUE(ident::find_real_assemblies({part, whole}).empty()) << "models without damping";
  EXPECT_TRUE(ident::are_all_real({part, whole}));
}

TEST(check, takes_frfs_without_noise_that_symmetry_makes_equal_for_no_copies) {
  CheckedFile file = structure(0.0, 1);
  for (Eigen::MatrixXcd& line : file.frfs) {
    line = (line + line.transpose()).eval();
    line(3, 2) = line(2, 3) = line(0, 2) = line(2, 0);
  }
  EXPECT_TRUE(ident::find_copied_columns(file).empty());
}

TEST(noise_law, is_found_from_variances_that_scatter) {
  std::mt19937_64 generator(4);
  std::gamma_distribution<double> gamma(4.0, 0.25);
  std::vector<ident::NoiseSample> samples;
  for (int i = 0; i < 4000; ++i) {
    const double square = std::pow(10.0, -3.0 + 6.0 * i / 4000.0);
    samples.push_back({(2e-4 * square + 3e-4) * gamma(generator), square, 1.0});
  }
  const auto [proportional, constant] = ident::fit_noise_law(samples);
  EXPECT_NEAR(proportional / 2e-4, 1.0, 0.06);
  EXPECT_NEAR(constant / 3e-4, 1.0, 0.06);
}

/// A part and the same with a spring to ground at 6:+Z.
std::vector<CheckedFile> part_and_assembly() {
  CheckedFile part = structure(0.0, 1, 1e-3), assembly = structure(0.0, 2, 1e-3);
  part.assembly = false;
  part.name = "A.h5";
  for (Eigen::MatrixXcd& h : assembly.frfs) {
    const Eigen::MatrixXcd force = 2e3 / (1.0 + 2e3 * h(5, 5)) * h.row(5);
    h -= (h.col(5) * force).eval();
  }
  return {part, assembly};
}

/// The sensor and the force at one point are turned, in a group of references: a mistake of a reference of the group, tried in
/// another reference, which it does not concern, changes nothing there. It once wrote beside the matrix.
TEST(group_trials, of_a_reference_that_others_lack_leave_these_alone) {
  const ident::Dofs joint = {frf::Dof::parse("6:+Z")};
  std::vector<CheckedFile> files = part_and_assembly();
  for (Eigen::MatrixXcd& h : files[1].frfs) {
    h.col(1) *= -1.0;
    for (const Eigen::Index c : {1, 2}) h(3, c) *= -1.0;
  }
  const auto setups = ident::span_setups(files, joint);
  const auto trials = ident::group_trials(files, joint, setups, ident::screen(files, setups, 1), 1);
  const auto changed = [&](const ident::MistakeTrial& trial) {
    std::vector<CheckedFile> all = files;
    trial.undo(all);
    std::vector<Eigen::Index> columns;
    for (Eigen::Index c = 0; c < 6; ++c) {
      if (!(all[1].frfs[7].col(c) - files[1].frfs[7].col(c)).isZero(0.0)) columns.push_back(c);
    }
    return columns;
  };
  std::size_t of_references = 0;
  for (const ident::MistakeTrial& trial : trials) {
    const bool one = trial.kind == SuspectKind::sign && trial.dofs.size() == 1 && trial.references.size() > 1;
    if (!one || changed(trial) != std::vector{Eigen::Index(ident::place_of(files[1].references, trial.dofs[0]))}) continue;
    ++of_references;
    for (const frf::Dof& other : files[1].references) {
      const bool own = other.same_coordinate(trial.dofs[0]);
      EXPECT_EQ(changed(trial.in_others({other})).size(), own ? 1u : 0u) << trial.what << ", tried in " << other.name();
    }
  }
  EXPECT_GT(of_references, 0u);
}

TEST(reference_groups, are_found_by_level_and_by_pairs) {
  EXPECT_THAT(ident::upper_group({1.0, 1.1, 9.0, 0.8, 12.0}), testing::ElementsAre(2, 4));
  EXPECT_THAT(ident::upper_group({1.0, 1.1, 0.9, 1.3, 1.2}), testing::IsEmpty());
  Eigen::MatrixXd cells = Eigen::MatrixXd::Constant(5, 5, 1.0);
  for (const Eigen::Index i : {1, 3}) {
    for (const Eigen::Index j : {0, 2, 4}) cells(i, j) = cells(j, i) = 30.0;
  }
  EXPECT_THAT(ident::group_that_differs(cells), testing::ElementsAre(1, 3));
  EXPECT_THAT(ident::group_that_differs(Eigen::MatrixXd::Constant(5, 5, 1.0)), testing::IsEmpty());
}

TEST(missing_points, name_the_joint_dof_without_driving_point) {
  CheckedFile part = structure(0.0, 1);
  part.assembly = false;
  const ident::Dofs joint = {frf::Dof::parse("5:+Z"), frf::Dof::parse("6:+Z"), frf::Dof::parse("101:+Z")};
  EXPECT_THAT(ident::missing_points({part}, joint), testing::IsEmpty());
  for (Eigen::MatrixXcd& line : part.frfs) line(4, 4) = Complex(std::nan(""), 0.0);
  EXPECT_THAT(ident::missing_points({part}, joint),
              testing::ElementsAre(HasSubstr("S.h5 has no driving point FRF of the joint's 5:+Z:")));
}

problems::Measurement hammered(const problems::Problem& problem, std::uint64_t seed) {
  const frf::NoiseModel noise{.kind = frf::NoiseKind::hammer, .coherence = 0.999, .reciprocal = false};
  problems::Measurement data;
  for (std::size_t i = 0; i < problem.substructures.size(); ++i)
    data.substructures.push_back(frf::polluted(problem.substructures[i], noise, seed, 0, i));
  data.assembly = frf::polluted(problem.assembly, noise, seed, 0, problem.substructures.size());
  return data;
}

/// What a set says at [line, response, reference], changed in some references.
template <class Change>
void change_columns(frf::FrfSet& set, std::size_t first, const Change& change) {
  for (std::size_t l = 0; l < set.header.lines(); ++l) {
    for (std::size_t c = first; c < set.header.reference.size(); ++c) change(l, c);
  }
}

TEST(check, undoes_a_mistake_in_some_references_alone) {
  const problems::Problem problem = problems::make("rig1");
  problems::Measurement data = hammered(problem, 1);
  frf::FrfSet& set = data.assembly;
  const std::size_t first = set.header.reference.size() / 2;
  change_columns(set, first, [&](std::size_t l, std::size_t c) {
    std::swap(set.values[set.index(l, 0, c)], set.values[set.index(l, 2, c)]);
  });
  const ident::CheckResult result = problems::check(problems::scene(problem), data);
  ASSERT_FALSE(result.suspects.empty());
  EXPECT_EQ(result.suspects[0].kind, SuspectKind::swap);
  EXPECT_TRUE(frf::has(result.suspects[0].dofs, set.header.response[0]) &&
              frf::has(result.suspects[0].dofs, set.header.response[2]));
  EXPECT_THAT(result.suspects[0].evidence, HasSubstr("for the references "));
  EXPECT_THAT(result.suspects[0].remedy, HasSubstr("\"" + set.header.reference.back().name() + "\""));
}

class FilesOfRig : public testing::Test {
 protected:
  FilesOfRig() : problem_(problems::make("rig1")), data_(hammered(problem_, 1)) {}

  void write(const frf::FrfSet& set, const std::string& name) { frf::write(set, folder_ / name); }
  void write_all() {
    for (const frf::FrfSet& set : data_.substructures) write(set, set.header.file);
    write(data_.assembly, data_.assembly.header.file);
  }
  ident::Scene scene(std::string text) const { return ident::parse_scene(text, folder_ / "rig1.toml"); }

  TestFolder folder_;
  problems::Problem problem_;
  problems::Measurement data_;
};

TEST_F(FilesOfRig, that_are_two_runs_of_the_same_numbers_are_named) {
  write_all();
  const std::string assembly = data_.assembly.header.file, again = "again.h5";
  write(data_.assembly, again);
  std::string text = problem_.scene;
  const std::string name = "\"" + assembly + "\"";
  text.replace(text.find(name), name.size(), "[" + name + ", \"" + again + "\"]");
  const ident::CheckResult result = ident::check_whole(scene(text));
  ASSERT_FALSE(result.suspects.empty());
  EXPECT_EQ(ident::title(result.suspects[0]), "copy in again.h5");
  EXPECT_THAT(result.suspects[0].evidence, HasSubstr("are the same numbers"));
  data_.assembly.values[3] *= 1.001;
  write(data_.assembly, again);
}

TEST_F(FilesOfRig, that_no_joint_of_the_scene_explains_are_not_clean) {
  write_all();
  EXPECT_TRUE(ident::check_whole(scene(problem_.scene)).suspects.empty());
  std::string text = problem_.scene;
  const std::size_t damping = text.find("[joint.hysteretic_damping]"), next = text.find("\n[", damping + 1);
  ASSERT_NE(next, std::string::npos);
  text.erase(damping, next - damping + 1);
  const ident::CheckResult result = ident::check_whole(scene(text));
  ASSERT_EQ(result.suspects.size(), 1u);
  EXPECT_EQ(result.suspects[0].kind, SuspectKind::nonlinear);
  EXPECT_THAT(result.suspects[0].evidence, HasSubstr("mass at the joint"));
}

/// What noise of the force's signal of this size relative to it does to H1 of `averages`, and to the coherences.
void add_force_noise(frf::FrfSet& set, double noise, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal(0.0, noise / std::sqrt(2.0 * set.header.averages));
  for (std::size_t l = 0; l < set.header.lines(); ++l) {
    for (std::size_t c = 0; c < set.header.reference.size(); ++c) {
      const Complex factor = (1.0 - noise * noise) * (1.0 + Complex(normal(generator), normal(generator)));
      for (std::size_t r = 0; r < set.header.response.size(); ++r) {
        const std::size_t at = set.index(l, r, c);
        set.values[at] *= factor;
        set.coherence[at] = 1.0 / (1.0 / set.coherence[at] + noise * noise);
      }
    }
  }
}

TEST_F(FilesOfRig, whose_force_is_noisy_are_named_with_what_the_coherences_leave_of_h1) {
  std::uint64_t seed = 1;
  for (frf::FrfSet& set : data_.substructures) add_force_noise(set, 0.14, seed++);
  add_force_noise(data_.assembly, 0.14, seed);
  write_all();
  const ident::CheckResult result = ident::check_whole(scene(problem_.scene));
  ASSERT_FALSE(result.suspects.empty());
  for (const ident::Suspect& suspect : result.suspects) {
    EXPECT_EQ(suspect.kind, SuspectKind::force_noise);
    EXPECT_THAT(suspect.evidence, testing::ContainsRegex("too low by up to (1\\.[2-9]|2|2\\.[0-8]) %"));
  }
}

TEST_F(FilesOfRig, with_lines_that_contradict_all_others_are_named) {
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal;
  for (const std::size_t l : {100UL, 101UL, 250UL}) {
    for (std::size_t at = data_.assembly.index(l, 0, 0); at < data_.assembly.index(l + 1, 0, 0); ++at) {
      data_.assembly.values[at] *= Complex(1.0 + normal(generator), normal(generator));
      data_.assembly.coherence[at] = 0.3;
    }
  }
  write_all();
  const ident::CheckResult result = ident::check_whole(scene(problem_.scene));
  ASSERT_EQ(result.suspects.size(), 1u);
  EXPECT_EQ(result.suspects[0].kind, SuspectKind::outlier);
  EXPECT_TRUE(result.suspects[0].dofs.empty());
  EXPECT_THAT(result.suspects[0].evidence, HasSubstr(" lines, at "));
}

/// Of a hit's FRF to 1e135 the file, the DOFs, the line and the value, and the joint as without that line.
TEST_F(FilesOfRig, with_a_value_that_no_structure_has_are_solved_without_its_line) {
  const std::size_t line = 200, at = data_.assembly.index(line, 2, 5);
  data_.assembly.values[at] = 1e135 / std::pow(2.0 * M_PI * data_.assembly.header.frequency_hz[line], 2);  // an accelerance
  const frf::FrfHeader& header = data_.assembly.header;
  for (const char* method : {"likelihood", "one"}) {
    write_all();
    std::string text = problem_.scene;
    const std::size_t key = text.find("method");
    text.replace(key, text.find('\n', key) - key, "method = \"" + std::string(method) + "\"");
    const auto plan = ident::make_plan(scene(text));
    ident::Control control;
    control.judgement = ident::Judgement::data;
    const std::size_t lines = plan->lines.size();
    const ident::Solution found = ident::solve(*plan, control);
    EXPECT_EQ(found.status, ident::Status::doubtful) << method;
    EXPECT_EQ(found.fit.lines + 1, lines) << method;
    EXPECT_THAT(found.message, HasSubstr(header.response[2].name() + " over " + header.reference[5].name() + " in " +
                                         std::filesystem::path(header.file).filename().string()));
    EXPECT_THAT(found.message, HasSubstr("1e+135"));
    const double error = std::abs(found.unknowns[0].value / problem_.unknowns[0].value - 1.0);
    EXPECT_LT(error, std::string(method) == "one" ? 0.5 : 0.05) << method;
  }
}

TEST_F(FilesOfRig, a_gain_of_all_frfs_of_one_percent_is_named) {
  for (Complex& value : data_.assembly.values) value *= 1.01;
  const ident::CheckResult result = problems::check(problems::scene(problem_), data_);
  ASSERT_FALSE(result.suspects.empty());
  EXPECT_EQ(ident::title(result.suspects[0]), "gain in " + data_.assembly.header.file);
}

TEST(rigid_body_mass, is_read_off_three_lines_above_0_hz) {
  CheckedFile file;
  file.responses = file.references = {frf::Dof::parse("1:+Z"), frf::Dof::parse("2:+Z")};
  for (double hz = 0.0; hz <= 10.0; hz += 1.0) {
    file.frequency_hz.push_back(hz);
    file.frfs.push_back(Eigen::MatrixXcd::Constant(2, 2, -1.0 / (2.5 * std::pow(2.0 * M_PI * hz, 2))));
  }
  const auto mass = ident::rigid_body_mass(file);
  ASSERT_TRUE(mass);
  EXPECT_NEAR(*mass, 2.5, 1e-9);
}

TEST(other_causes, are_those_that_the_scene_leaves_open) {
  ident::Scene scene = problems::scene(problems::make("rig1"));
  EXPECT_THAT(ident::other_causes(scene), HasSubstr("mass at the joint"));
  scene.joints.front().matrices[restrictions::Kind::mass] = restrictions::Pattern::symmetric;
  EXPECT_THAT(ident::other_causes(scene), testing::Not(HasSubstr("mass at the joint")));
}

}  // namespace
