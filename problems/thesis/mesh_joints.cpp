#include "problems/thesis/mesh_joints.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/temporary_file.hpp"
#include "problems/thesis/shortest_text.hpp"

namespace jointid::problems {
namespace {

constexpr double slip_a = 5e-8, slip_b = 3.0, slip_k = 2e12;  ///< m, 1, N/m³: Ren's law per area of case Three

std::string uniform_bar(double length, const std::string& law) {
  return "youngs_modulus = 2.06e11\nwidth = 0.01\nheight = 0.01\nlength = " + shortest_text(length) + "\nmembers = 20\n" + law;
}

std::string ren_law() {
  return "law = \"ren\"\nparameters = [" + shortest_text(slip_a) + ", " + shortest_text(slip_b) + ", " + shortest_text(slip_k) +
         "]\n";
}

/// A bilinear law that slips at `displacement` and has the limit of Ren's.
std::string bilinear_law(double displacement) {
  const double limit = slip_k * slip_a * std::expm1(slip_b) / slip_b;
  return "law = \"bilinear\"\nparameters = [" + shortest_text(displacement) + ", " + shortest_text(limit / displacement) + "]\n";
}

std::string bar_of_table() {
  return "youngs_modulus = 2.06e11\nwidth = 0.01\n"
         "lengths = [0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.02, 0.02, 0.02, "
         "0.02, "
         "0.02]\n"
         "heights = [0.005, 0.006, 0.007, 0.008, 0.01, 0.011, 0.012, 0.013, 0.014, 0.015, 0.017, 0.018, 0.019, 0.02, 0.02, 0.02, "
         "0.018, "
         "0.014, 0.01, 0.008]\n" +
         ren_law() +
         "stiffness = [1e12, 2e12, 3e12, 4e12, 5e12, 6e12, 7e12, 8e12, 9e12, 10e12, 10e12, 10e12, 10e12, 8e12, 6e12, 4e12, 3e12, "
         "2e12, "
         "2e12, 1e12, 1e12]  # per node, N/m3\n";
}

/// Where a bilinear law of the same initial stiffness slips.
double same_stiffness() { return slip_a * std::expm1(slip_b) / slip_b; }
/// Where Ren's law has slipped altogether.
double same_macroslip() { return slip_a * std::exp(slip_b); }

}  // namespace

const std::vector<MeshJoint>& list_mesh_joints() {
  constexpr double limit_a = 6361.845641063, limit_b = 636.1845641063;
  static const std::vector<MeshJoint> all = {
      {"mesh-two", "case Two, the bar of Table 2.8 (§2.16.2)", bar_of_table(), 3864.821226946, 1.746526151778e-5},
      {"mesh-three-A", "case Three A, 1 m on Ren's law (§2.16.2)", uniform_bar(1.0, ren_law()), limit_a, 1.253083302913e-4},
      {"mesh-three-A-stiffness", "case Three A, bilinear with the stiffness of Ren's law (§2.16.2)",
       uniform_bar(1.0, bilinear_law(same_stiffness())), limit_a, 1.251966817477e-4},
      {"mesh-three-A-macroslip", "case Three A, bilinear with the macroslip of Ren's law (§2.16.2)",
       uniform_bar(1.0, bilinear_law(same_macroslip())), limit_a, 1.255597037748e-4},
      {"mesh-three-B", "case Three B, 0.1 m on Ren's law (§2.16.2)", uniform_bar(0.1, ren_law()), limit_b, 1.680107959908e-6},
      {"mesh-three-B-stiffness", "case Three B, bilinear with the stiffness of Ren's law (§2.16.2)",
       uniform_bar(0.1, bilinear_law(same_stiffness())), limit_b, 1.465036070825e-6},
      {"mesh-three-B-macroslip", "case Three B, bilinear with the macroslip of Ren's law (§2.16.2)",
       uniform_bar(0.1, bilinear_law(same_macroslip())), limit_b, 2.00272777526e-6},
  };
  return all;
}

const MeshJoint* find_mesh_joint(const std::string& name) {
  const auto found = std::ranges::find(list_mesh_joints(), name, &MeshJoint::name);
  return found == list_mesh_joints().end() ? nullptr : &*found;
}

std::filesystem::path write(const MeshJoint& problem, const std::filesystem::path& directory) {
  std::error_code ignored;  // a folder that cannot be made shows when the first file is written
  std::filesystem::create_directories(directory, ignored);
  const double force = 0.9 * problem.limit;
  const nlohmann::ordered_json truth = {{"name", problem.name},
                                        {"description", problem.description},
                                        {"limit", problem.limit},
                                        {"force", force},
                                        {"displacement", problem.displacement}};
  write_text(directory / "truth.json", truth.dump(1) + "\n");
  const std::filesystem::path scene = directory / (problem.name + ".toml");
  write_text(scene, "title = \"" + problem.name + ": " + problem.description + "\"\n\n[mesh]\n" + problem.mesh +
                        "\n[history]\nforces = [" + shortest_text(force) + ", " + shortest_text(-force) + "]  # N\n");
  return scene;
}

}  // namespace jointid::problems
