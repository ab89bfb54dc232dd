#include "gui/scene/table_path.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace jointid::gui {
namespace {

bool is_bare(char c) {
  return c == '_' || c == '-' || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// Where the dots outside of quotes are.
std::vector<std::size_t> dots_of(const std::string& path) {
  std::vector<std::size_t> dots;
  char quote = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (quote != 0) {
      if (path[i] == quote) quote = 0;
    } else if (path[i] == '"' || path[i] == '\'') {
      quote = path[i];
    } else if (path[i] == '.') {
      dots.push_back(i);
    }
  }
  return dots;
}

/// A key of a header without quotes that it does not need; none for what is no key.
std::optional<std::string> key_in(const std::string& text) {
  const bool quoted = text.size() >= 2 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0];
  if (quoted) return as_key(text.substr(1, text.size() - 2));
  if (text.empty() || !std::ranges::all_of(text, is_bare)) return std::nullopt;
  return text;
}

/// The path of "joint . stiffness"; none for the line of an array of arrays.
std::optional<std::string> path_in(const std::string& text) {
  std::string path;
  std::size_t begin = 0;
  std::vector<std::size_t> ends = dots_of(text);
  ends.push_back(text.size());
  for (const std::size_t end : ends) {
    const auto key = key_in(without_blanks(text.substr(begin, end - begin)));
    if (!key) return std::nullopt;
    path += (path.empty() ? "" : ".") + *key;
    begin = end + 1;
  }
  return path;
}

bool is_below(const std::string& path, const std::string& table) { return path == table || path.starts_with(table + "."); }

}  // namespace

std::string without_blanks(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string as_key(const std::string& name) {
  return !name.empty() && std::ranges::all_of(name, is_bare) ? name : '"' + name + '"';
}

std::pair<std::string, std::string> parted(const std::string& path) {
  const std::vector<std::size_t> dots = dots_of(path);
  if (dots.empty()) return {"", path};
  return {path.substr(0, dots.back()), path.substr(dots.back() + 1)};
}

std::string numbered_part(const std::string& path) {
  const std::size_t number = path.find('#');
  if (number == std::string::npos || path.find('"') < number) return "";
  return path.substr(0, path.find('.', number));
}

std::string header_of(const std::string& path) {
  const std::string numbered = numbered_part(path);
  if (numbered.empty()) return "[" + path + "]";
  const std::string plain = path.substr(0, path.find('#')) + path.substr(numbered.size());
  return numbered == path ? "[[" + plain + "]]" : "[" + plain + "]";
}

bool TablePath::take(const std::string& line) {
  const std::string text = without_blanks(line);
  if (!text.starts_with('[')) return false;
  const std::size_t brackets = text.starts_with("[[") ? 2 : 1;
  const std::size_t close = text.find(']', brackets);
  if (close == std::string::npos) return false;
  const std::string rest = without_blanks(text.substr(std::min(text.size(), close + brackets)));
  const auto path = path_in(text.substr(brackets, close - brackets));
  if (!path || !(rest.empty() || rest.starts_with('#'))) return false;
  plain_ = numbered_ = *path;
  if (brackets == 2) ++arrays_[plain_];
  for (const auto& [array, count] : arrays_) {
    if (is_below(plain_, array)) numbered_ = array + "#" + std::to_string(count) + plain_.substr(array.size());
  }
  return true;
}

bool TablePath::is_in(const std::string& path) const { return is_below(plain_, path) || is_below(numbered_, path); }

}  // namespace jointid::gui
