#include "cli/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace jointid::cli {

std::string words(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

std::string equations_text(const std::vector<ident::Equation>& equations) {
  std::vector<std::string> names;
  for (const auto equation : equations) names.push_back(ident::name(equation));
  return names.empty() ? "all" : fmt::format("{}", fmt::join(names, " "));
}

}  // namespace jointid::cli
