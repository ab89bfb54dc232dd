#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"
#include "frf/file/write.hpp"
#include "response/structure/matrix_receptance.hpp"
#include "response/structure/modal_damping.hpp"
#include "tasks/response/read_response_scene.hpp"
#include "tasks/response/response_result.hpp"
#include "tasks/response/run_response.hpp"
#include "tests/test_folder.hpp"

/// A scene of `response` with matrices, and parts written as files.
namespace jointid::tasks {

inline const std::string chain = R"(
[structure]
mass = [[1.0, 0.0, 0.0], [0.0, 1.2, 0.0], [0.0, 0.0, 0.9]]
stiffness = [[500.0, -200.0, 0.0], [-200.0, 250.0, -50.0], [0.0, -50.0, 150.0]]
damping = [[0.5, -0.16, 0.0], [-0.16, 0.32, -0.04], [0.0, -0.04, 0.21]]
)";

inline const std::string rest = R"(
[[joints]]
dofs = [2, 3]
law = "ren"
parameters = { a = 0.004, b = 1.5, k = 150.0 }

[force]
dof = 1
amplitudes = [1.0, 3.0]

[frequency]
range = [2.0, 4.0]
points = 41

[response]
dofs = [1, 3]
harmonics = [1, 3, 5]
)";

/// Curves and equivalent joints.
inline const std::string further = R"(
[[curves]]
along = "force"
frequency = 3.0
range = [0.5, 8.0]

[[curves]]
along = "k"
joint = 1
frequency = 3.0
range = [150.0, 60.0]

[equivalent]
amplitudes = [1e-3, 1e-2, 1e-1]
mode = 2
)";

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return text.replace(place, what.size(), by);
}

inline std::string error_of(const std::string& text) {
  try {
    parse_response_scene(text, "scene.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

/// FRFs of single coordinates of a structure, written as a file.
inline void write_part(const std::filesystem::path& path, const response::MatrixStructure& structure, int first_node) {
  const Eigen::Index n = structure.mass.rows();
  const Eigen::MatrixXd none(n, 0), all = Eigen::MatrixXd::Identity(n, n);
  const response::MatrixReceptance receptance(structure, none, all, all);
  frf::FrfSet set;
  for (int line = 1; line <= 400; ++line) set.header.frequency_hz.push_back(0.05 * line);
  for (Eigen::Index i = 0; i < n; ++i) set.header.response.push_back({first_node + static_cast<int>(i), frf::Direction::x, 1});
  set.header.reference = set.header.response;
  for (const double hz : set.header.frequency_hz) {
    const Eigen::MatrixXcd h = receptance.at(angular(hz));
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) set.values.push_back(h(i, j));
    }
  }
  frf::write(set, path);
}

/// The two parts of the scene below: two masses, nodes 1 and 2, and one, node 3.
inline void write_parts(const TestFolder& folder) {
  Eigen::MatrixXd k1(2, 2), k2(1, 1);
  k1 << 500.0, -200.0, -200.0, 210.0;
  k2 << 90.0;
  const Eigen::MatrixXd m1 = Eigen::MatrixXd::Identity(2, 2), m2 = Eigen::MatrixXd::Identity(1, 1);
  write_part(folder / "one.csv", {m1, response::modal_damping(m1, k1, 0.02), k1}, 1);
  write_part(folder / "two.csv", {m2, response::modal_damping(m2, k2, 0.02), k2}, 3);
}

inline const std::string sample_joint = "law = \"bilinear\"\nparameters = [0.01, 150.0]\n";

inline std::string parts_scene(const std::string& frequency, const std::string& harmonics) {
  return "[data]\nparts = [\"one.csv\", \"two.csv\"]\n[[joints]]\ndofs = [\"2:+X\", \"3:+X\"]\n" + sample_joint +
         "[force]\ndof = \"1:+X\"\namplitudes = [8.0]\n[frequency]\n" + frequency +
         "[response]\ndofs = [\"1:+X\", \"3:+X\"]\nharmonics = " + harmonics + "\n";
}

inline ResponseResult run_parts(const std::string& text, const TestFolder& folder) {
  return run_response(parse_response_scene(text, folder / "scene.toml"));
}

}  // namespace jointid::tasks
