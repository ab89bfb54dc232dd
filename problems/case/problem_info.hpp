#pragma once

#include <string>

namespace jointid::problems {

struct ProblemInfo {
  std::string name;
  std::string description;
};

}  // namespace jointid::problems
