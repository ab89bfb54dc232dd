#include "cli/response/comparison_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "cli/text/interrupt.hpp"
#include "report/json_value.hpp"
#include "report/response/prepared.hpp"
#include "report/response/response_scene.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
namespace {

using response::WayResult;

void require_case(const report::ResponseScene& scene) {
  const auto fail = [&](std::string problem, std::string remedy) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = scene.file.string(),
                      .place = "--compare",
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  };
  if (!report::marches(scene)) {
    fail("the exact motion needs mass, damping and stiffness, of at most " + std::to_string(report::most_full) +
             " coordinates or modes",
         "give [structure], and modes in it");
  }
  if (scene.values_hz.empty() || scene.levels.empty()) fail("there is no case", "give [force], and [frequency] values");
}

report::Table ways_table(const WaysRun& run) {
  report::Table table({{"way", report::Align::left},
                       {"max |x| m"},
                       {"its error"},
                       {"error of X"},
                       {"of x(t)"},
                       {"time ms"},
                       {"periods"},
                       {"steps"}});
  for (const WayResult& way : run.ways) {
    std::vector<std::string> cells = {way.way};
    if (way.found) {
      const bool exact = &way == &run.ways.front();
      cells.push_back(fmt::format("{:.7g}", way.largest));
      for (const double error : {way.of_largest, way.of_amplitude, way.of_motion}) {
        cells.push_back(exact ? "–" : fmt::format("{:.1e}", error));
      }
    } else {
      cells.insert(cells.end(), {"not found", "–", "–", "–"});
    }
    cells.push_back(fmt::format("{:.3g}", 1e3 * way.seconds));
    cells.push_back(way.periods > 0.0 ? fmt::format("{:.0f}", way.periods) : "–");
    cells.push_back(way.steps > 0 ? fmt::format("{}", way.steps) : "–");
    table.add(cells);
  }
  return table;
}

}  // namespace

std::vector<WaysRun> run_comparison(const report::ResponseScene& scene, Progress& progress) {
  require_case(scene);
  const report::Prepared prepared = report::prepare(scene, progress.control());
  std::vector<WaysRun> runs;
  for (const double level : scene.levels) {
    for (const double hz : scene.values_hz) {
      response::WaysAsked asked;
      asked.begin = [&](const std::string& way) {
        progress.show(fmt::format("{:.6g} N, {:.6g} Hz: {}", level, hz, way));
        stop_if(interrupted);
      };
      runs.push_back(
          {level, hz,
           response::compare_ways(*prepared.marched, scene.force, angular(hz), level, prepared.responses.col(0), asked)});
    }
  }
  return runs;
}

bool all_known(const std::vector<WaysRun>& runs) {
  return std::ranges::all_of(runs, [](const WaysRun& run) { return run.ways.front().found; });
}

std::string comparison_text(const report::ResponseScene& scene, const std::vector<WaysRun>& runs) {
  std::string text = scene.title.empty() ? "" : scene.title + "\n";
  text += fmt::format("response of {} by all ways, errors against the exact orbit\n", scene.responses.front().name);
  for (const WaysRun& run : runs) {
    text += fmt::format("\n{:.6g} N, {:.6g} Hz\n{}", run.level, run.frequency_hz, ways_table(run).text());
    if (run.ways.front().residual_force_free)
      text +=
          "a joint never slips fully: the mean depends on the past, and with it max |x|; X and x(t) are compared without it\n";
    if (!run.ways.front().found) text += "no exact orbit was found, so there is nothing to compare with\n";
  }
  return text;
}

std::string comparison_json(const report::ResponseScene& scene, const std::vector<WaysRun>& runs) {
  report::Json out = {{"status", all_known(runs) ? "ok" : "not_converged"},
                      {"dof", scene.responses.front().name},
                      {"cases", report::Json::array()}};
  for (const WaysRun& run : runs) {
    report::Json one = {{"force", report::value(run.level)},
                        {"frequency", report::value(run.frequency_hz)},
                        {"residual_force_free", run.ways.front().residual_force_free},
                        {"ways", report::Json::array()}};
    for (const WayResult& way : run.ways) {
      const auto known = [&](double figure) { return way.found ? report::value(figure) : report::Json(); };
      one["ways"].push_back({{"way", way.way},
                             {"found", way.found},
                             {"seconds", report::value(way.seconds)},
                             {"periods", report::value(way.periods)},
                             {"steps", way.steps},
                             {"largest", known(way.largest)},
                             {"error_of_largest", known(way.of_largest)},
                             {"error_of_amplitude", known(way.of_amplitude)},
                             {"error_of_motion", known(way.of_motion)}});
    }
    out["cases"].push_back(std::move(one));
  }
  return report::json_text(out);
}

std::string comparison_csv(const std::vector<WaysRun>& runs) {
  std::string text = report::csv_line({"force [N]", "frequency [Hz]", "way", "largest [m]", "error of largest",
                                       "error of amplitude", "error of motion", "time [s]", "periods", "steps"});
  for (const WaysRun& run : runs) {
    for (const WayResult& way : run.ways) {
      const auto known = [&](double figure) { return way.found ? report::csv_number(figure) : std::string(); };
      text += report::csv_line({report::csv_number(run.level), report::csv_number(run.frequency_hz), way.way, known(way.largest),
                                known(way.of_largest), known(way.of_amplitude), known(way.of_motion),
                                report::csv_number(way.seconds), report::csv_number(way.periods), fmt::format("{}", way.steps)});
    }
  }
  return text;
}

}  // namespace jointid::cli
