#include "tasks/propose_scene.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "../test_folder.hpp"
#include "base/control.hpp"
#include "base/error.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/scene/readable_scene.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

frf::FrfHeader header(const std::string& file, const std::vector<std::string>& dofs, const std::vector<frf::Node>& nodes = {}) {
  frf::FrfHeader made;
  made.file = file;
  made.frequency_hz = {10.0, 20.0, 30.0};
  for (const std::string& dof : dofs) made.response.push_back(frf::Dof::parse(dof));
  made.reference = made.response;
  made.nodes = nodes;
  return made;
}

std::vector<const frf::FrfHeader*> pointers(const std::vector<frf::FrfHeader>& headers) {
  std::vector<const frf::FrfHeader*> all;
  for (const frf::FrfHeader& each : headers) all.push_back(&each);
  return all;
}

tasks::ProposedRoles roles_of(const std::vector<frf::FrfHeader>& headers) { return tasks::propose_roles(pointers(headers)); }

std::vector<std::size_t> only(std::size_t file) { return {file}; }

TEST(ProposedRoles, TheAssemblyIsTheFileThatSpansTheParts) {
  const tasks::ProposedRoles roles =
      roles_of({header("x", {"1:+X", "2:+X", "3:+X"}), header("y", {"1:+X", "2:+X"}), header("z", {"3:+X", "4:+X"})});
  EXPECT_THAT(roles.assembly, ElementsAre(only(0)));
  EXPECT_THAT(roles.substructures, ElementsAre(only(1), only(2)));
  EXPECT_THAT(roles.doubts, IsEmpty());
}

TEST(ProposedRoles, SignsOfSensorsDoNotMatter) {
  EXPECT_THAT(roles_of({header("x", {"1:+X", "3:+X"}), header("y", {"1:-X"}), header("z", {"3:-X"})}).assembly,
              ElementsAre(only(0)));
}

TEST(ProposedRoles, SeveralFilesCanBeTheAssembly) {
  frf::FrfHeader first = header("x", {"1:+X", "3:+X"}), second = first;
  first.reference = {frf::Dof::parse("1:+X")};
  second.reference = {frf::Dof::parse("3:+X")};
  EXPECT_THAT(roles_of({header("y", {"1:+X"}), first, header("z", {"3:+X"}), second}).assembly, ElementsAre(only(1), only(3)));
}

TEST(ProposedRoles, FilesAlikeAreRuns) {
  const tasks::ProposedRoles roles =
      roles_of({header("y", {"1:+X"}), header("y2", {"1:+X"}), header("x", {"1:+X", "3:+X"}), header("z", {"3:+X"})});
  EXPECT_THAT(roles.substructures, ElementsAre(ElementsAre(0, 1), ElementsAre(3)));
  EXPECT_THAT(roles.reasons, Contains(HasSubstr("runs of one measurement")));
}

TEST(ProposedRoles, NamesDecideWhatDofsLeaveOpenAndItIsSaid) {
  const tasks::ProposedRoles roles = roles_of({header("d/rig_assembly.uff", {"1:+X"}), header("d/rig_part.uff", {"1:+X"})});
  EXPECT_THAT(roles.assembly, ElementsAre(only(0)));
  EXPECT_THAT(roles.doubts, ElementsAre(HasSubstr("by its name")));
}

TEST(ProposedRoles, WhatCannotBeIsRefused) {
  EXPECT_THROW(roles_of({header("x", {"1:+X"})}), InputError);
  EXPECT_THROW(roles_of({header("x", {"1:+X"}), header("y", {"2:+X"})}), InputError);
  EXPECT_THROW(roles_of({header("x", {"1:+X"}), header("y", {"1:+X"}), header("z", {"1:+X"})}), InputError);
}

TEST(ProposedJoint, NodesThatLieClose) {
  const std::vector<frf::FrfHeader> parts = {
      header("x", {"1:+X", "2:+X", "3:+X", "3:+Y"}, {{1, {0, 0, 0}}, {2, {1, 0, 0}}, {3, {2, 0, 0}}}),
      header("y", {"7:+X", "8:+X", "9:+X"}, {{7, {2.1, 0, 0}}, {8, {3, 0, 0}}, {9, {4, 0, 0}}})};
  const tasks::ProposedJoint joint = tasks::propose_joint(pointers(parts));
  EXPECT_THAT(frf::names(joint.dofs), ElementsAre("3:+X", "3:+Y", "7:+X"));
}

TEST(ProposedJoint, TheNearestWhereNoneIsClose) {
  const std::vector<frf::FrfHeader> parts = {header("x", {"1:+X", "2:+X"}, {{1, {0, 0, 0}}, {2, {0.1, 0, 0}}}),
                                             header("y", {"7:+X", "8:+X"}, {{7, {2.1, 0, 0}}, {8, {2.2, 0, 0}}})};
  EXPECT_THAT(frf::names(tasks::propose_joint(pointers(parts)).dofs), ElementsAre("2:+X", "7:+X"));
}

TEST(ProposedJoint, WithoutPositionsItIsLeftToTheUser) {
  const tasks::ProposedJoint joint = tasks::propose_joint(pointers({header("x", {"1:+X"}), header("y", {"2:+X"})}));
  EXPECT_THAT(joint.dofs, IsEmpty());
  EXPECT_THAT(joint.doubts, ElementsAre(HasSubstr("name the DOFs")));
}

frf::FrfSet set_with_coherence(double good_from_hz, double good_to_hz) {
  frf::FrfSet set;
  set.header = header("m", {"1:+X"});
  set.header.frequency_hz.clear();
  set.header.noise = frf::NoiseRecord::coherence;
  set.header.averages = 5;
  for (int line = 0; line <= 100; ++line) {
    const double f = line;
    set.header.frequency_hz.push_back(f);
    set.values.emplace_back(1.0, 0.0);
    set.coherence.push_back(f >= good_from_hz && f <= good_to_hz ? 0.99 : 0.1);
  }
  return set;
}

TEST(ProposedRange, IsWhatAllFilesHave) {
  const auto a = frf::from_memory(set_with_coherence(0, 100)), b = frf::from_memory(set_with_coherence(0, 100));
  const tasks::ProposedRange range = tasks::propose_range({a.get(), b.get()});
  EXPECT_THAT(range.range_hz, testing::Optional(ElementsAre(1.0, 100.0)));  // not 0 Hz
}

TEST(ProposedRange, LeavesOutEndsWhereNoiseRules) {
  const auto a = frf::from_memory(set_with_coherence(10, 100)), b = frf::from_memory(set_with_coherence(0, 80));
  const tasks::ProposedRange range = tasks::propose_range({a.get(), b.get()});
  EXPECT_THAT(range.range_hz, testing::Optional(ElementsAre(10.0, 80.0)));
  EXPECT_THAT(range.reasons, ElementsAre(HasSubstr("noise rules")));
}

TEST(ProposedRange, NoFrequenciesInCommonIsAnError) {
  frf::FrfSet far = set_with_coherence(0, 100);
  for (double& f : far.header.frequency_hz) f += 1000.0;
  const auto a = frf::from_memory(set_with_coherence(0, 100)), b = frf::from_memory(far);
  EXPECT_THROW(tasks::propose_range({a.get(), b.get()}), InputError);
}

TEST(ProposedRange, CanBeInterrupted) {
  const auto a = frf::from_memory(set_with_coherence(0, 100));
  EXPECT_THROW(tasks::propose_range({a.get()}, [] { return true; }), Interrupted);
}

/// The files of a problem, and what its own scene says.
struct Written {
  TestFolder folder;
  Scene truth;
  std::vector<std::filesystem::path> files;

  explicit Written(const std::string& name) {
    truth = read_scene(problems::write(problems::make(name), folder, {.format = "uff"}));
    for (const auto* part : {&truth.data.assembly, &truth.data.substructures}) {
      for (const DataFile& file : *part) files.push_back(file.path);
    }
  }
  Scene proposed() const { return parse_scene(tasks::scene_text(tasks::propose_scene(files), folder), folder / "new.toml"); }
};

std::vector<Path> paths(const std::vector<DataFile>& files) {
  std::vector<Path> all;
  for (const DataFile& file : files) all.push_back(file.path);
  return all;
}

TEST(ProposedScene, OfRigOneIsTheRigsOwn) {
  const Written written("rig1");
  const Scene proposed = written.proposed();
  EXPECT_EQ(paths(proposed.data.substructures), paths(written.truth.data.substructures));
  EXPECT_EQ(paths(proposed.data.assembly), paths(written.truth.data.assembly));
  EXPECT_EQ(proposed.joints.front().dofs, written.truth.joints.front().dofs);
  EXPECT_EQ(proposed.frequency.range_hz, written.truth.frequency.range_hz);
  EXPECT_EQ(make_plan(proposed)->restriction.unknowns.size(), 20U);
}

TEST(ProposedScene, OfManyBoltsHasASpringForEveryPairAndDirection) {
  const Written written("bolts");
  const Scene proposed = written.proposed();
  EXPECT_EQ(proposed.joints.front().dofs, written.truth.joints.front().dofs);
  const auto unknowns = make_plan(proposed)->restriction.unknowns, truth = make_plan(written.truth)->restriction.unknowns;
  ASSERT_EQ(unknowns.size(), 24U);  // of 600 that full matrices have
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_EQ(unknowns[i].name, truth[i].name);
}

TEST(ProposedScene, FilesThatAreNoJointAreShown) {
  const std::string text = tasks::look_text({"/d/a.uff", "/d/b.uff"}, "/d", "No joint.");
  EXPECT_THAT(text, testing::StartsWith("# No joint.\n"));
  EXPECT_THROW(parse_scene(text, "/d/scene.toml"), InputError);
  EXPECT_EQ(parse_readable(text, "/d/scene.toml")->data.substructures.at(1).path, "/d/b.uff");
}

TEST(ProposedScene, NamesOfFilesAreQuoted) {
  tasks::ProposedScene proposed;
  proposed.substructures = {{"a \"b\"\\c.uff"}};
  proposed.assembly = {{"run\n1.uff", "run2.uff"}};
  proposed.joint = {frf::Dof::parse("1:+X"), frf::Dof::parse("2:+X")};
  proposed.reasons = {"run\n1.uff and " + std::string(200, 'x') + " \x01 are runs"};
  const Scene scene = parse_scene(tasks::scene_text(proposed, ""), "scene.toml");
  EXPECT_EQ(scene.data.substructures.front().path.filename(), "a \"b\"\\c.uff");
  EXPECT_EQ(scene.data.assembly.front().path.filename(), "run\n1.uff");
  EXPECT_EQ(scene.data.assembly.front().repeats.size(), 1U);
}

}  // namespace
}  // namespace jointid::ident
