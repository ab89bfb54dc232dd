#include "gui/scene/joints_edit.hpp"

#include "gui/scene/completion_place.hpp"
#include "gui/scene/toml_edit.hpp"
#include "restrictions/joint_spec.hpp"

namespace jointid::gui {
namespace {

/// [joint] and its tables as the first of [[joints]].
std::string as_first_of_several(std::string text) {
  const int header = line_of_key(text, "joint", "");
  if (header == 0) return text;
  const std::size_t open = text.find('[', begin_of_line(text, header));
  text.replace(open, text.find(']', open) + 1 - open, "[[joints]]");
  text.insert(begin_of_line(text, header + 1), "name = \"joint1\"\n");
  for (const restrictions::Kind kind : restrictions::all_kinds) {
    const int line = line_of_key(text, "joint." + restrictions::key(kind), "");
    if (line > 0) text.insert(text.find("joint", begin_of_line(text, line)) + 5, "s");
  }
  return text;
}

}  // namespace

int joints_in(const std::string& text) {
  int count = 0;
  while (line_of_key(text, "joints#" + std::to_string(count + 1), "") > 0) ++count;
  return count;
}

std::string with_joint(std::string text) {
  if (!text.empty() && text.back() != '\n') text += '\n';
  text = as_first_of_several(std::move(text));
  const std::string name = "joint" + std::to_string(joints_in(text) + 1);
  const int behind = behind_tables(text, "joints");
  return text.insert(behind > 0 ? begin_of_line(text, behind) : text.size(),
                     "\n[[joints]]\nname = \"" + name + "\"\ndofs = []\n\n[joints.stiffness]\npattern = \"symmetric\"\n");
}

std::string without_joint(const std::string& text, int number) {
  const std::string joint = "joints#" + std::to_string(number);
  const int header = line_of_key(text, joint, "");
  if (header == 0) return text;
  const std::size_t begin = begin_of_line(text, header), behind = begin_of_line(text, behind_tables(text, joint));
  const bool blank_above = begin >= 2 && text[begin - 1] == '\n' && text[begin - 2] == '\n';
  return text.substr(0, blank_above ? begin - 1 : begin) + text.substr(behind);
}

}  // namespace jointid::gui
