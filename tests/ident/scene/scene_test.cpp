#include "ident/scene/scene.hpp"

#include <gmock/gmock.h>

#include <tuple>

#include "ident/scene/read_scene.hpp"
#include "restrictions/restriction.hpp"
#include "tests/ident/scene/full_scene.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using restrictions::Pattern;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(Scene, AListInPlaceOfAFileIsRepeatsWithTheirOptions) {
  const Scene scene = parse_scene(R"(
data.substructures = [["run1.h5", "run2.h5", "run3.h5"], "other.h5"]
data.assembly = ["whole.h5"]
[data.files."run3.h5"]
quantity = "mobility"
[data.files."other.h5"]
quantity = "accelerance"
[joint]
dofs = ["1:+X"]
stiffness.pattern = "full"
)", "scene.toml");
  ASSERT_THAT(scene.data.substructures, SizeIs(2));
  const DataFile& first = scene.data.substructures[0];
  EXPECT_EQ(first.path, Path("run1.h5"));
  ASSERT_THAT(first.repeats, SizeIs(2));
  EXPECT_EQ(first.repeats[1].path, Path("run3.h5"));
  EXPECT_EQ(first.repeats[1].options.quantity, frf::Quantity::mobility);
  EXPECT_EQ(scene.data.substructures[1].options.quantity, frf::Quantity::accelerance);
  EXPECT_TRUE(scene.data.substructures[1].repeats.empty());
}

TEST(Scene, CorrectionsOfAFileArrive) {
  const Scene scene = parse_scene(R"(
data.substructures = ["part.h5"]
data.assembly = ["whole.h5"]
[data.files."whole.h5"]
frequency_scale = 0.99
rename = { "1:+Y" = "2:-Y", "2:+Y" = "1:+Y" }
rename_reference = { "3:+Y" = "4:+Y" }
conjugate = true
delay = 20e-6
gain = { "1:+Y" = 1.02 }
gain_reference = { "4:+Y" = 0.5 }
flip = ["1:+Y"]
flip_reference = ["4:+Y", "5:+Y"]
sensor_mass = { "2:+Y" = 0.003 }
sensors = "fixed"
[data.files."part.h5"]
gain = 9.80665
[joint]
dofs = ["1:+X"]
stiffness.pattern = "full"
)", "scene.toml");
  const frf::Corrections& all = scene.data.assembly[0].corrections;
  EXPECT_EQ(all.frequency_scale, 0.99);
  ASSERT_THAT(all.rename, SizeIs(2));
  EXPECT_EQ(all.rename[0].from.name(), "1:+Y");
  EXPECT_EQ(all.rename[0].to.name(), "2:-Y");
  ASSERT_THAT(all.rename_reference, SizeIs(1));
  EXPECT_TRUE(all.conjugate);
  EXPECT_EQ(all.delay, 20e-6);
  EXPECT_EQ(all.gain, 1.0);
  ASSERT_THAT(all.response_gain, SizeIs(1));
  EXPECT_EQ(all.response_gain[0].value, 1.02);
  ASSERT_THAT(all.reference_gain, SizeIs(1));
  EXPECT_THAT(all.flip, SizeIs(1));
  EXPECT_THAT(all.flip_reference, SizeIs(2));
  ASSERT_THAT(all.sensor_mass, SizeIs(1));
  EXPECT_EQ(all.sensor_mass[0].value, 0.003);
  EXPECT_EQ(all.sensors, frf::SensorsOn::fixed);
  const frf::Corrections& of_part = scene.data.substructures[0].corrections;
  EXPECT_EQ(of_part.gain, 9.80665);
  EXPECT_TRUE(of_part.response_gain.empty());
  EXPECT_FALSE(frf::Corrections().any());
}

TEST(Scene, EveryKeyArrives) {
  const Scene scene = parse_scene(full_scene, "some/where/scene.toml");
  EXPECT_EQ(scene.file, Path("some/where/scene.toml"));
  EXPECT_EQ(scene.title, "two beams and a soft joint");

  ASSERT_THAT(scene.data.substructures, SizeIs(2));
  EXPECT_EQ(scene.data.substructures[0].path, Path("some/where/beam_long.uff"));
  EXPECT_EQ(scene.data.substructures[0].options.quantity, frf::Quantity::accelerance);
  EXPECT_THAT(scene.data.substructures[0].options.response, SizeIs(2));
  EXPECT_THAT(scene.data.substructures[0].options.reference, ElementsAre(frf::Dof::parse("4:+Y")));
  EXPECT_FALSE(scene.data.substructures[1].options.quantity.has_value());
  ASSERT_THAT(scene.data.assembly, SizeIs(1));
  EXPECT_EQ(scene.data.assembly[0].options.variable, "H");
  EXPECT_TRUE(scene.data.reciprocity);

  EXPECT_EQ(scene.frequency.range_hz, (Range{400, 1000}));
  EXPECT_EQ(scene.frequency.step_hz, 20);
  EXPECT_THAT(scene.frequency.exclude_hz, ElementsAre(Range{560, 566}));
  ASSERT_TRUE(scene.frequency.exclude_resonances.has_value());
  EXPECT_TRUE(scene.frequency.exclude_resonances->of_substructures);
  EXPECT_FALSE(scene.frequency.exclude_resonances->of_assembly);
  EXPECT_EQ(scene.frequency.exclude_resonances->half_width, 0.02);

  EXPECT_EQ(scene.identify.method, Method::likelihood);
  EXPECT_THAT(scene.identify.equations, ElementsAre(Equation::nn, Equation::jn));
  EXPECT_EQ(scene.identify.weighting, weighting::Weighting::wbs);
  EXPECT_EQ(scene.identify.delta, 0.05);
  EXPECT_EQ(scene.identify.solver, Solver::ceres);
  EXPECT_EQ(scene.identify.start.at(Kind::stiffness)[3], (std::vector<double>{0, 0, 0, 4}));
  ASSERT_TRUE(scene.noise.has_value());
  EXPECT_EQ(scene.noise->model, "modal");
  EXPECT_EQ(scene.noise->level, 0.05);
  ASSERT_THAT(scene.truth, SizeIs(1));
  EXPECT_EQ(scene.truth.at(Kind::viscous_damping)[3][3], 5);
}

TEST(Scene, TheJointArrives) {
  const Scene scene = parse_scene(full_scene, "scene.toml");
  ASSERT_THAT(scene.joints, SizeIs(1));
  const restrictions::JointSpec& joint = scene.joints[0];
  EXPECT_EQ(joint.name, "");
  ASSERT_THAT(joint.dofs, SizeIs(4));
  EXPECT_EQ(joint.dofs[3].name(), "5:-RZ");
  EXPECT_THAT(joint.bands_hz, ElementsAre(Range{400, 600}, Range{600, 1000}));
  EXPECT_THAT(joint.node_positions, SizeIs(2));
  EXPECT_EQ(joint.node_positions.at(5)[0], 0.3);
  ASSERT_THAT(joint.matrices, SizeIs(3));
  EXPECT_EQ(std::get<Pattern>(joint.matrices.at(Kind::stiffness)), Pattern::symmetric);
  const auto& entries = std::get<restrictions::EntryMatrix>(joint.matrices.at(Kind::hysteretic_damping));
  EXPECT_EQ(entries[0][2], restrictions::Entry("-a"));
  EXPECT_EQ(entries[2][3], restrictions::Entry(-1.5));
  EXPECT_EQ(entries[3][2], restrictions::Entry(-2.0));
  const auto& springs = std::get<std::vector<restrictions::Spring>>(joint.matrices.at(Kind::mass));
  ASSERT_THAT(springs, SizeIs(2));
  EXPECT_EQ(springs[1].first.name(), "4:+RZ");
  EXPECT_FALSE(springs[1].second.has_value());
}

TEST(Scene, WhatIsLeftOutHasItsDefault) {
  const Scene scene = parse_scene(R"(
data = { substructures = ["/abs/a.h5"], assembly = ["../b.h5"] }
joint = { dofs = ["1:+X"], stiffness.pattern = "free" }
)", "here/scene.toml");
  EXPECT_EQ(scene.title, "");
  EXPECT_EQ(scene.data.substructures[0].path, Path("/abs/a.h5"));
  EXPECT_EQ(scene.data.assembly[0].path, Path("here/../b.h5"));
  EXPECT_FALSE(scene.data.reciprocity);
  EXPECT_FALSE(scene.frequency.range_hz.has_value());
  EXPECT_EQ(scene.identify.method, Method::one);
  EXPECT_THAT(scene.identify.equations, IsEmpty());
  EXPECT_EQ(scene.identify.weighting, weighting::Weighting::wb);
  EXPECT_EQ(scene.identify.solver, Solver::automatic);
  EXPECT_FALSE(scene.noise.has_value());
  EXPECT_THAT(scene.truth, IsEmpty());
}

TEST(Scene, SeveralJointsKeepTheirOrderAndNames) {
  const Scene scene = parse_scene(R"(
[data]
substructures = ["a.h5"]
assembly = ["b.h5"]
[[joints]]
name = "left"
dofs = ["1:+X"]
stiffness.pattern = "full"
[[joints]]
name = "right"
dofs = ["2:+X"]
mass.pattern = "full"
[identify]
start.mass = [[1, 2], [3, 4]]
)", "scene.toml");
  ASSERT_THAT(scene.joints, SizeIs(2));
  EXPECT_EQ(scene.joints[0].name, "left");
  EXPECT_EQ(scene.joints[1].name, "right");
  EXPECT_EQ(scene.identify.start.at(Kind::mass)[1][0], 3);
}

TEST(Scene, NamesOfMethodsAndEquations) {
  EXPECT_EQ(name(Method::one), "one");
  EXPECT_EQ(name(Method::likelihood), "likelihood");
  EXPECT_EQ(name(Equation::nn), "nn");
  EXPECT_EQ(name(Equation::jn), "jn");
}

/// A joint of three DOFs against three, with this declaration of K and these lines of [identify].
Scene with_springs(const std::string& springs, const std::string& identify) {
  return parse_scene(R"(
data.substructures = ["a.h5"]
data.assembly = ["b.h5"]
joint.dofs = ["21:+X", "22:+X", "121:+X", "122:-X"]
joint.stiffness.springs = )" + springs + "\n[identify]\n" + identify + "\n", "scene.toml");
}

TEST(Springs, MayHaveNames) {
  const Scene scene = with_springs(R"({ k1 = ["21:+X", "121:+X"], k2 = [["22:+X", "122:+X"], ["22:+X", "ground"]] })", "");
  const restrictions::Restriction all = restrictions::build(scene.joints);
  ASSERT_THAT(all.unknowns, SizeIs(2));
  EXPECT_EQ(all.unknowns[0].name, "K.k1");
  EXPECT_EQ(all.unknowns[1].name, "K.k2");
  EXPECT_EQ(all.unknowns[1].unit, "N/m");
  // k1 = 10, k2 = 1 by hand; 122 points the other way, so that its coupling has the other sign
  EXPECT_THAT(all.matrix(Kind::stiffness, {10.0, 1.0}),
              ElementsAre(10.0, 0.0, -10.0, 0.0, 0.0, 2.0, 0.0, 1.0, -10.0, 0.0, 10.0, 0.0, 0.0, 1.0, 0.0, 1.0));
}

TEST(Start, IsANumberForEachSpringOrOneForAll) {
  const std::string list = R"([["21:+X", "121:+X"], ["22:+X", "122:+X"]])";
  const std::string named = R"({ a = ["21:+X", "121:+X"], b = ["22:+X", "122:+X"] })";
  const Matrix both = {{2e6, 0, -2e6, 0}, {0, 3e6, 0, 3e6}, {-2e6, 0, 2e6, 0}, {0, 3e6, 0, 3e6}};
  const Matrix same = {{2e6, 0, -2e6, 0}, {0, 2e6, 0, 2e6}, {-2e6, 0, 2e6, 0}, {0, 2e6, 0, 2e6}};
  for (const auto& [springs, start, expected] : std::vector<std::tuple<std::string, std::string, Matrix>>{
           {list, "start = 2e6", same},
           {list, "start = [2e6, 3e6]", both},
           {list, "start = { stiffness = 2e6 }", same},
           {list, "start = { stiffness = [2e6, 3e6] }", both},
           {list, "start = { stiffness = { \"K[21:+X,121:+X]\" = 2e6, \"K[22:+X,122:+X]\" = 3e6 } }", both},
           {named, "start = 2e6", same},
           {named, "start = { stiffness = { b = 3e6, a = 2e6 } }", both}}) {
    EXPECT_EQ(with_springs(springs, start).identify.start.at(Kind::stiffness), expected) << start;
  }
}

}  // namespace
}  // namespace jointid::ident
