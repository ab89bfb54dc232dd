// How well does a test see the joint? A Monte-Carlo study on FRFs in memory with simulated noise of 1 %.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "ident/scene/read_scene.hpp"
#include "study/trial_data.hpp"
#include "tasks/study/run_study.hpp"
#include "two_structures.hpp"

using namespace jointid;

int main() {
  const ident::Scene scene = ident::parse_scene(std::string(examples::scene) + R"(
    [truth]
    stiffness = [[3e5, -3e5], [-3e5, 3e5]]
    hysteretic_damping = [[3e3, -3e3], [-3e3, 3e3]]
    [noise]
    model = "gaussian"
    level = 0.01
  )",
                                                "in memory");
  const auto data = study::make_trial_data(scene, {{examples::structure_1(), examples::structure_2()}, {examples::assembly()}});

  study::StudyOptions options;
  options.trials = 50;
  options.out = std::filesystem::temp_directory_path() / "jointid_example_study.h5";  // keeps every trial
  study::StudyControl control;
  control.interrupted = [] { return false; };  // a way to stop; control.progress beside it
  const tasks::StudyResult result = tasks::run_study(data, options, control);
  std::filesystem::remove(options.out);

  std::cout << result.statistics.usable << " of " << result.statistics.trials << " trials gave an estimate\n";
  for (const study::UnknownStatistics& unknown : result.statistics.unknowns) {
    std::cout << unknown.name << ": mean " << unknown.mean << ", standard deviation " << unknown.std_deviation << ' '
              << unknown.unit << '\n';
  }
  const study::UnknownStatistics& stiffness = result.statistics.unknowns.front();
  const bool sees = std::abs(stiffness.mean - 3e5) < 0.05 * 3e5 && stiffness.std_deviation > 0.0;
  return result.run.complete && result.statistics.usable == 50 && sees ? EXIT_SUCCESS : EXIT_FAILURE;
}
