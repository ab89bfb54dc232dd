#include "report/loading_curve/joint_history_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

bool is_cyclic(const tasks::JointHistory& history) { return !history.mean.empty(); }

/// Of cycles the energy of each, of turns the work since the beginning.
Table parts_table(const tasks::JointHistory& history) {
  const bool cyclic = is_cyclic(history);
  Table table({{cyclic ? "cycle" : "turn"}, {"u m"}, {"F N"}, {cyclic ? "energy J" : "work J"}, {cyclic ? "mean F N" : ""}});
  for (std::size_t i = 0; i < history.ends.size(); ++i) {
    const tasks::HistoryPoint& end = history.points[history.ends[i]];
    table.add({std::to_string(i + 1), number(end.displacement), number(end.force), number(history.work[i]),
               cyclic ? number(history.mean[i]) : ""});
  }
  return table;
}

Table shares_table(const tasks::JointHistoryScene& scene, const tasks::JointHistory& history) {
  Table table({{"share slipped"}, {"u m"}});
  for (std::size_t i = 0; i < scene.shares.size(); ++i) {
    const double u = history.slip_displacements[i];
    table.add({number(scene.shares[i]), std::isfinite(u) ? number(u) : "never"});
  }
  return table;
}

template <class Of>
Json column(const tasks::JointHistory& history, const Of& of) {
  Json list = Json::array();
  for (const tasks::HistoryPoint& point : history.points) list.push_back(value(of(point)));
  return list;
}

}  // namespace

std::string joint_history_text(const tasks::JointHistoryScene& scene, const tasks::JointHistory& history) {
  std::string text = scene.title.empty() ? "" : scene.title + "\n";
  text += fmt::format("initial stiffness {} N/m, limit {}\n", number(history.stiffness),
                      history.limit ? number(*history.limit) + " N" : std::string("none"));
  if (scene.sliders > 0) text += fmt::format("algorithm A with {} sliders\n", scene.sliders);
  for (const tasks::HistoryPoint& kink : history.kinks) {
    if (history.kinks.size() <= 4) text += fmt::format("kink at {} m, {} N\n", number(kink.displacement), number(kink.force));
  }
  if (!scene.shares.empty()) text += shares_table(scene, history).text();
  return text + parts_table(history).text() + fmt::format("{} points: --csv FILE or --json FILE\n", history.points.size());
}

std::string joint_history_json(const tasks::JointHistoryScene& scene, const tasks::JointHistory& history) {
  Json out = {{"status", "ok"},
              {"title", scene.title},
              {"stiffness", value(history.stiffness)},
              {"limit", value(history.limit)},
              {"sliders", scene.sliders},
              {"kinks", Json::array()},
              {"parts", Json::array()}};
  for (const tasks::HistoryPoint& kink : history.kinks)
    out["kinks"].push_back(Json::array({value(kink.displacement), value(kink.force)}));
  for (std::size_t i = 0; i < history.ends.size(); ++i) {
    const tasks::HistoryPoint& end = history.points[history.ends[i]];
    Json part = {{"displacement", value(end.displacement)}, {"force", value(end.force)}, {"work", value(history.work[i])}};
    if (is_cyclic(history)) part["mean_force"] = value(history.mean[i]);
    if (i < history.nodes.size()) {
      part["node_displacements"] = values(history.nodes[i].displacement);
      part["node_forces"] = values(history.nodes[i].force);
    }
    out["parts"].push_back(std::move(part));
  }
  for (std::size_t i = 0; i < scene.shares.size(); ++i)
    out["slip_shares"].push_back(Json::array({value(scene.shares[i]), value(history.slip_displacements[i])}));
  out["displacement"] = column(history, [](const tasks::HistoryPoint& p) { return p.displacement; });
  out["force"] = column(history, [](const tasks::HistoryPoint& p) { return p.force; });
  if (!scene.normal.empty()) out["normal_load"] = column(history, [](const tasks::HistoryPoint& p) { return p.load; });
  return json_text(out);
}

std::string joint_history_csv(const tasks::JointHistoryScene& scene, const tasks::JointHistory& history) {
  std::vector<std::string> header = {"joint displacement [m]", "force [N]"};
  if (!scene.normal.empty()) header.emplace_back("share of the nominal normal load");
  std::string text = csv_line(header);
  for (const tasks::HistoryPoint& point : history.points) {
    std::vector<std::string> cells = {csv_number(point.displacement), csv_number(point.force)};
    if (!scene.normal.empty()) cells.push_back(csv_number(point.load));
    text += csv_line(cells);
  }
  return text;
}

}  // namespace jointid::report
