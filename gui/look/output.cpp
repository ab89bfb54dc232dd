#include "gui/look/output.hpp"

#include <system_error>

#include "base/error.hpp"
#include "base/temporary_file.hpp"
#include "gui/look/paths.hpp"

namespace jointid::gui {

void check_output(const QString& file, const std::vector<std::filesystem::path>& inputs) {
  const auto target = as_path(file);
  for (const auto& input : inputs) {
    std::error_code none;
    if (!std::filesystem::equivalent(input, target, none)) continue;
    throw InputError({ErrorKind::usage, target.string(), "", "this file is an input of the scene", "choose another name"});
  }
}

void write_output(const QString& file, std::string_view bytes, const std::vector<std::filesystem::path>& inputs) {
  check_output(file, inputs);
  write_text(as_path(file), bytes);
}

}  // namespace jointid::gui
