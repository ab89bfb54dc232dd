#include "frf/mat/mat_axes.hpp"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

using AxisWords = std::array<std::string_view, 32>;

constexpr std::array<std::pair<char, AxisWords>, 3> words_of_axes = {
    {{'F', {"f", "freq", "freqs", "frequency", "frequencies", "line", "lines", "hz", "omega", "w", "nf", "bin", "bins", "spectral",
            "frequenz", "frequencia", "frecuencia", "frequence", "frequenza", "kreisfrequenz"}},
     {'R', {"r", "resp", "response", "responses", "rsp", "out", "output", "outputs", "o", "y", "row", "rows", "no", "nr", "sensor",
            "sensors", "channel", "channels", "acc", "ny", "nout", "accel", "motion",
            "antwort", "ausgang", "reponse", "sortie", "respuesta", "salida", "risposta", "uscita"}},
     {'C', {"c", "ref", "reference", "references", "in", "input", "inputs", "i", "u", "col", "column", "columns", "ni", "nc", "force",
            "forces", "exc", "excitation", "excitations", "impact", "impacts", "nin", "hammer",
            "anregung", "eingang", "kraft", "entree", "entrada", "ingresso"}}}};

char letter_of(std::string_view word) {
  for (const auto& [letter, words] : words_of_axes) {
    if (!word.empty() && std::ranges::find(words, word) != words.end()) return letter;
  }
  return '?';
}

/// AxisWords between other signs than letters; an x between blanks or sizes is one of those.
std::vector<std::string> words_in_order(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : lower_case(text)) {
    const bool letter = std::isalpha(static_cast<unsigned char>(c)) != 0;
    if (letter) words.back() += c;
    if (!letter && !words.back().empty()) words.emplace_back();
  }
  std::erase_if(words, [](const std::string& word) { return word.empty() || word == "x" || word == "by"; });
  return words;
}

}  // namespace

std::optional<std::string> order_of_axes(std::string_view text) {
  std::vector<std::string> words = words_in_order(text);
  if (words.size() == 1 && words[0].size() == 3) {
    const std::string letters = words[0];
    words = {letters.substr(0, 1), letters.substr(1, 1), letters.substr(2, 1)};
  }
  std::string order;
  for (const std::string& word : words) order += letter_of(word);
  std::string sorted = order;
  std::ranges::sort(sorted);
  return sorted == "CFR" ? std::optional(order) : std::nullopt;
}

std::optional<std::string> order_of_axes(const std::vector<std::string>& names) {
  std::string order;
  for (const std::string& name : names) {
    std::string letters;
    for (const std::string& word : words_in_order(name)) {
      const char letter = letter_of(word);
      if (letter != '?' && letters.find(letter) == std::string::npos) letters += letter;
    }
    order += letters.size() == 1 ? letters[0] : '?';
  }
  if (order.size() == 3 && std::ranges::count(order, '?') == 1) {
    for (const char letter : {'F', 'R', 'C'}) {
      if (order.find(letter) == std::string::npos) std::ranges::replace(order, '?', letter);
    }
  }
  std::string sorted = order;
  std::ranges::sort(sorted);
  return sorted == "CFR" ? std::optional(order) : std::nullopt;
}

std::array<std::size_t, 3> strides(std::string_view order, const std::array<std::size_t, 3>& extents, bool last_fastest) {
  constexpr std::string_view letters = "FRC";
  std::array<std::size_t, 3> out{};
  std::size_t stride = 1;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t axis = letters.find(order[last_fastest ? order.size() - 1 - k : k]);
    out[axis] = stride;
    stride *= extents[axis];
  }
  return out;
}

}  // namespace jointid::frf
