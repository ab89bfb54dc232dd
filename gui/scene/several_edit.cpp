#include "gui/scene/several_edit.hpp"

#include "gui/scene/completion_place.hpp"
#include "gui/scene/table_path.hpp"
#include "gui/scene/toml_edit.hpp"

namespace jointid::gui {

std::string one_of_several(const std::string& table, int number) { return table + "#" + std::to_string(number); }

int several_in(const std::string& text, const std::string& table) {
  int count = 0;
  while (line_of_key(text, one_of_several(table, count + 1), "") > 0) ++count;
  return count;
}

std::string with_one_more(std::string text, const std::string& table, const std::string& lines) {
  if (!text.empty() && text.back() != '\n') text += '\n';
  int behind = behind_tables(text, table);
  if (const std::string above = parted(table).first; behind == 0 && !above.empty()) behind = behind_tables(text, above);
  return text.insert(behind > 0 ? begin_of_line(text, behind) : text.size(), "\n[[" + table + "]]\n" + lines);
}

std::string without_one(const std::string& text, const std::string& table, int number) {
  const std::string one = one_of_several(table, number);
  const int header = line_of_key(text, one, "");
  if (header == 0) return text;
  const std::size_t begin = begin_of_line(text, header), behind = begin_of_line(text, behind_tables(text, one));
  const bool blank_above = begin >= 2 && text[begin - 1] == '\n' && text[begin - 2] == '\n';
  return text.substr(0, blank_above ? begin - 1 : begin) + text.substr(behind);
}

}  // namespace jointid::gui
