#include "ident/plan/true_values.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::ident {
namespace {

using Values = std::vector<std::optional<double>>;

/// An element as equation: Σ coefficient·y = right.
struct SpecElement {
  std::vector<restrictions::Term> terms;
  double right = 0.0;
};

std::vector<SpecElement> elements_of(const restrictions::MatrixTerms& matrix, const Matrix& truth) {
  std::map<std::pair<std::size_t, std::size_t>, SpecElement> by_place;
  for (const restrictions::Term& term : matrix.terms) {
    SpecElement& element = by_place[{term.row, term.column}];
    element.terms.push_back(term);
    element.right = truth[term.row][term.column];
  }
  for (const restrictions::Known& known : matrix.known) {
    const auto found = by_place.find({known.row, known.column});
    if (found != by_place.end()) found->second.right -= known.value;
  }
  std::vector<SpecElement> elements;
  for (auto& [place, element] : by_place) elements.push_back(std::move(element));
  return elements;
}

/// Solves the element when all of its unknowns but one have values; true when it did.
bool solve_one(const SpecElement& element, Values& values) {
  const restrictions::Term* open = nullptr;
  double right = element.right;
  for (const restrictions::Term& term : element.terms) {
    if (values[term.unknown]) {
      right -= term.coefficient * *values[term.unknown];
    } else if (open != nullptr) {
      return false;
    } else {
      open = &term;
    }
  }
  if (open == nullptr || open->coefficient == 0.0) return false;
  values[open->unknown] = right / open->coefficient;
  return true;
}

void drop_contradictions(const std::vector<SpecElement>& elements, double tolerance, Values& values) {
  std::vector<std::size_t> dropped;
  for (const SpecElement& element : elements) {
    double rest = element.right;
    for (const restrictions::Term& term : element.terms) rest -= term.coefficient * values[term.unknown].value_or(0.0);
    const bool all_known = std::all_of(element.terms.begin(), element.terms.end(),
                                       [&](const restrictions::Term& term) { return values[term.unknown].has_value(); });
    if (!all_known || std::abs(rest) <= tolerance) continue;
    for (const restrictions::Term& term : element.terms) dropped.push_back(term.unknown);
  }
  for (const std::size_t unknown : dropped) values[unknown].reset();
}

}  // namespace

std::vector<std::optional<double>> true_values(const restrictions::Restriction& restriction,
                                               const std::map<restrictions::Kind, Matrix>& truth) {
  Values values(restriction.unknowns.size());
  for (const restrictions::MatrixTerms& matrix : restriction.matrices) {
    const auto exact = truth.find(matrix.kind);
    if (exact == truth.end()) continue;
    const std::vector<SpecElement> elements = elements_of(matrix, exact->second);
    bool progress = true;
    while (progress) {
      progress = false;
      for (const SpecElement& element : elements) progress = solve_one(element, values) || progress;
    }
    double largest = 0.0;
    for (const auto& row : exact->second) {
      for (const double element : row) largest = std::max(largest, std::abs(element));
    }
    drop_contradictions(elements, 1e-9 * largest, values);
  }
  return values;
}

}  // namespace jointid::ident
