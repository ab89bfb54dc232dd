#include <array>

#include "problems/case/coupling_problem.hpp"
#include "problems/case/flange.hpp"
#include "problems/case/many_joints_problem.hpp"
#include "problems/case/modal_set.hpp"
#include "problems/kinds/problem_kind.hpp"
#include "problems/lines/line_problem.hpp"
#include "problems/problem.hpp"
#include "problems/solid/solid_blocks.hpp"
#include "problems/thesis/loading_curves.hpp"
#include "problems/thesis/mesh_joints.hpp"
#include "problems/thesis/oscillations.hpp"
#include "problems/thesis/pulses.hpp"
#include "problems/thesis/two_beams.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "problems/vibration/rig_two.hpp"

namespace jointid::problems {
namespace {

using Path = std::filesystem::path;
using Infos = std::vector<ProblemInfo>;

template <class Problem>
Infos infos_of(const std::vector<Problem>& problems) {
  Infos out;
  for (const Problem& each : problems) {
    if constexpr (requires { each.description(); }) {
      out.push_back({each.name, each.description()});
    } else {
      out.push_back({each.name, each.description});
    }
  }
  return out;
}

WrittenProblem write_loading_curve(const std::string& name, const Path& directory, const WriteOptions& options) {
  const auto& curve = *find_loading_curve(name);
  const auto file = write(curve, directory, options);
  return {file, "loading-curve " + file.string() + ' ' + fit_options(curve)};
}

WrittenProblem write_rig_two(const std::string& name, const Path& directory, const WriteOptions& options) {
  const auto scene = write(make_rig_two(name), directory, options);
  return {scene, "equivalent " + scene.string() + " --csv joint.csv"};
}

WrittenProblem write_two_beams(const std::string& name, const Path& directory, const WriteOptions&) {
  const auto scene = write(*find_two_beams(name), directory);
  return {scene, "response " + scene.string()};
}

WrittenProblem write_pulse(const std::string& name, const Path& directory, const WriteOptions&) {
  const auto scene = write(*find_pulse(name), directory);
  return {scene, "response " + scene.string() + " --history motion.csv"};
}

WrittenProblem write_mesh_joint(const std::string& name, const Path& directory, const WriteOptions&) {
  const auto scene = write(*find_mesh_joint(name), directory);
  return {scene, "loading-curve " + scene.string() + " --csv curve.csv"};
}

WrittenProblem write_law_problem(const std::string& name, const Path& directory, const WriteOptions& options) {
  const auto scene = write(make_law_problem(name), directory, options);
  return {scene, "solve " + scene.string()};
}

WrittenProblem write_oscillation(const std::string& name, const Path& directory, const WriteOptions&) {
  const auto scene = write(*find_oscillation(name), directory);
  return {scene, "oscillate " + scene.string() + " --report " + name + ".html"};
}

WrittenProblem write_line_problem(const std::string& name, const Path& directory, const WriteOptions& options) {
  const LineProblem problem = make_line_problem(name);
  const auto scene = write(problem, directory, options);
  return {scene, (problem.decouples ? "decouple " : "solve ") + scene.string()};
}

WrittenProblem write_solid_blocks(const std::string&, const Path& directory, const WriteOptions& options) {
  const auto scene = write(make_solid_blocks(), directory, options);
  return {scene, "solve " + scene.string()};
}

constexpr std::array every_kind = {
    ProblemKind{problems::list, write_identification_problem},
    ProblemKind{[] { return infos_of(loading_curves()); }, write_loading_curve},
    ProblemKind{list_flanges, write_identification_problem},
    ProblemKind{list_many_joints, write_identification_problem},
    ProblemKind{list_coupling, write_coupling_problem},
    ProblemKind{list_solid_blocks, write_solid_blocks},
    ProblemKind{list_line_problems, write_line_problem},
    ProblemKind{list_rig_two, write_rig_two},
    ProblemKind{list_modal_sets, write_modal_set},
    ProblemKind{[] { return infos_of(list_two_beams()); }, write_two_beams},
    ProblemKind{[] { return infos_of(list_pulses()); }, write_pulse},
    ProblemKind{[] { return infos_of(list_mesh_joints()); }, write_mesh_joint},
    ProblemKind{list_law_problems, write_law_problem},
    ProblemKind{[] { return infos_of(list_oscillations()); }, write_oscillation},
};

}  // namespace

std::span<const ProblemKind> all_kinds() { return every_kind; }

}  // namespace jointid::problems
