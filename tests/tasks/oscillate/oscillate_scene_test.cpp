#include "tasks/oscillate/oscillate_scene.hpp"

#include <gmock/gmock.h>

#include "base/control.hpp"
#include "base/error.hpp"
#include "problems/thesis/oscillations.hpp"
#include "tasks/oscillate/run_oscillate.hpp"
#include "tests/tasks/oscillate/one_mass.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

using testing::HasSubstr;

std::string error_of(const std::string& text) {
  try {
    parse_oscillate_scene(text, "scene.toml");
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

TEST(RunOscillate, TellsHowFarItIsAndStops) {
  const OscillateScene scene = parse_oscillate_scene(one_mass + "[orbit]\nslips = 1\n", "scene.toml");
  std::vector<std::string> stages;
  std::size_t kept = 0;
  ident::Control control;
  control.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
    EXPECT_LE(done, total);
    if (stages.empty() || stages.back() != stage) stages.push_back(stage);
  };
  const OscillateResult found = run_oscillate(scene, control, [&](const OscillateResult& so_far) {
    EXPECT_EQ(so_far.orbit.has_value(), kept == 1);
    ++kept;
  });
  EXPECT_THAT(stages, testing::ElementsAre("motion", "periodic orbit"));
  EXPECT_EQ(kept, 2u);
  EXPECT_EQ(failure_of(found), "");
  control.interrupted = [] { return true; };
  EXPECT_THROW(run_oscillate(scene, control), Interrupted);
}

TEST(Oscillations, OfTheThesisAreScenesThatCanBeRead) {
  const TestFolder folder;
  for (const problems::Oscillation& each : problems::list_oscillations()) {
    const auto scene = read_oscillate_scene(problems::write(each, folder / each.name));
    EXPECT_THAT(scene.title, HasSubstr(each.name));
    EXPECT_GT(scene.q.size(), 0);
  }
  EXPECT_EQ(problems::find_oscillation("chain-11"), nullptr);
}

/// The frequencies of the printed parameters (theory, 6), and one per cent in the first mode.
TEST(Oscillations, OfTheCantileverHaveItsParameters) {
  const TestFolder folder;
  const auto scene = read_oscillate_scene(problems::write(*problems::find_oscillation("cantilever"), folder));
  EXPECT_NEAR(oscillation::natural_frequencies(scene.system.beam)(0), 2.10, 0.005);
  EXPECT_NEAR(scene.system.beam.bending_stiffness(), 0.0868428, 1e-6);
  const auto model = model_of(scene.system);
  const double c = model.mechanics.damping(0, 0) / model.mechanics.stiffness(0, 0);
  EXPECT_NEAR(c, oscillation::one_per_cent(scene.system.beam), 1e-12);
  EXPECT_TRUE(scene.system.friction.contact_stiffness);
}

}  // namespace
}  // namespace jointid::tasks
