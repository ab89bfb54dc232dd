#include <cmath>

#include "tasks/response/response_sections.hpp"

namespace jointid::tasks {
namespace {

using response::TransientMethod;

const std::vector<std::string> march_methods = {"exact", "one", "two"};

constexpr double most_steps = 1e6;

SceneRecord read_record(const scene::Item& item, const ident::Path& folder, const ResponseScene& scene) {
  const scene::Table table = item.table({"dof", "file", "column", "unit", "factor", "rate", "time"});
  SceneRecord record;
  record.dof = read_dof(table.require("dof"), scene);
  record.file = {folder / table.require("file").text_not_empty(), "[transient] forces"};
  record.column = table.require("column").text_not_empty();
  if (const auto unit = table.find("unit")) record.unit = unit->text_not_empty();
  if (const auto factor = table.find("factor")) record.factor = factor->number();
  if (const auto rate = table.find("rate")) record.rate_hz = rate->positive();
  if (const auto time = table.find("time")) record.time = time->text_not_empty();
  return record;
}

ScenePulse read_pulse(const scene::Item& item, const ResponseScene& scene) {
  const scene::Table table = item.table({"dof", "amplitude", "length"});
  return {read_dof(table.require("dof"), scene), table.require("amplitude").number(), table.require("length").positive()};
}

/// Whole and above 0.
bool divides(double step, double whole) {
  const double count = std::round(whole / step);
  return count >= 1.0 && std::abs(whole / step - count) <= 1e-9 * count;
}

void read_method(const scene::Table& table, SceneTransient& transient) {
  const auto method = table.find("method"), delta = table.find("delta");
  if (method) {
    const std::string word = method->word(march_methods);
    transient.method = word == "exact" ? TransientMethod::exact
                       : word == "one" ? TransientMethod::algorithm_one
                                       : TransientMethod::algorithm_two;
  }
  if (transient.method == TransientMethod::exact) {
    if (delta) delta->fail("event-exact marching chooses its steps", "remove it, or give method = \"one\" or \"two\"");
    return;
  }
  transient.delta = table.require("delta").positive();
  if (!divides(transient.delta, transient.step)) {
    delta->fail("is not a whole part of step = " + scene::number_text(transient.step) + " s", "choose one that divides it");
  }
}

}  // namespace

SceneTransient read_transient(const scene::Item& item, const ident::Path& folder, const ResponseScene& scene) {
  const scene::Table table = item.table({"duration", "step", "method", "delta", "forces", "pulses"});
  require_marching(item, scene);
  SceneTransient transient;
  const scene::Item duration = table.require("duration");
  transient.duration = duration.positive();
  const auto step = table.find("step"), forces = table.find("forces"), pulses = table.find("pulses");
  transient.step = step ? step->positive() : transient.duration / 1000.0;
  if (!divides(transient.step, transient.duration))
    step->fail("is not a whole part of the duration", "choose one that divides it");
  if (transient.duration / transient.step > most_steps) duration.fail("has more than a million steps", "raise step");
  read_method(table, transient);
  if (forces && pulses) pulses->fail("there are both forces and pulses", "remove one");
  if (forces) {
    for (const scene::Item& force : forces->list_not_empty()) transient.records.push_back(read_record(force, folder, scene));
  }
  if (pulses) {
    for (const scene::Item& pulse : pulses->list_not_empty()) transient.pulses.push_back(read_pulse(pulse, scene));
  }
  return transient;
}

}  // namespace jointid::tasks
