#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "problems/case/catalogue.hpp"

namespace jointid::problems {

/// A test of every case of the catalogue. Its parameter is a place, as GoogleTest copies parameters when a program starts, and
/// cases have large matrices.
class ByCase : public testing::TestWithParam<const Case*> {
 public:
  static std::vector<const Case*> all() {
    static const std::vector<Case> cases = all_cases();
    std::vector<const Case*> places;
    for (const Case& each : cases) places.push_back(&each);
    return places;
  }

  static std::string name_of(const testing::TestParamInfo<const Case*>& info) {
    std::string name = info.param->name;
    std::erase(name, '-');
    return name;
  }

 protected:
  const Case& definition_ = *GetParam();
};

}  // namespace jointid::problems
