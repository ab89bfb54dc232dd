#include <gmock/gmock.h>

#include <limits>

#include "ident/identify.hpp"
#include "memory_systems.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Case A1 with every line from 1 to 1000 Hz, where natural frequencies are known.
std::unique_ptr<Plan> plan_without_resonances(bool of_substructures, bool of_assembly) {
  const problems::Problem a1 = problems::make("A1");
  const auto fine = [](const problems::Modes& modes, frf::FrfHeader header) {
    header.frequency_hz.clear();
    for (int i = 1; i <= 2000; ++i) header.frequency_hz.push_back(0.5 * i);
    frf::FrfSet set = problems::modal_response(
        modes,
        {.response = header.response, .reference = header.reference, .frequency_hz = header.frequency_hz});
    set.header = header;
    return set;
  };
  std::vector<frf::FrfSet> parts;
  for (std::size_t i = 0; i < 2; ++i)
    parts.push_back(fine(a1.substructure_modes[i], a1.substructures[i].header));
  Scene scene = problems::scene(a1);
  scene.frequency = {};
  scene.frequency.exclude_resonances = ResonanceExclusion{
      .of_substructures = of_substructures, .of_assembly = of_assembly, .half_width = 0.01};
  return memory_plan(scene, parts, {fine(a1.assembly_modes, a1.assembly.header)});
}

/// Whether no line of the plan lies within half a per cent of the frequency.
bool left_out(const Plan& plan, double frequency_hz) {
  return std::none_of(plan.lines.begin(), plan.lines.end(), [&](const Line& line) {
    return std::abs(line.frequency_hz / frequency_hz - 1.0) < 0.005;
  });
}

const std::vector<double> of_parts = {79.974, 220.984, 484.705, 870.059, 179.848, 562.865};
const std::vector<double> of_whole = {22.615, 60.485, 120.668, 228.086, 294.871, 537.120, 672.146, 965.781};

TEST(ResonanceExclusion, LeavesOutTheLinesAroundNaturalFrequencies) {
  const auto parts = plan_without_resonances(true, false), whole = plan_without_resonances(false, true);
  for (const double f : of_parts) EXPECT_TRUE(left_out(*parts, f)) << f;
  for (const double f : of_whole) EXPECT_TRUE(left_out(*whole, f)) << f;
  EXPECT_FALSE(left_out(*parts, 120.668));
  EXPECT_FALSE(left_out(*whole, 484.705));
  EXPECT_THAT(parts->notes, ElementsAre(HasSubstr("Found 6 resonances in the substructures")));
  EXPECT_THAT(whole->notes, ElementsAre(HasSubstr("Found 8 resonances in the assembly")));
}

TEST(ResonanceExclusion, OfBothSystemsIsThatOfEach) {
  const auto both = plan_without_resonances(true, true);
  for (const double f : of_parts) EXPECT_TRUE(left_out(*both, f)) << f;
  for (const double f : of_whole) EXPECT_TRUE(left_out(*both, f)) << f;
  EXPECT_EQ(both->notes.size(), 2u);
}

TEST(ResonanceExclusion, LinesThatWereNotMeasuredAreNoResonances) {
  std::vector<double> axis;
  for (int i = 1; i <= 40; ++i) axis.push_back(10.0 * i);
  const Dofs all = dofs({"1:+Y", "4:+Y", "5:+Y"});
  std::mt19937_64 random(2);
  const frf::FrfSet parts = random_set("parts", axis, all, all, 1.0, random);
  frf::FrfSet whole = parts;
  for (std::size_t i = 0; i < whole.values.size(); ++i) {
    const std::size_t line = i / 9;
    // A smooth curve; two lines are missing, and in two others two of the three points.
    const bool missing = line == 10 || line == 20 || ((line == 25 || line == 30) && i % 9 != 0);
    whole.values[i] = missing ? std::numeric_limits<double>::quiet_NaN() : 1.0 / (axis[line] * axis[line]);
  }
  Scene scene;
  scene.joints = {
      joint_of(dofs({"4:+Y", "5:+Y"}), restrictions::Kind::stiffness, restrictions::Pattern::full)};
  scene.frequency.exclude_resonances =
      ResonanceExclusion{.of_substructures = false, .of_assembly = true, .half_width = 0.01};
  EXPECT_THAT(memory_plan(scene, {parts}, {whole})->notes, ElementsAre(HasSubstr("Found 0 resonances")));
}

}  // namespace
}  // namespace jointid::ident
