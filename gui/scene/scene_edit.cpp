#include "gui/scene/scene_edit.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "gui/scene/toml_edit.hpp"

namespace jointid::gui {

std::string written(const std::vector<ident::Range>& ranges) {
  std::string text = "[";
  for (const auto& [low, high] : ranges) {
    text += (text.size() > 1 ? ", [" : "[") + digits(low, "%.10g") + ", " + digits(high, "%.10g") + "]";
  }
  return text + "]";
}

std::string written(const std::vector<frf::Dof>& dofs) {
  std::string text = "[";
  for (const frf::Dof& dof : dofs) text += (text.size() > 1 ? ", \"" : "\"") + dof.name() + "\"";
  return text + "]";
}

namespace {

std::string with_regeneration(const std::string& text, const ident::Regeneration& regenerate) {
  if (!regenerate.any()) return without_value(text, "data", "regenerate");
  std::string systems = regenerate.substructures ? "\"substructures\"" : "";
  if (regenerate.assembly) systems += systems.empty() ? "\"assembly\"" : ", \"assembly\"";
  return with_value(text, "data", "regenerate", "[" + systems + "]");
}

}  // namespace

std::string with_way(std::string text, const study::Way& way) {
  const auto word = [](const std::string& value) { return '"' + value + '"'; };
  const auto set = [&text](const char* key, const std::string& value) { text = with_value(text, "identify", key, value); };
  const std::string equations = comma_list(way.equations, [&](ident::Equation equation) { return word(ident::name(equation)); });
  set("method", word(ident::name(way.method)));
  if (!equations.empty()) set("equations", "[" + equations + "]");
  text = with_regeneration(text, way.regenerate);
  set("solver", word(name(way.solver)));
  if (!ident::weighs_equations(way.method)) return text;
  set("weighting", word(weighting::name(way.weighting)));
  set("delta", digits(way.delta, "%.10g"));
  return text;
}

std::vector<ident::Range> with_range(std::vector<ident::Range> ranges, const ident::Range& more) {
  ranges.push_back(more);
  std::ranges::sort(ranges);
  std::vector<ident::Range> out;
  for (const ident::Range& range : ranges) {
    if (!out.empty() && range[0] <= out.back()[1])
      out.back()[1] = std::max(out.back()[1], range[1]);
    else
      out.push_back(range);
  }
  return out;
}

}  // namespace jointid::gui
