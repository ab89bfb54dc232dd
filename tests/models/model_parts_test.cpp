#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "ident/check/check.hpp"
#include "ident/identify.hpp"
#include "ident/plan/data_source.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/scene/scene_files.hpp"
#include "ident/scene/variance_origin.hpp"
#include "problems/problem.hpp"
#include "scene/text.hpp"
#include "study/trial_runner.hpp"
#include "tasks/couple.hpp"
#include "tests/models/model_sample.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

using ::testing::HasSubstr;

/// A1, whose second part is a model as well: b.toml beside the files.
class ModelParts : public testing::Test {
 protected:
  ModelParts() {
    const problems::Structure part = problems::substructure_b();
    models::write_market(folder_ / "m.mtx", models::sparse_matrix(part, problems::Kind::mass));
    models::write_market(folder_ / "k.mtx", models::sparse_matrix(part, problems::Kind::stiffness));
    describe("b.toml", "");
  }

  void describe(const std::string& name, const std::string& more) const {
    models::write_text(folder_ / name, "mass = \"m.mtx\"\nstiffness = \"k.mtx\"\nloss_factor = 0.001\n" + more +
                                           "dofs = " + models::dof_list(problems::substructure_b().dofs()) + "\n");
  }

  /// The text of the scene of A1, which is written.
  std::string a1(bool clean, const std::string& method = {}) const {
    return scene::read_text(
        problems::write(problems::make("A1"), folder_, {.format = "h5", .seed = 1, .method = method, .clean = clean}));
  }

  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error(from + " is not in " + text);
    return text.replace(at, from.size(), to);
  }

  std::string hybrid(const std::string& text) const { return replaced(text, "A1_substructure_2.h5", "b.toml"); }

  Scene read(const std::string& text) const { return parse_scene(text, folder_ / "scene.toml"); }

  TestFolder folder_;
};

void expect_same(const Solution& found, const Solution& expected, double tolerance) {
  ASSERT_EQ(found.unknowns.size(), expected.unknowns.size());
  double largest = 0.0;
  for (const Estimate& unknown : expected.unknowns) largest = std::max(largest, std::abs(unknown.value));
  for (std::size_t u = 0; u < found.unknowns.size(); ++u) {
    EXPECT_NEAR(found.unknowns[u].value, expected.unknowns[u].value, tolerance * largest) << expected.unknowns[u].name;
  }
}

TEST_F(ModelParts, HaveTheFrfsOfTheFile) {
  const Scene scene = read(a1(true)), with_model = read(hybrid(a1(true)));
  const OpenedScene files = open_scene(scene), models = open_scene(with_model);
  const frf::FrfSet expected = frf::load(*files.substructures[1]), found = frf::load(*models.substructures[1]);
  EXPECT_EQ(found.header.frequency_hz, expected.header.frequency_hz);
  ASSERT_EQ(found.header.response, expected.header.response);
  double largest = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    largest = std::max(largest, std::abs(expected.values[i]));
    worst = std::max(worst, std::abs(found.values[i] - expected.values[i]));
  }
  EXPECT_LE(worst, 1e-12 * largest);
}

TEST_F(ModelParts, GiveTheSolutionOfTheFiles) {
  const std::string text = a1(true);
  const auto files = make_plan(read(text)), models = make_plan(read(hybrid(text)));
  EXPECT_EQ(models->lines.size(), files->lines.size());
  const Solution expected = solve(*files), found = solve(*models);
  EXPECT_EQ(found.status, Status::ok) << found.message;
  expect_same(found, expected, 1e-9);
}

TEST_F(ModelParts, WithMeasuredOnesIdentifyTheJoint) {
  const auto plan = make_plan(read(hybrid(a1(false, "likelihood"))));
  const Solution found = solve(*plan);
  EXPECT_TRUE(found.status == Status::ok || found.status == Status::doubtful) << found.message;
  ASSERT_EQ(found.variances.size(), 3u);
  EXPECT_EQ(found.variances[1].origin, phrase(VarianceOrigin::model));
  const problems::Problem problem = problems::make("A1");
  double squares = 0.0;
  std::size_t stiffnesses = 0;
  for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
    ASSERT_TRUE(found.unknowns[u].std_error);
    if (problem.unknowns[u].name[0] != 'K') continue;
    squares += std::pow((found.unknowns[u].value - problem.unknowns[u].value) / *found.unknowns[u].std_error, 2);
    ++stiffnesses;
  }
  EXPECT_LE(squares, 30.0);  // χ² of 10 degrees of freedom: 0.999 quantile 29.6
  EXPECT_EQ(stiffnesses, 10u);
}

TEST_F(ModelParts, AreCheckedBesideMeasuredOnes) { EXPECT_TRUE(check_scene(read(hybrid(a1(false))), {}).suspects.empty()); }

TEST_F(ModelParts, AloneHaveTheLinesOfTheOtherSystem) {
  describe("only.toml", "");
  const std::string text = replaced(hybrid(a1(true)), "\"A1_substructure_1.h5\", ", "");
  const OpenedScene opened = open_scene(read(text));
  EXPECT_EQ(opened.substructures.at(0)->header().frequency_hz, opened.assembly.at(0)->header().frequency_hz);
}

TEST_F(ModelParts, AloneNeedLinesOfTheScene) {
  Scene scene = read(a1(true));
  scene.data.substructures = {{folder_ / "b.toml", {}}};
  scene.data.assembly = {{folder_ / "c.toml", {}}};
  describe("c.toml", "");
  scene.frequency = {};
  try {
    open_scene(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("give range and step"));
  }
  scene.frequency.range_hz = Range{10.0, 11.0};
  scene.frequency.step_hz = 0.25;
  const std::vector<double> expected = {10.0, 10.25, 10.5, 10.75, 11.0};
  EXPECT_EQ(open_scene(scene).assembly.at(0)->header().frequency_hz, expected);
}

TEST_F(ModelParts, TakeCorrectionsAndNoKeysOfMeasurements) {
  const std::string text = hybrid(a1(true));
  const auto frf = [&](const std::string& keys) {
    const OpenedScene opened = open_scene(read(text + "\n[data.files.\"b.toml\"]\n" + keys));
    return frf::load(*opened.substructures.at(1));
  };
  const frf::FrfSet plain = frf("gain = 1.0"), renamed = frf("rename = { \"7:+Y\" = \"9:+Y\" }\nfrequency_scale = 1.01");
  EXPECT_EQ(renamed.header.response[4].name(), "9:+Y");
  EXPECT_NEAR(renamed.header.frequency_hz[3], plain.header.frequency_hz[3], 1e-9);
  EXPECT_THROW(frf("quantity = \"mobility\""), InputError);
  EXPECT_THROW(open_scene(read(replaced(a1(true), "\"A1_substructure_2.h5\"", "[\"A1_substructure_2.h5\", \"b.toml\"]"))),
               InputError);
}

TEST_F(ModelParts, TellWhichFilesTheyRead) {
  std::vector<std::string> names;
  for (const NamedFile& file : files_of(read(hybrid(a1(true))))) names.push_back(file.path.filename().string());
  EXPECT_THAT(names, testing::ElementsAre("scene.toml", "A1_substructure_1.h5", "b.toml", "m.mtx", "k.mtx", "A1_assembly.h5"));
}

TEST_F(ModelParts, AreCoupled) {
  a1(true);
  const auto result = [&](const std::string& part) {
    const std::string text =
        "[data]\nparts = [\"A1_substructure_1.h5\", \"" + part +
        "\"]\n[couple]\njoin = [[\"4:+Y\", \"5:+Y\"], [\"4:+RZ\", \"5:+RZ\"]]\nkeep = [\"1:+Y\", \"7:+Y\"]\n";
    const auto coupled = tasks::couple(parse_couple_scene(text, folder_ / "couple.toml"), folder_ / "out.h5", false, {});
    const bool is_model = part == "b.toml";
    EXPECT_EQ(coupled.models.size(), is_model ? 1u : 0u);
    if (is_model) {
      EXPECT_EQ(coupled.models.at(0).use.way, models::ModelWay::full);
      EXPECT_EQ(coupled.models.at(0).use.factorizations, coupled.lines);
    }
    return frf::load(*frf::open_hdf5(folder_ / "out.h5"));
  };
  const frf::FrfSet expected = result("A1_substructure_2.h5"), found = result("b.toml");
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    EXPECT_LE(std::abs(found.values[i] - expected.values[i]), 1e-8 * std::abs(expected.values[i]));
  }
}

TEST_F(ModelParts, AreDrawnByTheirOwnNoiseInStudies) {
  describe("noisy.toml", "noise = 0.01\n");
  const auto trial = [&](const std::string& part) {
    const std::string text = replaced(hybrid(a1(true)), "b.toml", part);
    study::TrialRunner runner(study::load_trial_data(read(text)));
    runner.run(1, 0);
    return std::pair(runner.measurements().substructures.at(0).values, runner.measurements().substructures.at(1).values);
  };
  const auto [measured, exact] = trial("b.toml");
  const auto [same, noisy] = trial("noisy.toml");
  EXPECT_EQ(measured, same);
  double squares = 0.0, count = 0.0;
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    if (exact[i] == Complex(0.0)) continue;  // by symmetry, at the middle of the part
    squares += std::norm(noisy[i] / exact[i] - 1.0);
    count += 1.0;
  }
  EXPECT_NEAR(std::sqrt(squares / count), 0.01, 0.001);
}

}  // namespace
}  // namespace jointid::ident
