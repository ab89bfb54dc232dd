#include "restrictions/linear_expression.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.hpp"

namespace jointid::restrictions {
namespace {

constexpr std::size_t longest_expression = 2000;  // characters; also bounds the quadratic search for names
constexpr int deepest_nesting = 50;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || c == '\t'; }

void add(LinearExpression& sum, const LinearExpression& other, double factor) {
  sum.constant += factor * other.constant;
  for (const LinearTerm& term : other.terms) {
    const auto same = std::find_if(sum.terms.begin(), sum.terms.end(),
                                   [&](const LinearTerm& present) { return present.name == term.name; });
    if (same == sum.terms.end()) {
      sum.terms.push_back({term.name, factor * term.coefficient});
    } else {
      same->coefficient += factor * term.coefficient;
    }
  }
}

void scale(LinearExpression& expression, double factor) {
  expression.constant *= factor;
  for (LinearTerm& term : expression.terms) term.coefficient *= factor;
}

/// Recursive descent over the grammar of the header; `at_` is the next character.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  LinearExpression parse() {
    if (text_.size() > longest_expression) {
      throw InputError({.kind = ErrorKind::usage,
                        .file = {},
                        .place = {},
                        .problem = "an expression of " + std::to_string(text_.size()) + " characters is too long",
                        .remedy = "at most " + std::to_string(longest_expression) + " are read"});
    }
    LinearExpression result = sum(0);
    if (at_ < text_.size()) fail_at_rest();
    std::erase_if(result.terms, [](const LinearTerm& term) { return term.coefficient == 0.0; });
    require_finite(result);
    return result;
  }

 private:
  LinearExpression sum(int depth) {
    LinearExpression result = product(depth);
    while (peek() == '+' || peek() == '-') {
      const double sign = text_[at_++] == '-' ? -1.0 : 1.0;
      add(result, product(depth), sign);
    }
    return result;
  }

  LinearExpression product(int depth) {
    LinearExpression result = factor(depth);
    while (peek() == '*' || peek() == '/') {
      const std::size_t place = at_;
      if (text_[at_++] == '*') {
        multiply(result, factor(depth), place);
      } else {
        divide(result, factor(depth), place);
      }
    }
    return result;
  }

  LinearExpression factor(int depth) {
    if (depth > deepest_nesting) fail(at_, "is nested too deeply", "write it out");
    const char c = peek();
    if (c == '+' || c == '-') {
      ++at_;
      LinearExpression inner = factor(depth + 1);
      if (c == '-') scale(inner, -1.0);
      return inner;
    }
    if (c == '(') return parenthesis(depth);
    if (is_digit(c) || c == '.') return {number(), {}};
    if (is_letter(c)) return {0.0, {{name(), 1.0}}};
    if (at_ == text_.size()) fail(at_, "ends where a number or an unknown is expected", "");
    fail(at_, "has '" + std::string(1, c) + "' where a number or an unknown is expected", "");
  }

  LinearExpression parenthesis(int depth) {
    const std::size_t opening = at_++;
    LinearExpression inner = sum(depth + 1);
    if (peek() != ')') fail(opening, "has an opening parenthesis that is not closed", "");
    ++at_;
    return inner;
  }

  void multiply(LinearExpression& left, LinearExpression right, std::size_t place) const {
    if (!left.terms.empty() && !right.terms.empty()) {
      fail(place, "multiplies the unknowns '" + left.terms[0].name + "' and '" + right.terms[0].name + "'",
           "only linear expressions can be identified; name the product as an unknown of its own");
    }
    if (left.terms.empty()) std::swap(left, right);
    scale(left, right.constant);
  }

  void divide(LinearExpression& left, const LinearExpression& right, std::size_t place) const {
    if (!right.terms.empty()) {
      fail(place, "divides by the unknown '" + right.terms[0].name + "'", "only division by a number is linear");
    }
    if (right.constant == 0.0) fail(place, "divides by zero", "");
    left.constant /= right.constant;
    for (LinearTerm& term : left.terms) term.coefficient /= right.constant;
  }

  double number() {
    double value = 0.0;
    const auto [last, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error == std::errc::result_out_of_range) fail(at_, "has a number out of range", "");
    if (error != std::errc()) fail(at_, "has a '.' that is not part of a number", "");
    at_ = static_cast<std::size_t>(last - text_.data());
    return value;
  }

  std::string name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  char peek() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  [[noreturn]] void fail_at_rest() const {
    const char c = text_[at_];
    if (is_letter(c) || is_digit(c) || c == '(' || c == '.') {
      fail(at_, "lacks an operator", "write a product as 2*k");
    }
    fail(at_, "has '" + std::string(1, c) + "' where it should end or go on with + - * /", "");
  }

  void require_finite(const LinearExpression& result) const {
    const bool finite = std::isfinite(result.constant) &&
                        std::all_of(result.terms.begin(), result.terms.end(),
                                    [](const LinearTerm& term) { return std::isfinite(term.coefficient); });
    if (!finite) fail(0, "has a coefficient out of range", "");
  }

  [[noreturn]] void fail(std::size_t place, const std::string& what, const std::string& remedy) const {
    const std::string at = " (character " + std::to_string(place + 1) + ")";
    throw InputError({.kind = ErrorKind::usage,
                      .file = {},
                      .place = {},
                      .problem = "'" + std::string(text_) + "' " + what + at,
                      .remedy = remedy});
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

LinearExpression parse_linear(std::string_view text) { return Parser(text).parse(); }

}  // namespace jointid::restrictions
