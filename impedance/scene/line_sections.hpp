#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "impedance/scene/line_scene.hpp"
#include "scene/document.hpp"

namespace jointid::impedance {

/// Data, lines, variances and virtual points of a scene; its joint is still empty.
LineScene read_sections(const scene::Document& document, const std::filesystem::path& file);

/// The enumerator whose word an item has; `words` in the order of the enumerators.
template <class Enum>
Enum read_word(const scene::Item& item, const std::vector<std::string>& words) {
  return static_cast<Enum>(std::ranges::find(words, item.word(words)) - words.begin());
}

/// Those of a word, or of a list of words, none twice; `what` they are: "way".
template <class Enum>
std::vector<Enum> read_words(const scene::Item& item, const std::vector<std::string>& words, const std::string& what) {
  if (item.is_text()) return {read_word<Enum>(item, words)};
  std::vector<Enum> out;
  for (const scene::Item& each : item.list_not_empty()) {
    const Enum one = read_word<Enum>(each, words);
    if (std::ranges::find(out, one) != out.end()) each.fail("the " + what + " '" + each.text() + "' is named twice");
    out.push_back(one);
  }
  return out;
}

}  // namespace jointid::impedance
