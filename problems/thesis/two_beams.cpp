#include "problems/thesis/two_beams.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/temporary_file.hpp"
#include "base/text.hpp"
#include "problems/structure/beam.hpp"
#include "problems/thesis/shortest_text.hpp"

namespace jointid::problems {
namespace {

constexpr BeamSection section = {.width = 0.05, .thickness = 0.012, .youngs_modulus = 2.07e11, .density = 7547.0};
constexpr double element_length = 0.1325;
constexpr std::array<std::size_t, 2> beam_elements = {5, 4};

/// Both cantilevers, clamped where they begin: the element's first node is left out of the first element.
Matrix assembled(const Matrix& element) {
  Matrix all(18, std::vector<double>(18, 0.0));
  std::size_t first = 0;
  for (const std::size_t count : beam_elements) {
    for (std::size_t e = 0; e < count; ++e) {
      for (std::size_t i = e == 0 ? 2 : 0; i < 4; ++i) {
        for (std::size_t j = e == 0 ? 2 : 0; j < 4; ++j) all[first + 2 * e + i - 2][first + 2 * e + j - 2] += element[i][j];
      }
    }
    first += 2 * count;
  }
  return all;
}

std::string market(const Matrix& matrix) {
  std::string entries;
  std::size_t count = 0;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      if (matrix[i][j] == 0.0) continue;
      entries += std::to_string(i + 1) + " " + std::to_string(j + 1) + " " + shortest_text(matrix[i][j]) + "\n";
      ++count;
    }
  }
  const std::string size = std::to_string(matrix.size());
  return "%%MatrixMarket matrix coordinate real symmetric\n" + size + " " + size + " " + std::to_string(count) + "\n" + entries;
}

std::string joint_text(const TwoBeams& problem, const std::string& dofs) {
  const std::string values = comma_list(problem.parameters, shortest_text);
  return "[[joints]]\ndofs = [" + dofs + "]\nlaw = \"" + problem.law + "\"\nparameters = [" + values + "]\n\n";
}

std::string scene_text(const TwoBeams& problem) {
  return "title = \"" + problem.name + ": " + problem.description + "\"\n\n[structure]\nmass = \"" + problem.name +
         "_mass.mtx\"\nstiffness = \"" + problem.name + "_stiffness.mtx\"\nmodal_damping = 0.01\n\n" +
         joint_text(problem, "5, 13") + joint_text(problem, "7") +
         "[force]\ndof = 5\namplitudes = [0.01, 0.1, 1.0, 2.0, 100.0]  # N\ncomponents = [[1, 1.0, -90.0]]       # a sine\n\n"
         "[frequency]\nvalues = [50.0]  # Hz; range = [20.0, 80.0] shows the resonances\n\n"
         "[response]\ndofs = [5, 7]\nharmonics = [1, 3, 5, 7, 9]\n";
}

}  // namespace

const std::vector<TwoBeams>& list_two_beams() {
  static const std::vector<TwoBeams> all = {
      {"beams-A", "two beams with linear joints, type A of Table 3.1", "spring", {1e6}},
      {"beams-B", "two beams with joints of type B of Table 3.1", "bilinear", {4e-7, 1e6}},
      {"beams-C", "two beams with joints of type C of Table 3.1", "bilinear", {4e-9, 1e8}},
      {"beams-D", "two beams with very stiff joints, type D of Table 3.1", "bilinear", {4e-11, 1e10}},
      {"beams-E", "two beams with microslip joints, type E of Table 3.1", "ren", {6.36e-8, 3.0, 1e6}},
  };
  return all;
}

const TwoBeams* find_two_beams(const std::string& name) {
  const auto found = std::ranges::find(list_two_beams(), name, &TwoBeams::name);
  return found == list_two_beams().end() ? nullptr : &*found;
}

Matrix two_beams_mass() { return assembled(element_mass(section, element_length)); }
Matrix two_beams_stiffness() { return assembled(element_stiffness(section, element_length)); }

std::filesystem::path write(const TwoBeams& problem, const std::filesystem::path& directory) {
  std::error_code ignored;  // a folder that cannot be made shows when the first file is written
  std::filesystem::create_directories(directory, ignored);
  const nlohmann::ordered_json truth = {{"name", problem.name}, {"description", problem.description}};
  write_text(directory / (problem.name + "_mass.mtx"), market(two_beams_mass()));
  write_text(directory / (problem.name + "_stiffness.mtx"), market(two_beams_stiffness()));
  write_text(directory / "truth.json", truth.dump(1) + "\n");
  const std::filesystem::path scene = directory / (problem.name + ".toml");
  write_text(scene, scene_text(problem));
  return scene;
}

}  // namespace jointid::problems
