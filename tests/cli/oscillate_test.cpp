#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/oscillate/oscillate_command.hpp"
#include "tests/tasks/oscillate/one_mass.hpp"
#include "tests/test_folder.hpp"

namespace jointid::cli {
namespace {

using tasks::one_mass;
using testing::HasSubstr;

std::filesystem::path write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
  return path;
}

nlohmann::json run(OscillateArguments arguments) {
  arguments.json = "-";
  std::ostringstream out;
  EXPECT_EQ(execute(arguments, out), ExitCode::done);
  return nlohmann::json::parse(out.str());
}

TEST(Oscillate, OneMassHasThePeriodOfItsClosedForm) {
  const TestFolder folder;
  OscillateArguments arguments;
  arguments.scene = write(folder / "one.toml", one_mass +
                                                   "[orbit]\nslips = 1\n[sweep]\nparameter = \"velocity\"\nrange = [0.15, 0.3]\n"
                                                   "points = 4\ntransient = 10.0\nlength = 60.0\n");
  arguments.threads = 2;
  const auto found = run(arguments);
  // Slip (2/ω)(π − atan(Δω/V)), stick 2Δ/V, Δ = (μ_S − μ_K)N/k.
  const double delta = 0.2 * 1.7 / 2.1, omega = std::sqrt(2.1 / 1.3);
  const double period = 2.0 / omega * (M_PI - std::atan(delta * omega / 0.2)) + 2.0 * delta / 0.2;
  EXPECT_NEAR(found["orbit"]["period"].get<double>(), period, 1e-12);
  EXPECT_NEAR(found["motion"]["stick_share"].get<double>(), 2.0 * delta / 0.2 / period, 1e-9);
  EXPECT_EQ(found["motion"]["section_points"], 10);
  ASSERT_EQ(found["sweep"]["points"].size(), 4u);
  for (const auto& point : found["sweep"]["points"]) {
    ASSERT_GT(point["values"].size(), 5u);
    for (const auto& value : point["values"]) EXPECT_NEAR(value.get<double>(), 0.5 * 1.7 / 2.1, 1e-12);
  }
  arguments.threads = 1;
  EXPECT_EQ(run(arguments), found);
}

TEST(Oscillate, SamplesGoBackInAsARecord) {
  const TestFolder folder;
  OscillateArguments arguments;
  arguments.scene = write(folder / "one.toml", one_mass);
  arguments.csv = (folder / "one.csv").string();
  arguments.events = (folder / "section.csv").string();
  arguments.report = (folder / "one.html").string();
  std::ostringstream out;
  EXPECT_EQ(execute(arguments, out), ExitCode::done);
  EXPECT_THAT(out.str(), HasSubstr("proper orthogonal modes of what is seen"));
  std::ifstream csv(*arguments.csv), page(*arguments.report);
  std::string first;
  std::getline(csv, first);
  EXPECT_EQ(first, "time [s],q1 [m],dq1/dt [m/s],relative velocity [m/s],friction [N],normal [N],contact [m]");
  const std::string html{std::istreambuf_iterator<char>(page), {}};
  EXPECT_THAT(html, HasSubstr("Phase plane of q1"));
  EXPECT_THAT(html, HasSubstr("at break-aways"));
}

TEST(Oscillate, ReducedModelsOfMatricesAreExactWithAllCoordinates) {
  const TestFolder folder;
  OscillateArguments arguments;
  arguments.scene = write(folder / "two.toml", R"(
[system]
kind = "matrices"
mass = [[1.0, 0.0], [0.0, 2.0]]
stiffness = [[3.0, -1.0], [-1.0, 2.0]]
contact = [0.0, 1.0]
modal_damping = 0.02
velocity = 0.2
[friction]
kinetic = 0.3
static = 0.5
normal = 1.5
[motion]
length = 20.0
step = 0.05
[exponents]
count = 1
length = 40.0
interval = 1.0
[reduction]
bases = ["pod", "normal_modes", "craig_bampton"]
orders = [1, 2]
)");
  const auto found = run(arguments);
  ASSERT_EQ(found["reduction"]["models"].size(), 6u);
  for (const auto& model : found["reduction"]["models"]) {
    const double error = model["error_of_motion"];
    const bool whole = model["order"] == 2;
    EXPECT_TRUE(whole ? error < 1e-8 : error > 1e-4) << model;
  }
  EXPECT_EQ(found["exponents"]["nats_per_second"].size(), 1u);
}

}  // namespace
}  // namespace jointid::cli
