#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace jointid::restrictions {

struct LinearTerm {
  std::string name;
  double coefficient = 0.0;  ///< never zero
};

/// constant + Σ coefficient·name, each name once, in order of first appearance.
struct LinearExpression {
  double constant = 0.0;
  std::vector<LinearTerm> terms;
};

/// Parses a linear expression of named unknowns, e.g. "-a", "2*k+m", "k/2", "-(a - 3e4*b)/2".
///   sum     = product { ("+" | "-") product }
///   product = factor { ("*" | "/") factor }
///   factor  = ("+" | "-") factor | number | name | "(" sum ")"
/// A name is a letter or underscore followed by letters, digits and underscores. A name that cancels ("k - k") is left
/// out. Throws InputError (usage) that quotes the expression and the place in it (characters counted from 1): products
/// of unknowns, division by an unknown or by zero, numbers out of range, anything not in the grammar.
LinearExpression parse_linear(std::string_view text);

}  // namespace jointid::restrictions
