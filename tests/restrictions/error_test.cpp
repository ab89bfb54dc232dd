#include <gmock/gmock.h>

#include <limits>

#include "base/error.hpp"
#include "tests/restrictions/joints.hpp"

namespace jointid::restrictions {
namespace {

using ::testing::HasSubstr;

void expect_error(const std::vector<JointSpec>& joints, const std::vector<std::string>& fragments) {
  try {
    build(joints);
    FAIL() << fragments[0];
  } catch (const InputError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    for (const std::string& fragment : fragments) EXPECT_THAT(error.what(), HasSubstr(fragment));
  }
}

JointSpec stiff(MatrixSpec spec) { return joint(beam_dofs(), Kind::stiffness, std::move(spec)); }

JointSpec named(const std::string& name, const std::vector<std::string>& names) {
  JointSpec spec = joint(dofs(names), Kind::stiffness, Pattern::full);
  spec.name = name;
  return spec;
}

TEST(RestrictionErrors, Joints) {
  expect_error({}, {"there is no joint", "[[joints]]"});
  expect_error({named("", {"1:+X"}), named("b", {"2:+X"})}, {"no name"});
  expect_error({named("b", {"1:+X"}), named("b", {"2:+X"})}, {"joint 'b'", "two joints have this name"});
  expect_error({named("a", {"1:+X"}), named("b", {"1:-X"})}, {"joint 'b'", "1:-X is a DOF of joint 'a', too"});
  expect_error({named("", {"1:+X", "2:+X", "1:-X"})}, {"[joint]", "coordinate of 1:-X twice"});
  expect_error({named("", {})}, {"[joint]", "dofs is empty"});
  JointSpec empty = named("", {"1:+X"});
  empty.matrices.clear();
  expect_error({empty}, {"[joint]", "no matrix", "hysteretic_damping"});
}

TEST(RestrictionErrors, MatricesOfEntries) {
  const EntryMatrix row = {{"a", "b", "c", "d"}};
  expect_error({stiff(row)}, {"[joint.stiffness]", "1 rows", "4 DOFs"});
  expect_error({stiff(EntryMatrix(4, {"a", "b"}))}, {"[joint.stiffness]", "row 1 has 2 elements", "4 DOFs"});
  EntryMatrix entries(4, row[0]);
  entries[2][1] = "a*b";
  expect_error({stiff(entries)}, {"[joint.stiffness]", "element (3,2): 'a*b' multiplies", "character 2", "linear"});
  entries[2][1] = std::numeric_limits<double>::infinity();
  expect_error({stiff(entries)}, {"element (3,2) is not finite"});
  JointSpec left = stiff(row);
  left.name = "left";
  expect_error({left}, {"joint 'left', stiffness"});
}

TEST(RestrictionErrors, Springs) {
  using Springs = std::vector<Spring>;
  expect_error({stiff(Springs{})}, {"list of springs is empty"});
  expect_error({stiff(Springs{spring("4:+X", "5:+Y")})}, {"4:+X is not a DOF of the joint", "did you mean 4:+Y?"});
  expect_error({stiff(Springs{spring("4:+Y", "1234567890:+Y")})}, {"1234567890:+Y is not a DOF", "add it to dofs"});
  expect_error({stiff(Springs{spring("4:+Y", "4:-Y")})}, {"both ends on one DOF", "ground"});
  expect_error({stiff(Springs{spring("4:+Y", "5:+RZ")})}, {"joins a translation and a rotation"});
  expect_error({stiff(Springs{spring("4:+Y", "5:+Y"), spring("5:+Y", "4:+Y")})},
               {"[4:+Y,5:+Y] and [5:+Y,4:+Y] are parallel"});
  expect_error({stiff(Springs{spring("4:+Y", "5:+Y"), spring("4:-Y", "5:-Y")})}, {"parallel"});
  expect_error({stiff(Springs{spring("4:+Y", "ground"), spring("4:-Y", "ground")})}, {"parallel"});
}

TEST(RestrictionErrors, PatternFree) {
  JointSpec spec = stiff(Pattern::free);
  spec.node_positions[4] = {0, 0, 0};
  expect_error({spec}, {"[joint.stiffness]", "position of node 5", "\"5\" = [x, y, z]", "[nodes]"});
  spec.node_positions[5] = {0, std::nan(""), 0};
  expect_error({spec}, {"node 5 is out of range"});
  JointSpec single = joint(dofs({"4:+Y"}), Kind::stiffness, Pattern::free);
  single.node_positions[4] = {0, 0, 0};
  expect_error({single}, {"rigid-body motion", "no unknown"});
  JointSpec large = joint({}, Kind::stiffness, Pattern::free);
  for (std::int64_t node = 0; node < 100; ++node) {
    large.dofs.push_back({.node = node});
    large.node_positions[node] = {0, 1.0 * static_cast<double>(node), 0};
  }
  expect_error({large}, {"of 100 DOFs is too large", "use springs"});
}

}  // namespace
}  // namespace jointid::restrictions
