// The joint that other programs get: of a scene and of its result, with signs, errors and covariance.
#include "tasks/export/exported_joint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/problem.hpp"
#include "report/solution_json.hpp"

namespace jointid::tasks {
namespace {

using restrictions::Kind;
using testing::HasSubstr;

class ExportedJointOf : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("exported_joint_" + std::to_string(::getpid()) + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  void expect_refused(const std::string& text, const std::string& problem) const {
    try {
      exported_joint(write("result.json", text));
      ADD_FAILURE() << "accepted, not: " << problem;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(problem));
      EXPECT_FALSE(error.parts().remedy.empty()) << problem;
    }
  }

  std::filesystem::path folder_;
};

const std::string result = R"json({
  "status": "ok",
  "unknowns": [{"name": "K(1,2)", "value": -2e6, "unit": "N/m", "std_error": 3e3, "determined": true},
               {"name": "K(1,1)", "value": 1e6, "unit": "N/m", "std_error": 4e3},
               {"name": "K.k", "value": 5.0, "unit": "N/m", "std_error": null, "error_estimate": 0.1}],
  "matrices": {"stiffness": [[1e6, -2e6], [-2e6, 5.0]]},
  "dofs": ["4:+Y", "5:-Y"]
})json";

TEST_F(ExportedJointOf, ResultHasPositiveDirectionsAndErrorsOfElements) {
  const ExportedJoint joint = exported_joint(write("result.json", result));
  EXPECT_EQ(frf::names(joint.dofs), (std::vector<std::string>{"4:+Y", "5:+Y"}));
  EXPECT_EQ(joint.matrices.at(Kind::stiffness), (ident::Matrix{{1e6, 2e6}, {2e6, 5.0}}));
  EXPECT_EQ(joint.errors.at(Kind::stiffness)[0][1], 3e3);
  EXPECT_EQ(joint.errors.at(Kind::stiffness)[0][0], 4e3);
  EXPECT_TRUE(std::isnan(joint.errors.at(Kind::stiffness)[1][1]));  // an unknown whose place its name does not say
  EXPECT_EQ(joint.covariance[1][1], 16e6);
  EXPECT_TRUE(std::isnan(joint.covariance[0][1]));
}

TEST_F(ExportedJointOf, HostileResultsAreOneErrorWithARemedy) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = result;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  expect_refused("{", "no JSON");
  expect_refused("{\"verdict\": \"clean\"}", "it is not there");
  expect_refused(with("\"ok\"", "\"poor_fit\""), "not usable");
  expect_refused(with("\"ok\"", "7"), "is no text");
  expect_refused(with("\"5:-Y\"", "\"4:-Y\""), "twice");
  expect_refused(with("\"5:-Y\"", "\"0:-Y\""), "node number");
  expect_refused(with("\"4:+Y\", \"5:-Y\"", ""), "no list of DOFs");
  expect_refused(with("[-2e6, 5.0]", "[-2e6]"), "2 × 2");
  expect_refused(with("[-2e6, 5.0]", "[-2e6, null]"), "no finite number");
  expect_refused(with("{\"stiffness\": [[1e6, -2e6], [-2e6, 5.0]]}", "null"), "no matrix");
  expect_refused(with("\"status\"", "\"bands\": [{}, {}], \"status\""), "2 bands");
}

/// Of a scene the covariance is whole, and its element errors agree with those of its result.
TEST_F(ExportedJointOf, SceneAndItsResultAgree) {
  const auto scene = problems::write(problems::make("A1"), folder_, {});
  std::ifstream in(scene);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t begin = text.find("[identify]"), end = text.find("\n[", begin);
  text.replace(begin, end == std::string::npos ? end : end - begin, "[identify]\nmethod = \"likelihood\"\n");
  const std::filesystem::path changed = write("scene.toml", text);
  const ExportedJoint joint = exported_joint(changed);
  const auto plan = ident::make_plan(ident::read_scene(changed));
  const ExportedJoint again = exported_joint(write("again.json", report::solution_json(ident::solve(*plan))));
  ASSERT_EQ(joint.dofs, again.dofs);
  for (const auto& [kind, rows] : joint.matrices) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < rows.size(); ++j)
        EXPECT_NEAR(rows[i][j], again.matrices.at(kind)[i][j], 1e-12 * std::abs(rows[i][j]));
    }
  }
  for (std::size_t c = 0; c < joint.unknowns.size(); ++c) {
    ASSERT_TRUE(joint.unknowns[c].error());
    EXPECT_NEAR(joint.covariance[c][c], std::pow(*joint.unknowns[c].error(), 2), 1e-9 * joint.covariance[c][c]);
    for (std::size_t d = 0; d < c; ++d) {
      EXPECT_EQ(joint.covariance[c][d], joint.covariance[d][c]);
      EXPECT_LT(std::abs(joint.covariance[c][d]), std::sqrt(joint.covariance[c][c] * joint.covariance[d][d]));
    }
  }
  EXPECT_THROW(exported_joint(changed, 2), InputError);
}

}  // namespace
}  // namespace jointid::tasks
