#include "base/error.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/text.hpp"

namespace jointid {
namespace {

std::string message(const InputError::Parts& parts) {
  std::string text = parts.file;
  if (!parts.place.empty()) text += (text.empty() ? "" : ": ") + parts.place;
  text += (text.empty() ? "" : ": ") + parts.problem;
  if (!parts.remedy.empty()) text += "; " + parts.remedy;
  return text;
}

}  // namespace

InputError::InputError(Parts parts) : std::runtime_error(printable(message(parts))), parts_(std::move(parts)) {}

void refuse(std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::usage, .file = "", .place = "", .problem = std::move(problem), .remedy = std::move(remedy)});
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

std::size_t find_word(const std::string& text, const std::vector<std::string>& words, const std::string& what) {
  const auto found = std::find(words.begin(), words.end(), text);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string remedy;
  for (const std::string& word : words) remedy += (remedy.empty() ? "use " : ", ") + word;
  const std::string near = nearest_word(text, words);
  throw InputError({ErrorKind::usage, "", "", "'" + text + "' is no " + what,
                    (near.empty() ? "" : "did you mean '" + near + "'? ") + remedy});
}

}  // namespace jointid
