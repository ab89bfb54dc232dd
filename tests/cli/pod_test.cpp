#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.hpp"
#include "cli/pod/pod_command.hpp"
#include "report/pod/pod_report.hpp"
#include "tests/test_folder.hpp"

namespace jointid::cli {
namespace {

using testing::HasSubstr;

void write(const std::filesystem::path& path, const std::string& text) { std::ofstream(path) << text; }

/// Two standing waves of mean squares 1/2 and 1/8, unequal masses, times in the first column.
std::string waves(const std::string& unit, int from, int to) {
  std::ostringstream text;
  text << "time [s],a [" << unit << "],b [m],c [m]\n";
  text.precision(17);
  for (int i = from; i < to; ++i) {
    const double one = std::cos(2.0 * M_PI * i / 50.0), two = 0.5 * std::cos(2.0 * M_PI * 3.0 * i / 50.0);
    text << i << "," << 1.0 + 0.6 * one + 0.8 * two << "," << 0.8 * one - 0.6 * two << "," << 2.0 << "\n";
  }
  return text.str();
}

nlohmann::json run(const PodArguments& arguments) {
  PodArguments json = arguments;
  json.json = "-";
  std::ostringstream out;
  EXPECT_EQ(execute(json, out), ExitCode::done);
  return nlohmann::json::parse(out.str());
}

TEST(Pod, FindsTheModesOfARecord) {
  const TestFolder folder;
  write(folder / "run.csv", waves("m", 0, 500));
  write(folder / "modes.csv", "0.8,0.6\n-0.6,0.8\n0,0\n");
  PodArguments arguments;
  arguments.files = {folder / "run.csv"};
  arguments.compare = folder / "modes.csv";
  const auto found = run(arguments);
  EXPECT_EQ(found["samples"], 500);
  EXPECT_NEAR(found["values"][0].get<double>(), 0.5, 1e-12);
  EXPECT_NEAR(found["values"][1].get<double>(), 0.125, 1e-12);
  EXPECT_NEAR(found["fractions_of_sigma_squared"][0].get<double>(), 0.8, 1e-12);
  EXPECT_NEAR(found["fractions_of_sigma"][0].get<double>(), 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(found["modes"][0][1].get<double>(), 0.8, 1e-12);
  EXPECT_NEAR(found["mean"][0].get<double>(), 1.0, 1e-12);
  EXPECT_NEAR(found["mac"][0][1].get<double>(), 1.0, 1e-12);
  EXPECT_EQ(found["channels"].size(), 3u);

  std::ostringstream text;
  execute(arguments, text);
  EXPECT_THAT(text.str(), HasSubstr("500 samples of 3 channels, mean removed, inner product plain"));
  EXPECT_THAT(text.str(), HasSubstr("modes for 99 % of Σσ²: 2"));
  EXPECT_THAT(text.str(), HasSubstr("beside the modes of --compare"));
}

TEST(Pod, FilesAreFurtherSamplesAndThreadsChangeNothing) {
  const TestFolder folder;
  write(folder / "run.csv", waves("m", 0, 500));
  write(folder / "one.csv", waves("m", 0, 123));
  write(folder / "two.csv", waves("m", 123, 500));
  PodArguments whole, parts;
  whole.files = {folder / "run.csv"};
  parts.files = {folder / "one.csv", folder / "two.csv"};
  const auto a = run(whole), b = run(parts);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(a["values"][k].get<double>(), b["values"][k].get<double>(), 1e-13);
  whole.threads = 4;
  auto threaded = run(whole), alone = a;
  for (auto* each : {&threaded, &alone}) each->erase("provenance");  // by this test's own process
  EXPECT_EQ(threaded, alone);
}

TEST(Pod, SaysWhatIsMissingAndWhatUnitsDo) {
  const TestFolder folder;
  write(folder / "run.csv", waves("rad", 0, 60) + "60,,1,2\n61,nan,1,2\n");
  PodArguments arguments;
  arguments.files = {folder / "run.csv"};
  const auto found = run(arguments);
  EXPECT_EQ(found["missing"], 2);
  EXPECT_EQ(found["samples"], 60);
  EXPECT_THAT(found["remarks"].dump(), HasSubstr("different units"));

  write(folder / "mass.csv", "2,0,0\n0,1,0\n0,0,1\n");
  arguments.mass = folder / "mass.csv";
  EXPECT_EQ(run(arguments)["inner_product"], "mass");
  write(folder / "mass.csv", "2,0,0\n0,-1,0\n0,0,1\n");
  EXPECT_THROW(run(arguments), InputError);
  write(folder / "other.csv", "a,b\n1,2\n2,3\n");
  arguments.mass.clear();
  arguments.files.push_back(folder / "other.csv");
  EXPECT_THROW(run(arguments), InputError);
}

}  // namespace
}  // namespace jointid::cli
