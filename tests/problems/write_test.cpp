#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "frf/uff/uff_file.hpp"
#include "problems/problem.hpp"
#include "tests/test_folder.hpp"

namespace jointid::problems {
namespace {

namespace fs = std::filesystem;

class Write : public testing::Test {
 protected:
  std::string text(const std::string& name) const {
    std::ifstream in(folder_ / name);
    std::stringstream content;
    content << in.rdbuf();
    return content.str();
  }

  TestFolder folder_;
};

/// A factor −ω² away from receptance and back costs a few roundings.
void expect_same_values(const frf::FrfSet& found, const frf::FrfSet& expected) {
  ASSERT_EQ(found.values.size(), expected.values.size());
  for (std::size_t i = 0; i < expected.values.size(); ++i) {
    ASSERT_LE(std::abs(found.values[i] - expected.values[i]), 1e-14 * std::abs(expected.values[i]));
  }
}

TEST_F(Write, MakesTheFolderTheDataTheSceneAndTheTruth) {
  const Problem problem = make("A9");
  EXPECT_EQ(write(problem, folder_ / "deep", {.seed = 4}), folder_ / "deep" / "A9.toml");
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "deep")) {
    names.push_back(entry.path().filename().string());
  }
  EXPECT_THAT(names, testing::UnorderedElementsAre("A9.toml", "truth.json", "A9_substructure_1.h5",
                                                   "A9_substructure_2.h5", "A9_assembly.h5"));
  EXPECT_EQ(text("deep/A9.toml"), problem.scene);
  const frf::FrfSet assembly = frf::load(*frf::open_hdf5(folder_ / "deep" / "A9_assembly.h5"));
  expect_same_values(assembly, polluted(problem, 4, 0).assembly);
  EXPECT_EQ(assembly.header.nodes.size(), 7U);
}

TEST_F(Write, CleanDataAreExactAndCarryNoNoiseRecord) {
  const Problem problem = make("rig1");
  write(problem, folder_, {.clean = true});
  const frf::FrfSet part = frf::load(*frf::open_hdf5(folder_ / "rig1_substructure_2.h5"));
  EXPECT_EQ(part.header.quantity, frf::Quantity::accelerance);
  EXPECT_EQ(part.header.noise, frf::NoiseRecord::none);
  expect_same_values(part, problem.substructures[1]);
}

TEST_F(Write, ARigCarriesTheCoherenceOfItsHammerTest) {
  write(make("rig1"), folder_, {});
  const frf::FrfSet part = frf::load(*frf::open_hdf5(folder_ / "rig1_substructure_1.h5"));
  EXPECT_EQ(part.header.noise, frf::NoiseRecord::coherence);
  EXPECT_EQ(part.header.averages, 5.0);
  EXPECT_THAT(part.coherence, testing::Each(testing::AllOf(testing::Gt(0.0), testing::Le(1.0))));
}

TEST_F(Write, UniversalFilesHoldTheSameAndTheSceneNamesThem) {
  for (const char* name : {"B", "rig1"}) {
    const Problem problem = make(name);
    write(problem, folder_, {.format = "uff", .seed = 2});
    const std::string stem = std::string(name) + "_substructure_1";
    EXPECT_THAT(text(std::string(name) + ".toml"),
                testing::AllOf(testing::HasSubstr(stem + ".uff"), testing::Not(testing::HasSubstr(".h5"))));
    const frf::FrfSet found = frf::load(*frf::open_uff(folder_ / (stem + ".uff")));
    const frf::FrfSet expected = polluted(problem, 2, 0).substructures[0];
    EXPECT_EQ(found.header.quantity, expected.header.quantity);
    EXPECT_EQ(found.header.response, expected.header.response);
    expect_same_values(found, expected);
    EXPECT_EQ(found.coherence, expected.coherence);
  }
}

TEST_F(Write, TheTruthHasNamesValuesMatricesAndNaturalFrequencies) {
  write(make("A9"), folder_, {});
  const auto truth = nlohmann::json::parse(text("truth.json"));
  EXPECT_EQ(truth["dofs"], nlohmann::json({"4:+Y", "4:+RZ", "5:+Y", "5:+RZ"}));
  EXPECT_EQ(truth["unknowns"].size(), 8U);
  EXPECT_EQ(truth["unknowns"][0]["name"], "K.a");
  EXPECT_NEAR(truth["unknowns"][0]["value"].get<double>(), 662400.0, 1e-6);
  EXPECT_NEAR(truth["matrices"]["hysteretic_damping"][1][3].get<double>(), 9.936, 1e-12);
  EXPECT_NEAR(truth["natural_frequencies_hz"]["substructures"][1][2].get<double>(), 179.848, 5e-4);
  EXPECT_EQ(truth["natural_frequencies_hz"]["assembly"].size(), 14U);
}

TEST_F(Write, AnUnknownFormatIsAnErrorBeforeAnythingIsWritten) {
  EXPECT_THROW(write(make("A1"), folder_ / "new", {.format = "mat"}), InputError);
  EXPECT_FALSE(fs::exists(folder_ / "new"));
}

TEST_F(Write, AFolderThatCannotBeMadeIsAnError) {
  std::ofstream(folder_ / "taken") << "a file where the folder should be";
  EXPECT_THROW(write(make("A1"), folder_ / "taken", {}), InputError);
}

}  // namespace
}  // namespace jointid::problems
