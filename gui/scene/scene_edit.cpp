#include "gui/scene/scene_edit.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "gui/scene/several_edit.hpp"
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

std::string written(const std::vector<frf::NodeLine>& lines) {
  std::string text = "[";
  for (const auto& [from, to] : lines)
    text += (text.size() > 1 ? ", [" : "[") + std::to_string(from) + ", " + std::to_string(to) + "]";
  return text + "]";
}

namespace {

std::string with_regeneration(const std::string& text, const ident::Regeneration& regenerate) {
  if (!regenerate.any()) return without_value(text, "data", "regenerate");
  std::string systems = regenerate.substructures ? "\"substructures\"" : "";
  if (regenerate.assembly) systems += systems.empty() ? "\"assembly\"" : ", \"assembly\"";
  return with_value(text, "data", "regenerate", "[" + systems + "]");
}

constexpr const char* forms[] = {"pattern", "matrix", "springs"};

/// A matrix of [joint] declared in one way, whatever it was before; the table stays where it was.
std::string with_matrix(std::string text, const std::string& matrix, const std::string& form, const std::string& value) {
  const std::string table = "joint." + matrix;
  text = with_value(without_value(text, "joint", matrix), table, form, value);
  for (const char* other : forms) {
    if (other != form) text = without_value(text, table, other);
  }
  return text;
}

std::string without_matrix(std::string text, const std::string& matrix) {
  text = without_value(text, "joint", matrix);
  for (const char* form : forms) text = without_value(text, "joint." + matrix, form);
  return without_value(text, "joint." + matrix, "definite");
}

}  // namespace

namespace {

/// The virtual points of a plate in place of those that the text had.
std::string with_plate(std::string text, const tasks::Plate& plate) {
  while (several_in(text, "virtual_points") > 0) text = without_one(text, "virtual_points", 1);
  for (const std::size_t side : {0U, 1U}) text = with_one_more(std::move(text), "virtual_points", tasks::virtual_point_text(plate, side));
  return text;
}

}  // namespace

std::string with_joint(std::string text, const tasks::JointLayout& layout) {
  if (layout.plate) text = with_plate(std::move(text), *layout.plate);
  const bool full = layout.form == tasks::JointForm::full;
  const std::string form = full ? "pattern" : "springs", value = full ? "\"symmetric\"" : tasks::springs_text(layout);
  text = with_value(text, "joint", "dofs", written(tasks::dofs_of(layout)));
  text = with_matrix(std::move(text), "stiffness", form, value);
  return layout.damping ? with_matrix(std::move(text), "hysteretic_damping", form, value)
                        : without_matrix(std::move(text), "hysteretic_damping");
}

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
