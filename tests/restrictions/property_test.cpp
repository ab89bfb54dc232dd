#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <tuple>

#include "tests/restrictions/joints.hpp"

namespace jointid::restrictions {
namespace {

using Doubles = std::vector<double>;

std::vector<frf::Dof> x_dofs(std::int64_t first, std::size_t count) {
  std::vector<frf::Dof> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back({.node = first + static_cast<std::int64_t>(i)});
  return all;
}

/// Small whole numbers, so that sums are exact in any order.
Doubles integers(std::size_t count) {
  const auto ints = *rc::gen::container<std::vector<int>>(count, rc::gen::inRange(-1000, 1000));
  return {ints.begin(), ints.end()};
}

/// An element 'c0 + c1*u1 + c2*u2 + c3*u3' as numbers, as text, and its value.
struct Element {
  int constant;
  std::array<int, 3> coefficients;

  std::string text() const {
    std::string result = std::to_string(constant);
    for (std::size_t i = 0; i < 3; ++i) {
      result += (coefficients[i] < 0 ? " " : " + ") + std::to_string(coefficients[i]) + "*u" + std::to_string(i + 1);
    }
    return result;
  }
  double value(const Doubles& u) const {
    return constant + coefficients[0] * u[0] + coefficients[1] * u[1] + coefficients[2] * u[2];
  }
};

std::vector<Element> elements(std::size_t count) {
  std::vector<Element> result;
  for (std::size_t i = 0; i < count; ++i) {
    const auto c = *rc::gen::container<std::vector<int>>(4, rc::gen::inRange(-3, 4));
    result.push_back({c[0], {c[1], c[2], c[3]}});
  }
  return result;
}

RC_GTEST_PROP(RestrictionProperty, AMatrixOfExpressionsIsItsValueElementByElement, ()) {
  const auto size = *rc::gen::inRange<std::size_t>(1, 5);
  const std::vector<Element> all = elements(size * size);
  EntryMatrix entries(size);
  for (std::size_t i = 0; i < size * size; ++i) entries[i / size].emplace_back(all[i].text());
  const Restriction r = build({joint(x_dofs(1, size), Kind::mass, entries)});

  const Doubles u = integers(3);
  Doubles y;
  for (const Unknown& unknown : r.unknowns) y.push_back(u[static_cast<std::size_t>(unknown.name.back() - '1')]);
  const Doubles x = r.matrix(Kind::mass, y);
  bool symmetric = true;
  for (std::size_t i = 0; i < size * size; ++i) {
    RC_ASSERT(x[i] == all[i].value(u));
    const Element& mirrored = all[(i % size) * size + i / size];
    symmetric = symmetric && all[i].constant == mirrored.constant && all[i].coefficients == mirrored.coefficients;
  }
  RC_ASSERT(r.symmetric() == symmetric);
}

RC_GTEST_PROP(RestrictionProperty, TermsAndKnownValuesComeSortedAndOnce, ()) {
  const auto size = *rc::gen::inRange<std::size_t>(1, 5);
  EntryMatrix entries(size);
  for (const Element& element : elements(size * size)) {
    std::vector<Entry>& row = *std::find_if(entries.begin(), entries.end(), [&](auto& e) { return e.size() < size; });
    row.emplace_back(element.text());
  }
  const Restriction r = build({joint(x_dofs(1, size), Kind::stiffness, entries)});
  const MatrixTerms& matrix = r.matrices.at(0);
  const auto key = [](const Term& t) { return std::tuple(t.unknown, t.row, t.column); };
  for (std::size_t i = 1; i < matrix.terms.size(); ++i) RC_ASSERT(key(matrix.terms[i - 1]) < key(matrix.terms[i]));
  for (const Term& term : matrix.terms) RC_ASSERT(term.coefficient != 0.0);
  for (const Known& known : matrix.known) RC_ASSERT(known.value != 0.0);
}

/// Energy of springs from their elongations against qᵀXq.
RC_GTEST_PROP(RestrictionProperty, SpringsStoreTheEnergyOfTheirElongations, ()) {
  const auto size = *rc::gen::inRange<std::size_t>(2, 6);
  std::vector<frf::Dof> all = x_dofs(1, size);
  for (frf::Dof& dof : all) dof.sign = *rc::gen::element(-1, 1);
  std::vector<Spring> springs;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = i + 1; j <= size; ++j) {
      if (*rc::gen::arbitrary<bool>()) continue;
      Spring spring{all[i], std::nullopt};
      spring.first.sign = *rc::gen::element(-1, 1);
      if (j < size) spring.second = frf::Dof{.node = all[j].node, .sign = *rc::gen::element(-1, 1)};
      springs.push_back(spring);
    }
  }
  RC_PRE(!springs.empty());
  const Restriction r = build({joint(all, Kind::stiffness, springs)});
  const Doubles k = integers(springs.size());
  const Doubles u = integers(size);  // displacements along +X of nodes 1, 2, …

  double energy = 0.0;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    const auto along = [&](const frf::Dof& dof) { return dof.sign * u[static_cast<std::size_t>(dof.node - 1)]; };
    const double elongation = along(springs[s].first) - (springs[s].second ? along(*springs[s].second) : 0.0);
    energy += k[s] * elongation * elongation;
  }
  const Doubles x = r.matrix(Kind::stiffness, k);
  double from_matrix = 0.0;
  for (std::size_t i = 0; i < size * size; ++i) {
    const std::size_t row = i / size, column = i % size;
    from_matrix += all[row].sign * u[row] * x[i] * all[column].sign * u[column];
  }
  RC_ASSERT(from_matrix == energy);
  RC_ASSERT(r.symmetric());
}

RC_GTEST_PROP(RestrictionProperty, SeveralJointsAreBlockDiagonal, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(2, 5);
  std::vector<JointSpec> joints;
  for (std::size_t j = 0; j < count; ++j) {
    const auto size = *rc::gen::inRange<std::size_t>(1, 4);
    joints.push_back(joint(x_dofs(static_cast<std::int64_t>(10 * j), size), Kind::stiffness,
                           *rc::gen::element(Pattern::full, Pattern::symmetric, Pattern::diagonal)));
    joints.back().name = "j" + std::to_string(j);
  }
  const Restriction whole = build(joints);
  const Doubles y = integers(whole.unknowns.size());
  Doubles x = whole.matrix(Kind::stiffness, y);
  const std::size_t n = whole.dofs.size();
  std::size_t offset = 0;
  auto next = y.begin();
  for (const JointSpec& spec : joints) {
    const Restriction own = build({spec});
    const auto end = next + static_cast<std::ptrdiff_t>(own.unknowns.size());
    const Doubles block = own.matrix(Kind::stiffness, Doubles(next, end));
    const std::size_t size = spec.dofs.size();
    for (std::size_t i = 0; i < block.size(); ++i) x[(offset + i / size) * n + offset + i % size] -= block[i];
    offset += size;
    next = end;
  }
  RC_ASSERT(x == Doubles(n * n, 0.0));
}

}  // namespace
}  // namespace jointid::restrictions
