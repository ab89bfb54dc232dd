#include "cli/output.hpp"

#include <algorithm>
#include <filesystem>

#include "frf/error.hpp"
#include "frf/temporary_file.hpp"

namespace jointid::cli {

namespace {

using Path = std::filesystem::path;

[[noreturn]] void refuse(const std::string& target, const std::string& why, const std::string& remedy) {
  throw InputError({ErrorKind::data, target, "", why, remedy});
}

[[noreturn]] void refuse_use(const std::string& options, const std::string& why, const std::string& remedy) {
  throw InputError({ErrorKind::usage, "", options, why, remedy});
}

void require_folder(const std::string& target) {
  std::error_code ignored;
  if (std::filesystem::is_directory(target, ignored)) {
    refuse(target, "cannot be written: it is a folder", "name a file in it");
  }
  const Path folder = Path(target).parent_path();
  if (folder.empty() || std::filesystem::is_directory(folder, ignored)) return;
  const bool exists = std::filesystem::exists(folder, ignored);
  refuse(target, "cannot be written: " + folder.string() + (exists ? " is no folder" : " does not exist"),
         exists ? "name a file in a folder" : "make the folder first");
}

bool same_file(const Path& one, const Path& other) {
  const auto canonical = [](const Path& path) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
  };
  return canonical(one) == canonical(other);
}

void require_different(const OptionTarget& one, const OptionTarget& other) {
  const std::string options = one.first + " " + *one.second + " " + other.first + " " + *other.second;
  if (*one.second == "-" && *other.second == "-") {
    refuse_use(options, "both want standard output", "give one of them a file");
  }
  if (same_file(*one.second, *other.second)) refuse_use(options, "both want the same file", "give each its own");
}

}  // namespace

void check_targets(const std::filesystem::path& scene, const std::vector<OptionTarget>& targets) {
  for (auto one = targets.begin(); one != targets.end(); ++one) {
    if (!one->second) continue;
    const auto& [option, target] = *one;
    if (target->empty()) refuse_use(option, "the name is empty", "name a file");
    for (auto other = targets.begin(); other != one; ++other) {
      if (other->second) require_different(*other, *one);
    }
    if (*target == "-") continue;
    if (!scene.empty() && same_file(*target, scene)) refuse_use(option + " " + *target, "would replace the scene", "give another name");
    require_folder(*target);
  }
}

bool takes_output(const std::vector<std::optional<std::string>>& targets) {
  return std::ranges::find(targets, "-") != targets.end();
}

void write_target(const std::string& target, const std::string& text, std::ostream& out) {
  if (target == "-") {
    out << text;
  } else {
    frf::write_text(target, text);
  }
}

}  // namespace jointid::cli
