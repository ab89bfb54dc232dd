#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ident/identify.hpp"
#include "tests/require.hpp"

namespace jointid::ident {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using restrictions::Kind;

fs::path folder() { return fs::path(JOINTID_EXTERNAL_DATA).parent_path() / "golden"; }

/// "nn+nj/WA/0.1"
IdentifySection identify_section(const std::string& key) {
  IdentifySection identify;
  std::istringstream text(key);
  std::string equations, word;
  std::getline(text, equations, '/');
  std::istringstream names(equations);
  for (std::string equation; std::getline(names, equation, '+');) {
    for (const Equation each : {Equation::nn, Equation::nj, Equation::jj, Equation::jn}) {
      if (name(each) == equation) identify.equations.push_back(each);
    }
  }
  std::getline(text, word, '/');
  identify.weighting = weighting::parse_weighting(word);
  text >> identify.delta;
  return identify;
}

restrictions::MatrixSpec matrix_spec(const std::string& problem) {
  if (problem != "caseB_noise5") return restrictions::Pattern::symmetric;
  return restrictions::EntryMatrix{
      {"a", "c", "e", "d"}, {"c", "b", "-d", "f"}, {"e", "-d", "a", "-c"}, {"d", "f", "-c", "b"}};
}

Scene scene_of(const std::string& problem, const json& expected) {
  Scene scene;
  scene.data.substructures = {{folder() / (problem + "_substructures.h5"), {}}};
  scene.data.assembly = {{folder() / (problem + "_assembly.h5"), {}}};
  restrictions::JointSpec joint;
  for (const json& dof : expected["joint_dofs"]) joint.dofs.push_back(frf::Dof::parse(dof.get<std::string>()));
  joint.matrices[Kind::stiffness] = matrix_spec(problem);
  joint.matrices[Kind::hysteretic_damping] = matrix_spec(problem);
  if (problem == "caseB_noise5") joint.matrices[Kind::mass] = matrix_spec(problem);
  scene.joints = {joint};
  return scene;
}

void expect_estimate(const Solution& solution, const json& names, const json& values) {
  std::map<char, double> largest;  // by the first letter: K, M, D
  std::map<std::string, double> value;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string unknown = names[i];
    value[unknown] = values[i];
    largest[unknown[0]] = std::max(largest[unknown[0]], std::abs(value[unknown]));
  }
  ASSERT_EQ(solution.unknowns.size(), value.size());
  for (const Estimate& estimate : solution.unknowns) {
    ASSERT_TRUE(value.contains(estimate.name)) << estimate.name;
    EXPECT_LE(std::abs(estimate.value - value[estimate.name]), 1e-8 * largest[estimate.name[0]]) << estimate.name;
  }
}

class GoldenEstimates : public ::testing::TestWithParam<const char*> {};

TEST_P(GoldenEstimates, EqualThoseOfAnIndependentProgram) {
  if (!fs::exists(folder() / "expected.json")) {
    JOINTID_SKIP("no reference files at " << folder() << "; set JOINTID_EXTERNAL_DATA");
  }
  const std::string problem = GetParam();
  const json expected = json::parse(std::ifstream(folder() / "expected.json")).at(problem);
  Scene scene = scene_of(problem, expected);
  ASSERT_GE(expected["estimates"].size(), 10u);
  for (const auto& [key, values] : expected["estimates"].items()) {
    SCOPED_TRACE(key);
    scene.identify = identify_section(key);
    const auto plan = make_plan(scene);
    const Solution solution = solve(*plan);
    EXPECT_EQ(solution.status, Status::ok);
    expect_estimate(solution, expected["unknowns"], values);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, GoldenEstimates, ::testing::Values("caseA1_clean", "caseA1_noise5", "caseB_noise5"));

}  // namespace
}  // namespace jointid::ident
