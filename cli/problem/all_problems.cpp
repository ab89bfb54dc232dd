#include "cli/problem/all_problems.hpp"

#include <array>

#include "cli/problem/problem_command.hpp"
#include "problems/case/coupling_problem.hpp"
#include "problems/case/flange.hpp"
#include "problems/case/modal_set.hpp"
#include "problems/problem.hpp"
#include "problems/thesis/loading_curves.hpp"
#include "problems/thesis/oscillations.hpp"
#include "problems/thesis/pulses.hpp"
#include "problems/thesis/two_beams.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "problems/vibration/rig_two.hpp"

namespace jointid::cli {
namespace {

using Path = std::filesystem::path;
using Infos = std::vector<problems::ProblemInfo>;

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

WrittenProblem write_loading_curve(const std::string& name, const Path& directory, const problems::WriteOptions& options) {
  const auto& curve = *problems::find_loading_curve(name);
  const auto file = problems::write(curve, directory, options);
  return {file, "loading-curve " + file.string() + ' ' + problems::fit_options(curve)};
}

WrittenProblem write_rig_two(const std::string& name, const Path& directory, const problems::WriteOptions& options) {
  const auto scene = problems::write(problems::make_rig_two(name), directory, options);
  return {scene, "equivalent " + scene.string() + " --csv joint.csv"};
}

WrittenProblem write_two_beams(const std::string& name, const Path& directory, const problems::WriteOptions&) {
  const auto scene = problems::write(*problems::find_two_beams(name), directory);
  return {scene, "response " + scene.string()};
}

WrittenProblem write_pulse(const std::string& name, const Path& directory, const problems::WriteOptions&) {
  const auto scene = problems::write(*problems::find_pulse(name), directory);
  return {scene, "response " + scene.string() + " --history motion.csv"};
}

WrittenProblem write_law_problem(const std::string& name, const Path& directory, const problems::WriteOptions& options) {
  const auto scene = problems::write(problems::make_law_problem(name), directory, options);
  return {scene, "solve " + scene.string()};
}

WrittenProblem write_oscillation(const std::string& name, const Path& directory, const problems::WriteOptions&) {
  const auto scene = problems::write(*problems::find_oscillation(name), directory);
  return {scene, "oscillate " + scene.string() + " --report " + name + ".html"};
}

constexpr std::array all_kinds = {
    ProblemKind{problems::list, write_identification_problem},
    ProblemKind{[] { return infos_of(problems::loading_curves()); }, write_loading_curve},
    ProblemKind{problems::list_flanges, write_identification_problem},
    ProblemKind{problems::list_coupling, write_coupling_problem},
    ProblemKind{problems::list_rig_two, write_rig_two},
    ProblemKind{problems::list_modal_sets, write_modal_set},
    ProblemKind{[] { return infos_of(problems::list_two_beams()); }, write_two_beams},
    ProblemKind{[] { return infos_of(problems::list_pulses()); }, write_pulse},
    ProblemKind{problems::list_law_problems, write_law_problem},
    ProblemKind{[] { return infos_of(problems::list_oscillations()); }, write_oscillation},
};

}  // namespace

void add_problem(CLI::App& app, Chosen& chosen) { declare_problem(app, chosen, {.kinds = all_kinds, .all = true}); }

}  // namespace jointid::cli
