#include "ident/admissible/tie.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "restrictions/linear_expression.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;

[[noreturn]] void fail(const std::string& problem, const std::string& remedy) {
  throw InputError({.kind = ErrorKind::usage, .file = {}, .place = {}, .problem = problem, .remedy = remedy});
}

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; }

/// The longest of the names that stands at a place of the text; npos when there is none.
std::size_t name_at(const std::string& text, std::size_t place, const std::vector<std::string>& names) {
  std::size_t best = std::string::npos;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    if (text.compare(place, name.size(), name) != 0) continue;
    const std::size_t end = place + name.size();
    if (end < text.size() && in_name(name.back()) && in_name(text[end])) continue;
    if (best == std::string::npos || name.size() > names[best].size()) best = i;
  }
  return best;
}

/// The text with "unknown_7" for the name of unknown 7: names of unknowns are no identifiers.
std::string with_identifiers(const std::string& text, const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const bool begins =
        (std::isalpha(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_') && (i == 0 || !in_name(text[i - 1]));
    const std::size_t name = begins ? name_at(text, i, names) : std::string::npos;
    if (name == std::string::npos) {
      out += text[i++];
      continue;
    }
    out += "unknown_" + std::to_string(name);
    i += names[name].size();
  }
  return out;
}

/// The word of the text that names no unknown, if there is one.
std::string stranger(const std::string& text, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (std::isalpha(static_cast<unsigned char>(text[i])) == 0 || (i > 0 && in_name(text[i - 1]))) continue;
    const std::size_t name = name_at(text, i, names);
    if (name != std::string::npos) {
      i += names[name].size() - 1;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && (in_name(text[end]) || text[end] == '(' || text[end] == '[')) {
      const char open = text[end];
      if (open == '(' || open == '[') end = std::min(text.find(open == '(' ? ')' : ']', end), text.size() - 1);
      ++end;
    }
    return text.substr(i, end - i);
  }
  return {};
}

void add_side(const std::string& side, double sign, Tie& tie) {
  const restrictions::LinearExpression expression = restrictions::parse_linear(side);
  tie.value -= sign * expression.constant;
  for (const auto& [name, coefficient] : expression.terms) {
    tie.coefficients[static_cast<Index>(std::stoul(name.substr(name.find('_') + 1)))] += sign * coefficient;
  }
}

/// left − right as coefficients·θ − value.
Tie difference(const std::string& left, const std::string& right, const std::string& quoted,
               const std::vector<std::string>& names) {
  for (const std::string* side : {&left, &right}) {
    const std::string word = stranger(*side, names);
    if (word.empty()) continue;
    const std::string near = nearest_word(word, names);
    fail(quoted + ": the joint has no unknown " + word,
         near.empty() ? "`jointid plan` lists them" : "did you mean " + near + "?");
  }
  Tie tie{Eigen::VectorXd::Zero(at(names.size())), 0.0};
  try {
    add_side(with_identifiers(left, names), 1.0, tie);
    add_side(with_identifiers(right, names), -1.0, tie);
  } catch (const InputError& error) {
    fail(quoted + " is not linear in unknowns: " + error.parts().problem, error.parts().remedy);
  }
  if (tie.coefficients.isZero(0.0)) fail(quoted + " has no unknown", "leave it out");
  return tie;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

}  // namespace

Tie parse_tie(const std::string& text, const std::vector<std::string>& names) {
  const std::string quoted = "the tie '" + text + "'";
  const std::size_t equals = text.find('=');
  if (text.find_first_of("<>") != std::string::npos) fail(quoted + " is an inequality", "write it into inequalities");
  if (equals == std::string::npos || text.find('=', equals + 1) != std::string::npos) {
    fail(quoted + " is no equation", "write \"K(1,1) = K(2,2)\"");
  }
  return difference(text.substr(0, equals), text.substr(equals + 1), quoted, names);
}

std::vector<LinearInequality> parse_inequality(const std::string& text, const std::vector<std::string>& names) {
  const std::string quoted = "the inequality '" + text + "'";
  const std::string remedy = "write \"K(1,1) >= 2*K(2,2)\" or \"0.01*K(1,1) <= D(1,1) <= 0.1*K(1,1)\"";
  std::vector<std::string> sides = {""};
  std::string signs;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool relates = (text[i] == '<' || text[i] == '>') && i + 1 < text.size() && text[i + 1] == '=';
    if (!relates && std::string("<>=").find(text[i]) != std::string::npos) fail(quoted + " needs <= or >=", remedy);
    if (!relates) {
      sides.back() += text[i];
      continue;
    }
    signs += text[i++];
    sides.emplace_back();
  }
  if (signs.empty() || signs.size() > 2 || signs.find(signs[0] == '<' ? '>' : '<') != std::string::npos) {
    fail(quoted + " is none of one or two equal relations", remedy);
  }
  std::vector<LinearInequality> out;
  for (std::size_t k = 0; k < signs.size(); ++k) {
    const bool rises = signs[k] == '<';
    const Tie tie = difference(sides[rises ? k + 1 : k], sides[rises ? k : k + 1], quoted, names);
    out.push_back({tie.coefficients, -tie.value, trimmed(sides[k]) + (rises ? " <= " : " >= ") + trimmed(sides[k + 1])});
  }
  return out;
}

TiedUnknowns eliminate(std::vector<Tie> ties, Index unknowns) {
  std::vector<Index> pivots;
  for (std::size_t k = 0; k < ties.size(); ++k) {
    Tie& tie = ties[k];
    const double before = tie.coefficients.cwiseAbs().maxCoeff() + std::abs(tie.value);
    for (std::size_t done = 0; done < pivots.size(); ++done) {
      const double factor = tie.coefficients[pivots[done]];
      if (factor == 0.0) continue;
      tie.coefficients -= factor * ties[done].coefficients;
      tie.value -= factor * ties[done].value;
      tie.coefficients[pivots[done]] = 0.0;
    }
    Index pivot = 0;
    const double largest = tie.coefficients.cwiseAbs().maxCoeff(&pivot);
    if (largest <= 1e-12 * before) {
      if (std::abs(tie.value) > 1e-12 * before) fail("the ties contradict each other", "remove one of them");
      ties.erase(ties.begin() + static_cast<std::ptrdiff_t>(k--));  // it follows from those before
      continue;
    }
    tie.value /= tie.coefficients[pivot];
    tie.coefficients /= Eigen::VectorXd(tie.coefficients)[pivot];
    for (std::size_t done = 0; done < pivots.size(); ++done) {
      const double factor = ties[done].coefficients[pivot];
      if (factor == 0.0) continue;
      ties[done].coefficients -= factor * tie.coefficients;
      ties[done].value -= factor * tie.value;
      ties[done].coefficients[pivot] = 0.0;
    }
    pivots.push_back(pivot);
  }
  if (at(pivots.size()) == unknowns) fail("the ties leave no unknown free", "remove one of them");
  TiedUnknowns out{Eigen::VectorXd::Zero(unknowns), Eigen::MatrixXd::Zero(unknowns, unknowns - at(pivots.size()))};
  Index free = 0;
  for (Index u = 0; u < unknowns; ++u) {
    if (std::ranges::find(pivots, u) != pivots.end()) continue;
    out.directions(u, free) = 1.0;
    for (std::size_t k = 0; k < pivots.size(); ++k) out.directions(pivots[k], free) = 0.0 - ties[k].coefficients[u];
    ++free;
  }
  for (std::size_t k = 0; k < pivots.size(); ++k) out.offset[pivots[k]] = ties[k].value;
  return out;
}

}  // namespace jointid::ident
