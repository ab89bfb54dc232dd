#include "tasks/pod/pod_task.hpp"

#include <utility>

#include "base/error.hpp"

namespace jointid::tasks {

std::vector<ident::NamedFile> files_of(const PodTask& task) {
  std::vector<ident::NamedFile> files;
  for (const auto& file : task.files) files.push_back({file, "FILES"});
  for (const auto& [file, option] :
       {std::pair(task.mass, "--mass"), std::pair(task.stiffness, "--stiffness"), std::pair(task.compare, "--compare")}) {
    if (!file.empty()) files.push_back({file, option});
  }
  return files;
}

void check(const PodTask& task) {
  const auto fail = [](const char* option, const char* problem, const char* remedy) {
    throw InputError({ErrorKind::usage, "", option, problem, remedy});
  };
  if (task.stiffness.empty()) return;
  if (task.mass.empty()) fail("--stiffness", "there is no mass matrix for the normal modes", "give --mass");
  if (!task.compare.empty()) fail("--stiffness", "there are other modes to compare with", "leave --compare out");
}

}  // namespace jointid::tasks
