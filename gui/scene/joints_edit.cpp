#include "gui/scene/joints_edit.hpp"

#include "gui/scene/completion_place.hpp"
#include "gui/scene/several_edit.hpp"
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

int joints_in(const std::string& text) { return several_in(text, "joints"); }

std::string with_joint(std::string text) {
  if (!text.empty() && text.back() != '\n') text += '\n';
  text = as_first_of_several(std::move(text));
  const std::string name = "joint" + std::to_string(joints_in(text) + 1);
  return with_one_more(std::move(text), "joints", "name = \"" + name + "\"\ndofs = []\n\n[joints.stiffness]\npattern = \"symmetric\"\n");
}

std::string without_joint(const std::string& text, int number) { return without_one(text, "joints", number); }

}  // namespace jointid::gui
