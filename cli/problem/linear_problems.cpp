#include <array>

#include "cli/problem/problem_kind.hpp"
#include "problems/case/coupling_problem.hpp"
#include "problems/case/flange.hpp"
#include "problems/case/modal_set.hpp"
#include "problems/problem.hpp"

namespace jointid::cli {
namespace {

constexpr std::array linear_kinds = {
    ProblemKind{problems::list, write_identification_problem},
    ProblemKind{problems::list_flanges, write_identification_problem},
    ProblemKind{problems::list_coupling, write_coupling_problem},
    ProblemKind{problems::list_modal_sets, write_modal_set},
};

}  // namespace

ProblemKinds linear_problems() { return {.kinds = linear_kinds, .all = false}; }

WrittenProblem write_identification_problem(const std::string& name, const std::filesystem::path& directory,
                                            const problems::WriteOptions& options) {
  const auto scene = problems::write(problems::make(name), directory, options);
  return {scene, "solve " + scene.string()};
}

WrittenProblem write_coupling_problem(const std::string& name, const std::filesystem::path& directory,
                                      const problems::WriteOptions& options) {
  const auto scene = problems::write(problems::make_coupling(name), directory, options);
  return {scene, "couple " + scene.string()};
}

WrittenProblem write_modal_set(const std::string& name, const std::filesystem::path& directory,
                               const problems::WriteOptions& options) {
  const auto file = problems::write(problems::make_modal_set(name), directory, options);
  return {file, "modalfit " + file.string() + " --real --damping hysteretic"};
}

}  // namespace jointid::cli
