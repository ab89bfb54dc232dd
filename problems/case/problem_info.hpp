#pragma once

#include <string>
#include <vector>

namespace jointid::problems {

struct ProblemInfo {
  std::string name;
  std::string description;
};

/// Throws InputError (usage): `problem`, e.g. "there is no problem 'A'", with the nearest of `names` to `name`, or that they are
/// listed; `more` behind that.
[[noreturn]] void refuse_problem(const std::string& problem, const std::string& name, const std::vector<std::string>& names,
                                 const std::string& more = {});

}  // namespace jointid::problems
