#include <algorithm>
#include <array>

#include "problems/case/coupling_problem.hpp"
#include "problems/case/flange.hpp"
#include "problems/case/many_joints_problem.hpp"
#include "problems/case/modal_set.hpp"
#include "problems/kinds/problem_kind.hpp"
#include "problems/problem.hpp"

namespace jointid::problems {
namespace {

constexpr std::array first_kinds = {
    ProblemKind{problems::list, write_identification_problem},
    ProblemKind{list_flanges, write_identification_problem},
    ProblemKind{list_many_joints, write_identification_problem},
    ProblemKind{list_coupling, write_coupling_problem},
    ProblemKind{list_modal_sets, write_modal_set},
};

}  // namespace

std::span<const ProblemKind> linear_kinds() { return first_kinds; }

const ProblemKind* kind_of(std::span<const ProblemKind> kinds, const std::string& name) {
  const auto found = std::ranges::find_if(
      kinds, [&](const ProblemKind& kind) { return std::ranges::count(kind.list(), name, &ProblemInfo::name) > 0; });
  return found == kinds.end() ? nullptr : &*found;
}

std::vector<std::string> names_of(std::span<const ProblemKind> kinds) {
  std::vector<std::string> names;
  for (const ProblemKind& kind : kinds) {
    for (const ProblemInfo& info : kind.list()) names.push_back(info.name);
  }
  return names;
}

WrittenProblem write_identification_problem(const std::string& name, const std::filesystem::path& directory,
                                            const WriteOptions& options) {
  const auto scene = write(make(name), directory, options);
  return {scene, "solve " + scene.string()};
}

WrittenProblem write_coupling_problem(const std::string& name, const std::filesystem::path& directory,
                                      const WriteOptions& options) {
  const auto scene = write(make_coupling(name), directory, options);
  return {scene, "couple " + scene.string()};
}

WrittenProblem write_modal_set(const std::string& name, const std::filesystem::path& directory, const WriteOptions& options) {
  const auto file = write(make_modal_set(name), directory, options);
  return {file, "modalfit " + file.string() + " --real --damping hysteretic"};
}

}  // namespace jointid::problems
