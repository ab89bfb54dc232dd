#include "tasks/joint/joint_layout.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "ident/scene/read_scene.hpp"
#include "ident/scene/readable_scene.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {
namespace {

using frf::Direction;
using tasks::JointForm;
using testing::ElementsAre;
using testing::IsEmpty;

frf::FrfHeader part(const std::vector<std::string>& dofs, const std::vector<frf::Node>& nodes) {
  frf::FrfHeader made;
  made.frequency_hz = {10.0};
  for (const std::string& dof : dofs) made.response.push_back(frf::Dof::parse(dof));
  made.reference = made.response;
  made.nodes = nodes;
  return made;
}

std::vector<std::string> names(const std::vector<tasks::NodePair>& pairs) {
  std::vector<std::string> out;
  for (const auto& pair : pairs) out.push_back(std::to_string(pair.first) + "-" + std::to_string(pair.second) + (pair.likely ? "" : "?"));
  return out;
}

TEST(NodePairs, AreNearestToEachOther) {
  const frf::FrfHeader a = part({"1:+X", "2:+X", "3:+X"}, {{1, {0, 0, 0}}, {2, {1, 0, 0}}, {3, {2, 0, 0}}}),
                       b = part({"11:+X", "12:-X", "13:+X"}, {{11, {0, 0, 0.01}}, {12, {1, 0, 0.012}}, {13, {2, 0, 0.4}}});
  const auto pairs = tasks::propose_pairs({&a, &b});
  EXPECT_THAT(names(pairs), ElementsAre("1-11", "2-12", "3-13?"));
  EXPECT_NEAR(*pairs[1].gap_m, 0.012, 1e-12);
}

TEST(NodePairs, OfNodesWithoutPositionsThereAreNone) {
  const frf::FrfHeader a = part({"1:+X"}, {}), b = part({"2:+X"}, {});
  EXPECT_THAT(tasks::propose_pairs({&a, &b}), IsEmpty());
  EXPECT_THAT(tasks::pair_of(a, 1, b, 2).directions, ElementsAre(Direction::x));
}

TEST(NodePairs, AreJoinedAlongTheSameAxisOnly) {
  frf::Node turned{2, {0, 0, 0}, frf::Axes{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}}, unknown{2, {0, 0, 0}, frf::global_axes};
  (*unknown.axes)[0][0] = std::numeric_limits<double>::quiet_NaN();
  const frf::FrfHeader a = part({"1:+X", "1:+Y", "1:+Z"}, {{1, {0, 0, 0}}}), b = part({"2:+X", "2:+Y", "2:+Z"}, {turned}),
                       c = part({"2:+X", "2:+Y", "2:+Z"}, {unknown});
  EXPECT_THAT(tasks::pair_of(a, 1, b, 2).directions, ElementsAre(Direction::z));
  EXPECT_THAT(tasks::pair_of(a, 1, c, 2).directions, ElementsAre(Direction::y, Direction::z));
}

tasks::JointLayout two_bolts(JointForm form) {
  return {{{1, 11, {Direction::x, Direction::z}}, {2, 12, {Direction::x, Direction::z}}}, form};
}

/// The unknowns that a scene with the layout has.
std::size_t unknowns_read(const tasks::JointLayout& layout) {
  std::string dofs;
  for (const frf::Dof& dof : tasks::dofs_of(layout)) dofs += (dofs.empty() ? "\"" : ", \"") + dof.name() + "\"";
  const std::string springs = tasks::springs_text(layout), form = springs.empty() ? "pattern = \"symmetric\"" : "springs = " + springs;
  std::string text = "[data]\nsubstructures = [\"a\", \"b\"]\nassembly = [\"c\"]\n[joint]\ndofs = [" + dofs + "]\n";
  text += "[joint.stiffness]\n" + form + "\n[joint.hysteretic_damping]\n" + form + "\n";
  return restrictions::build(parse_scene(text, "scene.toml").joints).unknowns.size();
}

TEST(JointLayout, HasTheUnknownsOfItsScene) {
  for (const auto& [form, unknowns] : {std::pair(JointForm::springs, 8U), std::pair(JointForm::equal_springs, 4U),
                                       std::pair(JointForm::full, 72U)}) {
    const tasks::JointLayout layout = two_bolts(form);
    EXPECT_EQ(tasks::unknowns_of(layout), unknowns);
    EXPECT_EQ(unknowns_read(layout), unknowns);
  }
  EXPECT_THAT(frf::names(tasks::dofs_of(two_bolts(JointForm::springs))),
              ElementsAre("1:+X", "1:+Z", "2:+X", "2:+Z", "11:+X", "11:+Z", "12:+X", "12:+Z"));
}

TEST(ReadableScene, HasTheFilesWhateverElseIsWrong) {
  const auto scene = parse_readable(R"([data]
substructures = ["a.uff", 7, ["b.uff", "b2.uff"], "a.uff"]
assembly = []
nonsense = 1
[data.files."a.uff"]
quantity = "mobility"
[data.files."b.uff"]
wrong = 2
[frequency]
range = [10, 20]
[joint]
dofs = ["1:+X", "somewhere", "2:+X"]
[more]
)", "/d/scene.toml");
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->data.substructures.size(), 2U);
  EXPECT_EQ(scene->data.substructures[0].path, "/d/a.uff");
  EXPECT_EQ(scene->data.substructures[0].options.quantity, frf::Quantity::mobility);
  EXPECT_EQ(scene->data.substructures[1].repeats.size(), 1U);
  EXPECT_THAT(scene->data.assembly, IsEmpty());
  EXPECT_TRUE(scene->frequency.range_hz);
  EXPECT_THAT(frf::names(scene->joints.at(0).dofs), ElementsAre("1:+X", "2:+X"));
}

TEST(ReadableScene, PartsOfACouplingSceneAreSubstructures) {
  EXPECT_EQ(parse_readable("[data]\nparts = [\"a\", \"b\"]\n[couple]\n", "s.toml")->data.substructures.size(), 2U);
}

TEST(ReadableScene, NothingIsReadOfWhatIsNoScene) {
  EXPECT_FALSE(parse_readable("[data", "s.toml"));
  EXPECT_FALSE(parse_readable("[joint]\n", "s.toml"));
  EXPECT_TRUE(parse_readable("[data]\n[data.levels]\n", "s.toml"));
}

}  // namespace
}  // namespace jointid::ident
