#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tasks/response/read_response_scene.hpp"
#include "tasks/response/run_response.hpp"

/// [transient] normal, weight, reference_stiffness, start, method newmark.
namespace jointid::tasks {
namespace {

std::string scene(const std::string& transient) {
  return R"([structure]
mass = [[1.0]]
stiffness = [[1e4]]
damping = [[2.0]]

[[joints]]
dofs = [1]
name = "slider"
law = "bilinear"
parameters = [1e-4, 3e4]

[force]
dof = 1
amplitudes = [5.0]

[frequency]
values = [12.7]

[response]
dofs = [1]

[transient]
duration = 0.1
step = 0.002
)" + transient;
}

Eigen::MatrixXd motion_of(const std::string& transient) {
  return run_response(parse_response_scene(scene(transient), "scene.toml")).transients.at(0).motion.x;
}

std::string error_of(const std::string& transient) {
  try {
    parse_response_scene(scene(transient), "scene.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const std::string one = "method = \"one\"\ndelta = 1e-4\n", two = "method = \"two\"\ndelta = 1e-4\n";

TEST(TransientOptions, ANormalLoadChangesTheMotion) {
  const std::string nominal = "normal = [{ joint = \"slider\", load = [[0.0, 7.0]], nominal = 7.0, sliders = 1 }]\n";
  const std::string doubled = "normal = [{ joint = 1, load = [[0.0, 14.0]], nominal = 7.0, sliders = 1 }]\n";
  const Eigen::MatrixXd without = motion_of(one);
  EXPECT_LT((motion_of(one + nominal) - without).norm(), 1e-12 * without.norm());
  EXPECT_GT((motion_of(one + doubled) - without).norm(), 0.01 * without.norm());
  // Twice the limit is the law with twice the slip displacement.
  std::string text = scene(one);
  text.replace(text.find("1e-4, 3e4"), 9, "2e-4, 3e4");
  const Eigen::MatrixXd wide = run_response(parse_response_scene(text, "scene.toml")).transients.at(0).motion.x;
  EXPECT_LT((motion_of(one + doubled) - wide).norm(), 1e-12 * wide.norm());
}

TEST(TransientOptions, OfAlgorithmTwoAreThoseAskedFor) {
  const Eigen::MatrixXd usual = motion_of(two);
  EXPECT_EQ(motion_of(two + "weight = 0.333333333333333333\nreference_stiffness = [3e4]\nstart = \"one\"\n"), usual);
  EXPECT_NE(motion_of(two + "weight = 0.25\n"), usual);
  EXPECT_NE(motion_of(two + "reference_stiffness = [4e4]\n"), usual);
  EXPECT_NE(motion_of(two + "start = \"straight\"\n"), usual);
  EXPECT_LT((motion_of("method = \"newmark\"\ndelta = 1e-4\n") - motion_of(one)).norm(), 1e-7 * usual.norm());
}

TEST(TransientOptions, SayWhatIsWrong) {
  const std::string load = "load = [[0.0, 7.0], [0.05, 9.0]], nominal = 7.0";
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"normal = [{ joint = 1, " + load + " }]\n", "event-exact marching knows one normal load"},
      {one + "normal = [{ joint = 2, " + load + " }]\n", "joint"},
      {one + "normal = [{ joint = \"slidr\", " + load + " }]\n", "did you mean slider"},
      {one + "normal = [{ joint = 1, load = [[0.1, 1.0], [0.0, 1.0]], nominal = 1.0 }]\n", "times must ascend"},
      {one + "normal = [{ joint = 1, load = [[0.1]], nominal = 1.0 }]\n", "a point of the normal load"},
      {one + "normal = [{ joint = 1, " + load + ", period = 0.01 }]\n", "is shorter than the last time"},
      {one + "normal = [{ joint = 1, " + load + " }, { joint = 1, " + load + " }]\n", "has a normal load already"},
      {one + "weight = 0.25\n", "is of Algorithm Two"},
      {two + "weight = 0.75\n", "above 0.5"},
      {two + "reference_stiffness = [1.0, 2.0]\n", "one for each of [[joints]]"},
      {two + "start = \"two\"\n", "straight"},
  };
  for (const auto& [text, words] : wrong)
    EXPECT_NE(error_of(text).find(words), std::string::npos) << error_of(text) << "\n" << words;
}

}  // namespace
}  // namespace jointid::tasks
