#include "restrictions/linear_expression.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"

namespace jointid::restrictions {
namespace {

using ::testing::HasSubstr;
using Terms = std::vector<std::pair<std::string, double>>;

Terms terms(const LinearExpression& expression) {
  Terms result;
  for (const LinearTerm& term : expression.terms) result.emplace_back(term.name, term.coefficient);
  return result;
}

TEST(LinearExpression, ReadsWhatTheGrammarAllows) {
  struct Case {
    const char* text;
    double constant;
    Terms terms;
  };
  const std::vector<Case> cases = {
      {"k", 0, {{"k", 1}}},
      {"-a", 0, {{"a", -1}}},
      {"+a", 0, {{"a", 1}}},
      {"2*k+m", 0, {{"k", 2}, {"m", 1}}},
      {"k*2", 0, {{"k", 2}}},
      {"k/2", 0, {{"k", 0.5}}},
      {"m - k + m", 0, {{"m", 2}, {"k", -1}}},
      {" 1.5e3 * k_1 - .5", -0.5, {{"k_1", 1500}}},
      {"-(a - 3e4*b)/2", 0, {{"a", -0.5}, {"b", 15000}}},
      {"2*3*k/4/3", 0, {{"k", 0.5}}},
      {"a - -b", 0, {{"a", 1}, {"b", 1}}},
      {"2*-a", 0, {{"a", -2}}},
      {"k - k", 0, {}},
      {"0*k + m", 0, {{"m", 1}}},
      {"(2+3)*(a)", 0, {{"a", 5}}},
      {"1-2-3", -4, {}},
      {"8/2/2", 2, {}},
      {"_x9", 0, {{"_x9", 1}}},
      {"1e5", 1e5, {}},
      {"99360", 99360, {}},
  };
  for (const Case& c : cases) {
    const LinearExpression expression = parse_linear(c.text);
    EXPECT_EQ(expression.constant, c.constant) << c.text;
    EXPECT_EQ(terms(expression), c.terms) << c.text;
  }
}

TEST(LinearExpression, SaysWhatIsWrongAndWhere) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"a*b", "multiplies the unknowns 'a' and 'b' (character 2)"},
      {"2*(a+1)*b", "multiplies the unknowns 'a' and 'b' (character 8)"},
      {"1/k", "divides by the unknown 'k' (character 2)"},
      {"k/0", "divides by zero (character 2)"},
      {"k/(1-1)", "divides by zero (character 2)"},
      {"2k", "lacks an operator (character 2)"},
      {"a b", "lacks an operator (character 3)"},
      {"(a)(b)", "lacks an operator (character 4)"},
      {"", "ends where a number or an unknown is expected (character 1)"},
      {"  ", "ends where a number or an unknown is expected (character 3)"},
      {"a+", "ends where a number or an unknown is expected (character 3)"},
      {"*a", "has '*' where a number or an unknown is expected (character 1)"},
      {"a**2", "has '*' where a number or an unknown is expected (character 3)"},
      {"a^2", "has '^' where it should end or go on with + - * / (character 2)"},
      {"(a+b", "opening parenthesis that is not closed (character 1)"},
      {"a)", "has ')' where it should end"},
      {"1e999", "number out of range (character 1)"},
      {"1e200*1e200*k", "coefficient out of range"},
      {".", "'.' that is not part of a number (character 1)"},
      {"1,5*k", "has ',' where it should end"},
      {std::string(60, '('), "nested too deeply"},
      {std::string(60, '-') + "a", "nested too deeply"},
  };
  for (const auto& [text, expected] : cases) {
    try {
      parse_linear(text);
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_THAT(error.what(), HasSubstr("'" + text + "'"));
      EXPECT_THAT(error.what(), HasSubstr(expected));
    }
  }
}

TEST(LinearExpression, RefusesAnEndlessText) {
  EXPECT_THROW(parse_linear(std::string(100000, '(')), InputError);
}

}  // namespace
}  // namespace jointid::restrictions
