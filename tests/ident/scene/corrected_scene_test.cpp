#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "ident/identify.hpp"
#include "ident/plan/data_source.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/scene/scene_files.hpp"
#include "problems/case/coupling_problem.hpp"
#include "problems/problem.hpp"
#include "problems/vibration/rig_two.hpp"
#include "study/trial_data.hpp"
#include "tasks/couple.hpp"
#include "tasks/equivalent.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A mistake in one file of a problem, and the keys that mend it.
struct Mistake {
  std::string name, file, keys;
  std::function<void(frf::FrfSet&)> plant;
};

/// Multiplies what `factor` (frequency in Hz, response, reference) says.
std::function<void(frf::FrfSet&)> times(const std::function<Complex(double, const std::string&, const std::string&)>& factor) {
  return [=](frf::FrfSet& set) {
    for (std::size_t i = 0; i < set.values.size(); ++i) {
      const std::size_t entry = i % set.header.entries(), columns = set.header.reference.size();
      set.values[i] *= factor(set.header.frequency_hz[i / set.header.entries()], set.header.response[entry / columns].name(),
                              set.header.reference[entry % columns].name());
    }
  };
}

const std::string part = "A1_substructure_1.h5", whole = "A1_assembly.h5";

std::vector<Mistake> mistakes() {
  return {
      {"flip", whole, "flip = [\"2:+Y\"]",
       times([](double, const std::string& r, const std::string&) { return r == "2:+Y" ? -1.0 : 1.0; })},
      {"flip_reference", part, "flip_reference = [\"4:+RZ\"]",
       times([](double, const std::string&, const std::string& c) { return c == "4:+RZ" ? -1.0 : 1.0; })},
      {"gain", whole, "gain = { \"2:+Y\" = 1.25 }",
       times([](double, const std::string& r, const std::string&) { return r == "2:+Y" ? 0.8 : 1.0; })},
      {"gain_reference", whole, "gain_reference = { \"4:+Y\" = 1.25 }",
       times([](double, const std::string&, const std::string& c) { return c == "4:+Y" ? 0.8 : 1.0; })},
      {"unit", whole, "gain = 9.80665", times([](double, const std::string&, const std::string&) { return 1.0 / 9.80665; })},
      {"delay", part, "delay = 20e-6", times([](double f, const std::string&, const std::string&) {
         return std::polar(1.0, -2.0 * std::numbers::pi * f * 20e-6);
       })},
      {"conjugate", whole, "conjugate = true",
       [](frf::FrfSet& set) {
         for (Complex& value : set.values) value = std::conj(value);
       }},
      {"rename", whole, "rename = { \"2:+Y\" = \"5:+Y\", \"5:+Y\" = \"2:+Y\" }",
       [](frf::FrfSet& set) {
         const std::size_t two = frf::find_coordinate(set.header.response, frf::Dof::parse("2:+Y"));
         const std::size_t five = frf::find_coordinate(set.header.response, frf::Dof::parse("5:+Y"));
         std::swap(set.header.response[two], set.header.response[five]);
       }},
      {"frequency_scale", whole, "frequency_scale = 0.8",
       [](frf::FrfSet& set) {
         for (double& frequency : set.header.frequency_hz) frequency /= 0.8;
       }},
      {"quantity", part, "quantity = \"receptance\"",
       times([](double f, const std::string&, const std::string&) { return frf::to_receptance(frf::Quantity::accelerance, f); })},
  };
}

class CorrectedScene : public testing::Test {
 protected:
  /// Writes the problem without noise and returns its scene with more text.
  Scene scene_with(const std::string& problem, const std::string& more) const {
    const fs::path file = problems::write(problems::make(problem), folder_, {.format = "h5", .seed = 1, .clean = true});
    std::ofstream(file, std::ios::app) << more;
    return read_scene(file);
  }

  void change(const std::string& file, const std::function<void(frf::FrfSet&)>& plant, frf::Quantity stored) const {
    frf::FrfSet set = frf::load(*frf::open_hdf5(folder_ / file));
    plant(set);
    frf::write_hdf5(set, folder_ / file, {.quantity = stored});
  }

  TestFolder folder_;
};

std::string files_table(const std::string& file, const std::string& keys) { return "\n[data.files.\"" + file + "\"]\n" + keys + "\n"; }

/// Of all elements, relative; no element of the truth is zero.
double largest_error(const Solution& solution, const Scene& scene) {
  double worst = 0.0;
  for (const auto& [kind, matrix] : solution.bands.front().matrices) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      for (std::size_t j = 0; j < matrix.size(); ++j) worst = std::max(worst, std::abs(matrix[i][j] / scene.truth.at(kind)[i][j] - 1.0));
    }
  }
  return worst;
}

TEST_F(CorrectedScene, EveryMistakeIsMendedByItsKeys) {
  for (const Mistake& mistake : mistakes()) {
    SCOPED_TRACE(mistake.name);
    const Scene scene = scene_with("A1", files_table(mistake.file, mistake.keys));
    change(mistake.file, mistake.plant, mistake.name == "quantity" ? frf::Quantity::accelerance : frf::Quantity::receptance);
    const auto plan = make_plan(scene);
    EXPECT_LE(largest_error(solve(*plan), scene), 1e-5);
    EXPECT_THAT(plan->notes, testing::Contains(HasSubstr(mistake.file + " is corrected on reading: ")));
    Scene without = scene;
    for (auto* files : {&without.data.substructures, &without.data.assembly}) {
      for (DataFile& file : *files) file.options = {}, file.corrections = {};
    }
    if (mistake.name == "frequency_scale") continue;  // no line is common
    EXPECT_GE(largest_error(solve(*make_plan(without)), scene), 1e-4);
  }
}

/// The 3 g of the roving accelerometer in the data of rig1-accelerometer. Its files have the window's decay in them (s = 8 + iω),
/// in which the mass acts by s²m, so that a rest is left.
TEST_F(CorrectedScene, TheMassOfTheRovingAccelerometerIsRemoved) {
  const problems::Problem problem = problems::make("rig1-accelerometer");
  std::string keys = "sensor_mass = { ";
  for (const char* node : {"101", "107", "113", "119", "125", "126"}) keys += "\"" + std::string(node) + ":+Y\" = 0.003, ";
  std::string of_other = "sensor_mass = { ", of_both = keys;
  for (const char* node : {"201", "202", "207", "212", "217", "222"}) {
    of_other += "\"" + std::string(node) + ":+Y\" = 0.003, ";
    of_both += "\"" + std::string(node) + ":+Y\" = 0.003, ";
  }
  const auto closed = [](std::string text) { return text.substr(0, text.size() - 2) + " }"; };
  const std::string name = "rig1-accelerometer_";
  const Scene loaded = scene_with("rig1-accelerometer", "");
  const double before = largest_error(solve(*make_plan(loaded)), loaded);
  const Scene scene = scene_with("rig1-accelerometer", files_table(name + "substructure_1.h5", closed(keys)) +
                                                           files_table(name + "substructure_2.h5", closed(of_other)) +
                                                           files_table(name + "assembly.h5", closed(of_both)));
  const double after = largest_error(solve(*make_plan(scene)), scene);
  EXPECT_GE(before, 0.05);
  EXPECT_LE(after, 0.1 * before);
}

TEST_F(CorrectedScene, TrialsBeginWithTheMendedFrfs) {
  const Scene clean = scene_with("A1", "");
  const auto expected = study::load_trial_data(clean);
  for (const Mistake& mistake : mistakes()) {
    if (mistake.name != "flip" && mistake.name != "delay") continue;
    const Scene scene = scene_with("A1", files_table(mistake.file, mistake.keys));
    change(mistake.file, mistake.plant, frf::Quantity::receptance);
    const auto data = study::load_trial_data(scene);
    for (std::size_t s = 0; s < 2; ++s) {
      for (std::size_t i = 0; i < data->base.substructures[s].values.size(); ++i) {
        const Complex right = expected->base.substructures[s].values[i];
        ASSERT_LE(std::abs(data->base.substructures[s].values[i] - right), 1e-13 * std::abs(right));
      }
    }
    for (std::size_t i = 0; i < data->base.assembly[0].values.size(); ++i) {
      const Complex right = expected->base.assembly[0].values[i];
      ASSERT_LE(std::abs(data->base.assembly[0].values[i] - right), 1e-13 * std::abs(right));
    }
  }
}

TEST_F(CorrectedScene, PartsAreMendedBeforeTheyAreCoupled) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-B");
  const fs::path file = problems::write(problem, folder_, {.format = "h5", .seed = 1, .clean = true});
  const std::string first = read_couple_scene(file).parts.front().path.filename();
  std::ofstream(file, std::ios::app) << files_table(first, "conjugate = true");
  change(first, [](frf::FrfSet& set) {
    for (Complex& value : set.values) value = std::conj(value);
  }, frf::Quantity::receptance);
  tasks::couple(read_couple_scene(file), folder_ / "out.h5", false);
  const frf::FrfSet found = frf::load(*frf::open_hdf5(folder_ / "out.h5"));
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    ASSERT_LT(std::abs(found.values[i] - problem.assembly.values[i]), 1e-9 * std::abs(problem.assembly.values[i]));
  }
}

TEST_F(CorrectedScene, LevelsOfAnEquivalentJointAreMended) {
  const fs::path file = problems::write(problems::make_rig_two("rig2"), folder_, {.format = "h5", .seed = 1, .clean = true});
  const EquivalentScene scene = read_equivalent_scene(file);
  const auto expected = tasks::find_equivalent(scene);
  const std::string level = scene.levels[1].assembly.path.filename();
  const frf::FrfSet right = frf::load(*frf::open_hdf5(folder_ / level));
  change(level, times([](double, const std::string&, const std::string&) { return 1e-3; }), right.header.quantity);
  std::ofstream(file, std::ios::app) << files_table(level, "gain = 1000.0");
  const auto found = tasks::find_equivalent(read_equivalent_scene(file));
  EXPECT_NEAR(found[1].joint.stiffness, expected[1].joint.stiffness, 1e-9 * std::abs(expected[1].joint.stiffness));
}

/// A1 in memory of disk: what the plan warns of.
std::vector<std::string> warnings_of(const Scene& scene) { return make_plan(scene)->warnings; }

TEST_F(CorrectedScene, ASceneWithoutMistakesIsNotWarnedOf) {
  const Scene scene = scene_with("A1", "");
  EXPECT_THAT(warnings_of(scene), IsEmpty());
  EXPECT_THAT(make_plan(scene)->notes, IsEmpty());
  EXPECT_THAT(solve(*make_plan(scene)).warnings, IsEmpty());
}

TEST_F(CorrectedScene, ALabelWithoutCounterpartIsSaid) {
  const Scene scene = scene_with("A1", "");
  change(whole, [](frf::FrfSet& set) {
    for (auto* dofs : {&set.header.response, &set.header.reference}) {
      (*dofs)[frf::find_coordinate(*dofs, frf::Dof::parse("2:+Y"))] = frf::Dof::parse("12:+Y");
    }
  }, frf::Quantity::receptance);
  EXPECT_THAT(warnings_of(scene), ElementsAre(HasSubstr("No substructure has 12:+Y of the assembly: not used")));
  EXPECT_THAT(make_plan(scene)->notes, ElementsAre(HasSubstr("The assembly does not have 2:+Y of the substructures")));
  EXPECT_THAT(solve(*make_plan(scene)).warnings, ElementsAre(HasSubstr("12:+Y")));
}

TEST_F(CorrectedScene, AxesThatDifferSlightlyAreSaid) {
  const auto stretched = [this](double factor) {
    const Scene scene = scene_with("A1", "");
    change(whole, [=](frf::FrfSet& set) {
      for (double& frequency : set.header.frequency_hz) frequency *= factor;
    }, frf::Quantity::receptance);
    Scene open = scene;
    open.frequency.range_hz = Range{390.0, 1010.0};
    return warnings_of(open);
  };
  EXPECT_THAT(stretched(1.0001), ElementsAre(AllOf(HasSubstr("are taken for the same line, 0.01 % apart"), HasSubstr("frequency_scale"))));
  EXPECT_THAT(stretched(1.00003), IsEmpty());
}

TEST_F(CorrectedScene, OneLineForAllUnknownsIsSaid) {
  Scene scene = scene_with("A1", "");
  scene.frequency.range_hz = Range{450.0, 465.0};
  EXPECT_THAT(warnings_of(scene), ElementsAre(HasSubstr("All 20 unknowns come from one frequency line, 460 Hz")));
}

TEST_F(CorrectedScene, JointDofsOnOneSideOnlyAreAnError) {
  Scene scene = scene_with("A1", "");
  scene.truth.clear();
  scene.joints.front().dofs = {frf::Dof::parse("4:+Y"), frf::Dof::parse("4:+RZ")};
  try {
    make_plan(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_THAT(error.what(), AllOf(HasSubstr("[joint] dofs: none of them is in "), HasSubstr("A1_substructure_2.h5"),
                                    HasSubstr("both sides")));
  }
}

TEST_F(CorrectedScene, VariancesThatAStudyDoesNotUseAreSaid) {
  const fs::path file = problems::write(problems::make("rig1"), folder_, {});
  EXPECT_THAT(study::load_trial_data(read_scene(file))->notes, IsEmpty());
  std::ofstream(file, std::ios::app) << "\n[noise]\nmodel = \"circular\"\nlevel = 0.01\n";
  EXPECT_THAT(study::load_trial_data(read_scene(file))->notes,
              ElementsAre(AllOf(HasSubstr("Trials draw their errors from [noise] (circular)"),
                                HasSubstr("rig1_assembly.h5 are not used"))));
}

/// Positions of [data] nodes stand before those of the files; one file may have its own.
TEST(NodesOfScene, StandBeforeThoseOfTheFiles) {
  const TestFolder folder;
  const auto put = [&](const char* name, const std::string& text) { std::ofstream(folder / name) << text; };
  const std::string numbers = "10,1e-6,0\n20,1e-6,0\n";
  put("part.csv", "# node 4 = 7 7 7\n# quantity = receptance\nFrequency [Hz],4:+Y/4:+Y re [m/N],4:+Y/4:+Y im [m/N]\n" + numbers);
  put("whole.csv", "# quantity = receptance\nFrequency [Hz],4:+Y/5:+Y re [m/N],4:+Y/5:+Y im [m/N]\n" + numbers);
  put("nodes.csv", "node,x [mm],y [mm],z [mm]\n4,900,0,0\n5,0,100,0\n");
  put("other.csv", "node,x,y,z\n5,0,0,3\n");
  const std::string data = "[data]\nsubstructures = [\"part.csv\"]\nassembly = [\"whole.csv\"]\nnodes = \"nodes.csv\"\n";
  const std::string joint = "[joint]\ndofs = [\"4:+Y\"]\nstiffness = { pattern = \"symmetric\" }\n";
  const auto position = [&](const std::string& text, bool assembly, std::int64_t node) {
    const Scene scene = parse_scene(text, folder / "scene.toml");
    const Sources sources = open_all(assembly ? scene.data.assembly : scene.data.substructures);
    const auto& nodes = sources.front()->header().nodes;
    const auto found = std::ranges::find(nodes, node, &frf::Node::id);
    return found == nodes.end() ? std::array<double, 3>{-1.0, -1.0, -1.0} : found->position;
  };
  EXPECT_THAT(position(data + joint, false, 4), ElementsAre(0.9, 0.0, 0.0)) << "not that of the file";
  EXPECT_THAT(position(data + joint, true, 5), ElementsAre(0.0, 0.1, 0.0));
  const std::string own = data + "[data.files.\"whole.csv\"]\nnodes = \"other.csv\"\n" + joint;
  EXPECT_THAT(position(own, true, 5), ElementsAre(0.0, 0.0, 3.0));
  EXPECT_THAT(position(own, true, 4), ElementsAre(-1.0, -1.0, -1.0)) << "its own file has no node 4";
  EXPECT_THAT(position(own, false, 4), ElementsAre(0.9, 0.0, 0.0));
  std::vector<std::string> places;
  for (const NamedFile& file : files_of(parse_scene(own, folder / "scene.toml"))) places.push_back(file.path.filename().string());
  EXPECT_THAT(places, testing::UnorderedElementsAre("scene.toml", "part.csv", "whole.csv", "nodes.csv", "other.csv"))
      << "none is overwritten";
}

}  // namespace
}  // namespace jointid::ident
