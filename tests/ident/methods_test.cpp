#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "ident/scene/method_traits.hpp"

namespace jointid::ident {
namespace {

/// traits() takes a row by the number of its enumerator: one in a wrong place would plan another method.
TEST(Methods, RowsAreInTheOrderOfTheEnumerators) {
  const std::vector<MethodTraits>& rows = all_methods();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto method = static_cast<Method>(i);
    EXPECT_EQ(static_cast<std::size_t>(rows[i].method), i) << rows[i].name;
    EXPECT_EQ(parse_method(name(method)), method);
    EXPECT_TRUE(rows[i].plan != nullptr && !rows[i].solvers.empty() && !rows[i].phrase.empty()) << rows[i].name;
  }
}

/// Files of studies hold the numbers, scenes the words: neither may change, and no word is of two methods.
TEST(Methods, WordsAndNumbersStay) {
  const std::vector<std::string> first = {"one", "two", "direct", "newton", "likelihood"}, names = method_names();
  ASSERT_GE(names.size(), first.size());
  EXPECT_EQ(std::vector<std::string>(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(first.size())), first);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

}  // namespace
}  // namespace jointid::ident
