#include "tasks/response/response_ways.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "tasks/response/prepared.hpp"
#include "tasks/tell.hpp"

namespace jointid::tasks {
namespace {

void require_case(const ResponseScene& scene) {
  const auto fail = [&](std::string problem, std::string remedy) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = scene.file.string(),
                      .place = "--compare",
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  };
  if (!marches(scene)) {
    fail("the exact motion needs mass, damping and stiffness, of at most " + std::to_string(most_full) + " coordinates or modes",
         "give [structure], and modes in it");
  }
  if (scene.values_hz.empty() || scene.levels.empty()) fail("there is no case", "give [force], and [frequency] values");
}

}  // namespace

std::vector<WaysResult> compare_responses(const ResponseScene& scene, const ident::Control& control) {
  require_case(scene);
  const Prepared prepared = prepare(scene, control);
  std::vector<WaysResult> runs;
  for (const double level : scene.levels) {
    for (const double hz : scene.values_hz) {
      response::WaysAsked asked;
      asked.begin = [&](const std::string& way) {
        tell(control, fmt::format("{:.6g} N, {:.6g} Hz: {}", level, hz, way));
        stop_if(control.interrupted);
      };
      const response::MatrixAssembly& assembly = *prepared.marched;
      const Eigen::VectorXd place = prepared.responses.col(0);
      WaysResult& run = runs.emplace_back(WaysResult{.level = level, .frequency_hz = hz, .ways = {}});
      run.ways = response::compare_ways(assembly, scene.force, angular(hz), level, place, asked);
      response::IterationsAsked iterations{.begin = asked.begin};
      if (run.ways.front().found) iterations.exact = run.ways.front().amplitude;
      run.iterations = response::compare_iterations(assembly, scene.force, angular(hz), level, place, iterations);
    }
  }
  return runs;
}

bool all_known(const std::vector<WaysResult>& runs) {
  return std::ranges::all_of(runs, [](const WaysResult& run) { return run.ways.front().found; });
}

}  // namespace jointid::tasks
