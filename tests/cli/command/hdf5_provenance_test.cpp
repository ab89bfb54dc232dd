// HDF5 results state how they were made, in the root attribute `provenance`.
#include <gmock/gmock.h>
#include <hdf5.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "input_folder.hpp"
#include "run_command.hpp"

namespace jointid::cli {
namespace {

using nlohmann::json;

json provenance_of(const std::filesystem::path& path) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  EXPECT_GE(file, 0) << path;
  if (H5Aexists(file, "provenance") <= 0) {
    H5Fclose(file);
    return nullptr;
  }
  const hid_t attribute = H5Aopen(file, "provenance", H5P_DEFAULT), type = H5Aget_type(attribute);
  char* text = nullptr;
  H5Aread(attribute, type, &text);
  const json found = json::parse(text);
  H5free_memory(text);
  H5Tclose(type);
  H5Aclose(attribute);
  H5Fclose(file);
  return found;
}

void expect_sums(const InputFolder& folder, const json& told, const std::vector<std::string>& files) {
  std::vector<std::string> names;
  for (const json& input : told.at("inputs")) {
    names.push_back(std::filesystem::path(input.at("file").get<std::string>()).filename());
    EXPECT_EQ(input.at("bytes"), std::filesystem::file_size(folder.path(names.back())));
    EXPECT_THAT(input.at("sha256").get<std::string>(), testing::MatchesRegex("[0-9a-f]+"));
  }
  EXPECT_THAT(names, testing::UnorderedElementsAreArray(files));
  EXPECT_THAT(told.at("version").get<std::string>(), testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_TRUE(told.contains("commit"));
}

TEST(Hdf5Provenance, IsThereForFrfs) {
  const InputFolder folder;
  ASSERT_EQ(run_command(folder.path(), {"convert", "a.csv", "new.h5"}).code, 0);
  const json told = provenance_of(folder.path("new.h5"));
  expect_sums(folder, told, {"a.csv"});
  EXPECT_EQ(told.at("command"), json({"jointid", "convert", "a.csv", "new.h5"}));
  EXPECT_FALSE(told.at("libraries").empty());
  const Outcome read = run_command(folder.path(), {"info", "new.h5"});
  EXPECT_EQ(read.code, 0) << read.err;
}

/// One text for all ways to a study, so that its file has the same bytes.
TEST(Hdf5Provenance, OfAStudyIsTheSameInOneRunAndMerged) {
  const InputFolder folder;
  const std::vector<std::string> study = {"study", "A1.toml", "--trials", "6", "--threads", "1", "--out"};
  const auto run = [&](const std::string& out, std::vector<std::string> more) {
    std::vector<std::string> arguments = study;
    arguments.push_back(out);
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_command(folder.path(), arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
  };
  run("whole.h5", {});
  run("p1.h5", {"--part", "1/2"});
  run("p2.h5", {"--part", "2/2"});
  ASSERT_EQ(run_command(folder.path(), {"study", "--merge", "p1.h5", "p2.h5", "--out", "merged.h5"}).code, 0);
  const json told = provenance_of(folder.path("whole.h5"));
  expect_sums(folder, told, {"A1.toml", "A1_assembly.h5", "A1_substructure_1.h5", "A1_substructure_2.h5"});
  EXPECT_EQ(told.at("command"), json({"jointid", "study", "A1.toml", "--trials", "6", "--seed", "1"}));
  EXPECT_EQ(provenance_of(folder.path("p2.h5")), told);
  EXPECT_TRUE(folder.text("whole.h5") == folder.text("merged.h5"));
}

}  // namespace
}  // namespace jointid::cli
