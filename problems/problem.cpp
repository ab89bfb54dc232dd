#include "problems/problem.hpp"

#include "problems/case/catalogue.hpp"
#include "problems/case/coupling_problem.hpp"
#include "problems/case/flange.hpp"
#include "problems/case/many_joints_problem.hpp"
#include "problems/case/modal_set.hpp"

namespace jointid::problems {

std::vector<ProblemInfo> list() {
  std::vector<ProblemInfo> result;
  for (const Case& definition : all_cases()) result.push_back({definition.name, definition.description});
  return result;
}

Problem make(const std::string& name) {
  if (is_flange(name)) return make_flange(name);
  if (is_many_joints(name)) return make_many_joints(name);
  std::vector<std::string> names;
  for (const ProblemInfo& info : list_flanges()) names.push_back(info.name);
  for (const ProblemInfo& info : list_many_joints()) names.push_back(info.name);
  for (const Case& definition : all_cases()) {
    if (definition.name == name) return build(definition);
    names.push_back(definition.name);
  }
  for (const ProblemInfo& info : list_coupling()) names.push_back(info.name);
  for (const ProblemInfo& info : list_modal_sets()) names.push_back(info.name);
  refuse_problem("there is no problem '" + name + "'", name, names);
}

}  // namespace jointid::problems
