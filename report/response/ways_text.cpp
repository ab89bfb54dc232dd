#include "report/response/ways_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

using response::IterationResult;
using response::WayResult;

Table ways_table(const tasks::WaysResult& run) {
  Table table(
      {{"way", Align::left}, {"max |x| m"}, {"its error"}, {"error of X"}, {"of x(t)"}, {"time ms"}, {"periods"}, {"steps"}});
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

bool is_increment(const IterationResult& way) { return way.reached.has_value(); }

std::string ended(const IterationResult& way) {
  if (way.converged()) return way.searches > 0 ? fmt::format("converged, {} shortened", way.searches) : "converged";
  return way.state == "limit" ? "no convergence" : way.state;
}

Table iterations_table(const tasks::WaysResult& run) {
  Table table({{"way", Align::left},
               {"from", Align::left},
               {"harmonics to"},
               {"ended", Align::left},
               {"steps"},
               {"factor"},
               {"error of X"},
               {"time ms"}});
  for (const IterationResult& way : run.iterations) {
    if (is_increment(way)) continue;
    table.add({way.way, way.start.empty() ? "–" : way.start, fmt::format("{}", way.largest_harmonic), ended(way),
               fmt::format("{}", way.steps), way.factor ? fmt::format("{:.2g}", *way.factor) : "–",
               way.of_amplitude ? fmt::format("{:.1e}", *way.of_amplitude) : "–", fmt::format("{:.3g}", 1e3 * way.seconds)});
  }
  return table;
}

Table increments_table(const tasks::WaysResult& run) {
  Table table({{"increments", Align::left}, {"Newton steps"}, {"ended", Align::left}, {"error of X"}, {"time ms"}});
  for (const IterationResult& way : run.iterations) {
    if (!is_increment(way)) continue;
    table.add({way.way, fmt::format("{}", way.steps),
               way.converged() ? "converged" : fmt::format("failed at {:.3g}", *way.reached),
               way.of_amplitude ? fmt::format("{:.1e}", *way.of_amplitude) : "–", fmt::format("{:.3g}", 1e3 * way.seconds)});
  }
  return table;
}

std::string iterations_text(const tasks::WaysResult& run) {
  if (run.iterations.empty()) return "";
  std::string text = "\nways to the solution of harmonic balance; below a factor of 1 a way converges from nearby\n";
  text += iterations_table(run).text();
  return text + "\n" + increments_table(run).text();
}

Json iteration_json(const IterationResult& way) {
  Json motion = Json::array();
  for (Eigen::Index n = 0; n < way.joint_motion.rows(); ++n) {
    Json harmonic = Json::array();
    for (const Complex q : way.joint_motion.row(n)) harmonic.push_back(Json::array({value(q.real()), value(q.imag())}));
    motion.push_back(std::move(harmonic));
  }
  return {{"way", way.way},
          {"start", way.start.empty() ? Json() : Json(way.start)},
          {"largest_harmonic", way.largest_harmonic},
          {"state", way.state},
          {"steps", way.steps},
          {"shortened_steps", way.searches},
          {"seconds", value(way.seconds)},
          {"convergence_factor", value(way.factor)},
          {"last_share", value(way.reached)},
          {"error_of_amplitude", value(way.of_amplitude)},
          {"joint_motion", std::move(motion)}};
}

}  // namespace

std::string ways_text(const tasks::ResponseScene& scene, const std::vector<tasks::WaysResult>& runs) {
  std::string text = scene.title.empty() ? "" : scene.title + "\n";
  text += fmt::format("response of {} by all ways, errors against the exact orbit\n", scene.responses.front().name);
  for (const tasks::WaysResult& run : runs) {
    text += fmt::format("\n{:.6g} N, {:.6g} Hz\n{}", run.level, run.frequency_hz, ways_table(run).text());
    if (run.ways.front().residual_force_free)
      text +=
          "a joint never slips fully: the mean depends on the past, and with it max |x|; X and x(t) are compared without it\n";
    if (!run.ways.front().found) text += "no exact orbit was found, so there is nothing to compare with\n";
    text += iterations_text(run);
  }
  return text;
}

std::string ways_json(const tasks::ResponseScene& scene, const std::vector<tasks::WaysResult>& runs) {
  Json out = {
      {"status", all_known(runs) ? "ok" : "not_converged"}, {"dof", scene.responses.front().name}, {"cases", Json::array()}};
  for (const tasks::WaysResult& run : runs) {
    Json one = {{"force", value(run.level)},
                {"frequency", value(run.frequency_hz)},
                {"residual_force_free", run.ways.front().residual_force_free},
                {"ways", Json::array()}};
    for (const WayResult& way : run.ways) {
      const auto known = [&](double figure) { return way.found ? value(figure) : Json(); };
      one["ways"].push_back({{"way", way.way},
                             {"found", way.found},
                             {"seconds", value(way.seconds)},
                             {"periods", value(way.periods)},
                             {"steps", way.steps},
                             {"largest", known(way.largest)},
                             {"error_of_largest", known(way.of_largest)},
                             {"error_of_amplitude", known(way.of_amplitude)},
                             {"error_of_motion", known(way.of_motion)}});
    }
    one["iterations"] = Json::array();
    for (const IterationResult& way : run.iterations) one["iterations"].push_back(iteration_json(way));
    out["cases"].push_back(std::move(one));
  }
  return json_text(out);
}

std::string ways_csv(const std::vector<tasks::WaysResult>& runs) {
  std::string text = csv_line({"force [N]", "frequency [Hz]", "way", "largest [m]", "error of largest", "error of amplitude",
                               "error of motion", "time [s]", "periods", "steps"});
  for (const tasks::WaysResult& run : runs) {
    for (const WayResult& way : run.ways) {
      const auto known = [&](double figure) { return way.found ? csv_number(figure) : std::string(); };
      text += csv_line({csv_number(run.level), csv_number(run.frequency_hz), way.way, known(way.largest), known(way.of_largest),
                        known(way.of_amplitude), known(way.of_motion), csv_number(way.seconds), csv_number(way.periods),
                        fmt::format("{}", way.steps)});
    }
    for (const IterationResult& way : run.iterations) {
      const std::string name = way.start.empty() ? way.way : way.way + ", " + way.start;
      text += csv_line({csv_number(run.level), csv_number(run.frequency_hz),
                        fmt::format("{}, harmonics to {}", name, way.largest_harmonic), "", "",
                        way.of_amplitude ? csv_number(*way.of_amplitude) : "", "", csv_number(way.seconds), "",
                        fmt::format("{}", way.steps)});
    }
  }
  return text;
}

}  // namespace jointid::report
