#include "cli/solve/estimate_kept.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace jointid::cli {
namespace {

using Json = nlohmann::json;

bool is_finite(const ident::Matrices& matrices) {
  return std::ranges::all_of(matrices, [](const auto& each) {
    return std::ranges::all_of(each.second, [](const std::vector<double>& row) {
      return std::ranges::all_of(row, [](double value) { return std::isfinite(value); });
    });
  });
}

}  // namespace

std::string EstimateKept::state_of(const ident::Solution& best) const {
  if (is_loose_ || !ident::traits(best.used.method).iterates || best.bands.size() != 1) return "";
  if (!is_finite(best.bands.front().matrices)) return "";
  Json matrices = Json::object();
  for (const auto& [kind, matrix] : best.bands.front().matrices) matrices[restrictions::key(kind)] = matrix;
  return Json({{"method", ident::name(best.used.method)}, {"chosen", best.used.chosen}, {"matrices", matrices}}).dump() + "\n";
}

void EstimateKept::take_up(ident::Scene& scene) {
  const auto before = state_.read();
  if (!before) return;
  try {
    const Json told = Json::parse(*before);
    scene.identify.method = ident::parse_method(told.at("method"));
    scene.identify.automatic = false;
    chosen_ = told.at("chosen");
    scene.identify.start.clear();
    for (const auto kind : restrictions::all_kinds) {
      if (const auto found = told.at("matrices").find(restrictions::key(kind)); found != told.at("matrices").end())
        scene.identify.start[kind] = found->get<ident::Matrix>();
    }
  } catch (const Json::exception&) {
    throw InputError({ErrorKind::data, state_.file().string(), "--resume", "is no state of this command", "remove the file to start anew"});
  }
}

void EstimateKept::put(const ident::Solution& best) {
  if (!from_start_ || (put_ && seconds_since(*put_) < 1.0)) return;
  const std::string state = state_of(best);
  if (state.empty()) return;
  state_.put(state);
  put_ = Clock::now();
}

std::string EstimateKept::words(const ident::Solution& best) {
  const std::string state = state_of(best);
  if (state.empty()) return "";
  const std::string why = state_.why_not_put(state);
  if (!why.empty()) return ", for --resume they are not kept: " + why;
  return ", " + state_.file().string() + " keeps them, the same command with --resume continues";
}

}  // namespace jointid::cli
