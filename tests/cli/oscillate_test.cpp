#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/error.hpp"
#include "cli/oscillate/oscillate_command.hpp"
#include "problems/thesis/oscillations.hpp"
#include "report/oscillate/oscillate_scene.hpp"
#include "tests/test_folder.hpp"

namespace jointid::cli {
namespace {

using testing::HasSubstr;

/// One mass on a belt with Coulomb friction, whose motion is known in closed form.
const std::string one_mass = R"(
[system]
kind = "belt_chain"
masses = 1
mass = 1.3
stiffness = 2.1
velocity = 0.2

[friction]
kinetic = 0.3
static = 0.5
normal = 1.7

[start]
velocity = [0.2]

[motion]
transient = 5.0
length = 53.0433253402657
step = 0.01
)";

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

std::string error_of(const std::string& text) {
  try {
    report::parse_oscillate_scene(text, "scene.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return text.replace(place, what.size(), by);
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

TEST(OscillateScene, SaysWhatIsWrong) {
  EXPECT_THAT(error_of(replaced(one_mass, "static = 0.5", "static = 0.2")), HasSubstr("[friction] static: is below kinetic"));
  EXPECT_THAT(error_of(replaced(one_mass, "velocity = 0.2\n\n[friction]", "\n[friction]")),
              HasSubstr("nothing moves the contact"));
  EXPECT_THAT(error_of(replaced(one_mass, "step = 0.01", "step = 10.0")), HasSubstr("take 20 to 1e7"));
  EXPECT_THAT(error_of(replaced(one_mass, "velocity = [0.2]", "velocity = [0.2, 0.1]")),
              HasSubstr("has 2 numbers, the system 1"));
  EXPECT_THAT(error_of(replaced(one_mass, "masses = 1", "masses = 0")), HasSubstr("masses"));
  EXPECT_THAT(error_of(replaced(one_mass, "mass = 1.3", "length = 1.3")), HasSubstr("length"));
  EXPECT_THAT(error_of(one_mass + "[orbit]\ncycles = 1\n"), HasSubstr("no drive with cycles"));
  const std::string driven = replaced(one_mass, "velocity = 0.2\n", "amplitude = 0.1\nfrequency = 1e300\n");
  EXPECT_THAT(error_of(driven), HasSubstr("cycles of the slider; take 1e6 at most"));
  EXPECT_THAT(error_of(one_mass + "[exponents]\nlength = 1e12\ninterval = 1.0\n"), HasSubstr("take 1e6 at most"));
  EXPECT_THAT(error_of(one_mass + "[exponents]\nlength = 5.0\ninterval = 1.0\n"), HasSubstr("less than 20"));
  EXPECT_THAT(error_of(one_mass + "[sweep]\nparameter = \"frequency\"\nrange = [1.0, 2.0]\npoints = 3\nlength = 9.0\n"),
              HasSubstr("there is no slider"));
  EXPECT_THAT(error_of(one_mass + "[sweep]\nparameter = \"normal\"\nrange = [0.0, 2.0]\npoints = 3\nlength = 9.0\n"),
              HasSubstr("not above 0"));
  EXPECT_THAT(error_of(one_mass + "[reduction]\nbases = [\"pod\"]\norders = [2]\n"), HasSubstr("from 1 to 1"));
  EXPECT_THAT(error_of(one_mass + "[reduction]\nbases = [\"pod\"]\norders = [1]\nfrom = \"orbit\"\n"),
              HasSubstr("there is no [orbit]"));
  EXPECT_THAT(error_of(replaced(one_mass, "kinetic = 0.3", "kinetic = 0.3\ncontact_stiffness = 9.0") + "[orbit]\nslips = 1\n"),
              HasSubstr("rigid contacts only"));
}

TEST(Oscillations, OfTheThesisAreScenesThatCanBeRead) {
  const TestFolder folder;
  for (const problems::Oscillation& each : problems::list_oscillations()) {
    const auto scene = report::read_oscillate_scene(problems::write(each, folder / each.name));
    EXPECT_THAT(scene.title, HasSubstr(each.name));
    EXPECT_GT(scene.q.size(), 0);
  }
  EXPECT_EQ(problems::find_oscillation("chain-11"), nullptr);
}

/// The frequencies of the printed parameters (theory, 6), and one per cent in the first mode.
TEST(Oscillations, OfTheCantileverHaveItsParameters) {
  const TestFolder folder;
  const auto scene = report::read_oscillate_scene(problems::write(*problems::find_oscillation("cantilever"), folder));
  EXPECT_NEAR(oscillation::natural_frequencies(scene.system.beam)(0), 2.10, 0.005);
  EXPECT_NEAR(scene.system.beam.bending_stiffness(), 0.0868428, 1e-6);
  const auto model = model_of(scene.system);
  const double c = model.mechanics.damping(0, 0) / model.mechanics.stiffness(0, 0);
  EXPECT_NEAR(c, oscillation::one_per_cent(scene.system.beam), 1e-12);
  EXPECT_TRUE(scene.system.friction.contact_stiffness);
}

}  // namespace
}  // namespace jointid::cli
