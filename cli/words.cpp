#include "cli/words.hpp"

#include <algorithm>

namespace jointid::cli {

std::string words(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

}  // namespace jointid::cli
