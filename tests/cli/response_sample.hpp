#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"
#include "cli/response/response_parts.hpp"
#include "frf/file/write.hpp"
#include "response/structure/matrix_receptance.hpp"
#include "tests/test_folder.hpp"

/// A scene of `response` with matrices, and parts written as files.
namespace jointid::cli {

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

}  // namespace jointid::cli
