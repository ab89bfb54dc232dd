#include "problems/case/problem_info.hpp"

#include "base/error.hpp"

namespace jointid::problems {

void refuse_problem(const std::string& problem, const std::string& name, const std::vector<std::string>& names,
                    const std::string& more) {
  const std::string near = nearest_word(name, names);
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "problem",
                    .problem = problem,
                    .remedy = (near.empty() ? "list the problems to see their names" : "did you mean " + near + "?") + more});
}

}  // namespace jointid::problems
