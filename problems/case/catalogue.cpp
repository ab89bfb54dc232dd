#include "problems/case/catalogue.hpp"

#include <utility>

namespace jointid::problems {
namespace {

void append(std::vector<Case>& all, std::vector<Case> more) {
  for (Case& definition : more) all.push_back(std::move(definition));
}

}  // namespace

std::vector<Case> all_cases() {
  std::vector<Case> all = cases_of_basic_study();
  append(all, cases_of_refined_weighting());
  append(all, cases_of_accuracy());
  append(all, cases_of_hard_joints());
  append(all, cases_of_other_data());
  append(all, cases_of_rig_one());
  append(all, cases_of_bolts());
  return all;
}

}  // namespace jointid::problems
