#include <algorithm>
#include <cmath>

#include "tasks/response/response_sections.hpp"

namespace jointid::tasks {
namespace {

using response::TransientMethod;

const std::vector<std::string> march_methods = {"exact", "one", "two", "newmark"}, march_starts = {"one", "straight"};

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

/// { joint, load = [[time, N], …], nominal = N, period, sliders }
SceneNormal read_normal(const scene::Item& item, const ResponseScene& scene) {
  const scene::Table table = item.table({"joint", "load", "nominal", "period", "sliders"});
  SceneNormal normal;
  const scene::Item joint = table.require("joint"), load = table.require("load");
  normal.joint = read_joint_place(joint, scene);
  if (!scene.joints[normal.joint].joint.friction) joint.fail("has no friction", "name a joint with a law");
  const double nominal = table.require("nominal").positive();
  for (const scene::Item& one : load.list_not_empty()) {
    const std::vector<scene::Item> row = one.list();
    if (row.size() != 2) one.fail("a point of the normal load is [time in s, force in N]");
    const double time = row[0].not_negative();
    if (!normal.load.times.empty() && time <= normal.load.times.back()) row[0].fail("times must ascend");
    normal.load.times.push_back(time);
    normal.load.shares.push_back(row[1].number() / nominal);
  }
  if (const auto period = table.find("period")) {
    normal.load.period = period->positive();
    if (normal.load.times.back() > normal.load.period)
      period->fail("is shorter than the last time", "give the times of one period");
  }
  if (const auto sliders = table.find("sliders")) normal.load.sliders = static_cast<std::size_t>(sliders->whole(1, 10000));
  return normal;
}

/// What Algorithm Two alone may be told: weight a of (3.34), k_r of each joint, and how it starts.
void read_two(const scene::Table& table, const ResponseScene& scene, SceneTransient& transient) {
  const auto weight = table.find("weight"), stiffness = table.find("reference_stiffness"), start = table.find("start");
  for (const auto& key : {weight, stiffness, start}) {
    if (key && transient.method != TransientMethod::algorithm_two)
      key->fail("is of Algorithm Two", "give method = \"two\", or remove it");
  }
  if (weight) {
    transient.two.weight = weight->not_negative();
    if (transient.two.weight > 0.5) weight->fail("is above 0.5", "give one from 0 to 0.5; 1/3 is usual");
  }
  if (stiffness) {
    for (const scene::Item& each : stiffness->list_not_empty()) transient.reference_stiffness.push_back(each.not_negative());
    if (transient.reference_stiffness.size() != scene.joints.size())
      stiffness->fail("has " + std::to_string(transient.reference_stiffness.size()) + " values",
                      "give one for each of [[joints]]");
  }
  if (start) transient.two.starts_by_algorithm_one = start->word(march_starts) == "one";
}

void read_method(const scene::Table& table, SceneTransient& transient) {
  const auto method = table.find("method"), delta = table.find("delta");
  if (method) {
    const std::string word = method->word(march_methods);
    transient.method = word == "exact" ? TransientMethod::exact
                       : word == "one" ? TransientMethod::algorithm_one
                       : word == "two" ? TransientMethod::algorithm_two
                                       : TransientMethod::newmark;
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
  const scene::Table table =
      item.table({"duration", "step", "method", "delta", "forces", "pulses", "normal", "weight", "reference_stiffness", "start"});
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
  read_two(table, scene, transient);
  if (const auto normal = table.find("normal")) {
    if (transient.method == TransientMethod::exact)
      normal->fail("event-exact marching knows one normal load", "give method = \"one\" or \"two\", and delta");
    for (const scene::Item& each : normal->list_not_empty()) {
      transient.normal.push_back(read_normal(each, scene));
      const auto same = [&](const SceneNormal& other) { return other.joint == transient.normal.back().joint; };
      if (std::ranges::count_if(transient.normal, same) > 1) each.fail("the joint has a normal load already", "give it one");
    }
  }
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
