#include "weighting/weighting.hpp"

#include <array>
#include <cctype>

#include "base/error.hpp"

namespace jointid::weighting {
namespace {

constexpr std::array<const char*, 5> names = {"none", "WA", "WB", "WBG", "WBS"};

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string suggestion(const std::string& text) {
  const std::string near = nearest_word(text, names);
  return near.empty() ? nearest_word(upper(text), names) : near;
}

}  // namespace

std::string name(Weighting weighting) { return names[static_cast<std::size_t>(weighting)]; }

Weighting parse_weighting(std::string_view text) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (text == names[i]) return static_cast<Weighting>(i);
  }
  const std::string near = suggestion(std::string(text));
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = {},
                    .problem = "'" + std::string(text) + "' is not a weighting",
                    .remedy = (near.empty() ? "" : "did you mean " + near + "? ") +
                              std::string("Use none, WA, WB, WBG or WBS")});
}

}  // namespace jointid::weighting
