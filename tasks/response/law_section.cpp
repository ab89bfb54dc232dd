
#include "base/text.hpp"
#include "friction/law/generalized_slip.hpp"
#include "friction/law/laws.hpp"
#include "friction/path/parallel.hpp"
#include "friction/path/series.hpp"
#include "tasks/response/response_sections.hpp"

namespace jointid::tasks {
namespace {

using Law = std::shared_ptr<const friction::Element>;

/// Parameters in the order of the law, from a list or a table by name.
std::vector<double> read_parameters(const scene::Item& item, const friction::Law& law) {
  std::vector<std::string> names;
  for (const friction::LawParameter& parameter : law.parameters) names.emplace_back(parameter.name);
  std::vector<double> values;
  if (item.is_table()) {
    const scene::Table table = item.table(names);
    for (const std::string& name : names) values.push_back(table.require(name).number());
    return values;
  }
  const std::vector<scene::Item> list = item.list();
  if (list.size() != names.size()) {
    item.fail("law " + std::string(law.name) + " has " + std::to_string(names.size()) + " parameters, here are " +
                  std::to_string(list.size()),
              "give " + comma_list(names));
  }
  for (const scene::Item& value : list) values.push_back(value.number());
  return values;
}

/// { k = stiffness, slip = [[share, displacement], …] }.
Law read_generalised(const scene::Item& item) {
  const scene::Table table = item.table({"k", "slip"});
  std::vector<friction::SlipPoint> points;
  for (const scene::Item& point : table.require("slip").list_not_empty()) {
    const std::vector<scene::Item> pair = point.list();
    if (pair.size() != 2) point.fail("a point is [share that slips, displacement]");
    points.push_back({pair[0].number(), pair[1].number()});
  }
  return std::make_shared<friction::GeneralizedSlip>(table.require("k").positive(), std::move(points));
}

friction::Parts read_parts(const scene::Item& item) {
  friction::Parts parts;
  for (const scene::Item& part : item.list_not_empty()) {
    const scene::Table table = part.table({"law", "parameters", "parts"});
    table.require("law");
    parts.push_back(read_friction(table));
  }
  return parts;
}

Law read_listed(const std::string& name, const scene::Table& table) {
  const friction::Law& law = friction::law(name);
  return friction::make_element(law.name, read_parameters(table.require("parameters"), law));
}

Law made(const std::string& name, const scene::Table& table) {
  if (name == "series") return std::make_shared<friction::Series>(read_parts(table.require("parts")));
  if (name == "parallel") return std::make_shared<friction::Parallel>(read_parts(table.require("parts")));
  return name == "generalised" ? read_generalised(table.require("parameters")) : read_listed(name, table);
}

}  // namespace

Law read_friction(const scene::Table& table) {
  const auto law = table.find("law"), parameters = table.find("parameters"), parts = table.find("parts");
  if (!law) {
    if (parameters) parameters->fail("there are parameters and no law", "name the law");
    if (parts) parts->fail("there are parts and no law", "name the law: series or parallel");
    return nullptr;
  }
  const std::string name = law->text_not_empty();
  const bool composed = name == "series" || name == "parallel";
  if (composed && parameters) parameters->fail("law " + name + " has the parameters of its parts", "give each part its own");
  if (!composed && parts) parts->fail("law " + name + " has no parts", "only series and parallel have");
  try {
    return made(name, table);
  } catch (const InputError& error) {
    if (!error.parts().place.empty()) throw;
    const std::string& problem = error.parts().problem;
    law->fail(problem.starts_with("no friction law") ? problem + ", generalised, series, parallel" : problem);
  }
}

}  // namespace jointid::tasks
