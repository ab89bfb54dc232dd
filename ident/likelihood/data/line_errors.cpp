#include "ident/likelihood/data/line_errors.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>

#include "base/eigen.hpp"

namespace jointid::ident {
namespace {

/// A term of an element, by its place among those that have any.
struct ElementPart {
  Eigen::Index place;
  std::size_t member;
  Complex factor;
  double relation;
};

/// Elements with terms, and these sorted by the groups of one system.
class ElementParts {
 public:
  void add(std::size_t element, const LineErrors& errors, std::size_t row, std::size_t column, double factor) {
    for (const ErrorTerm& term : errors.terms.at(row, column)) {
      if (!is_finite(errors, term)) continue;
      if (elements_.empty() || elements_.back() != element) elements_.push_back(element);
      groups_[key(errors, term)].push_back({at(elements_.size() - 1), term.member, factor * term.factor, term.relation});
    }
  }

  const std::vector<std::size_t>& elements() const { return elements_; }

  /// E[e e^H].
  Eigen::MatrixXcd covariance() const {
    return sum([](const Group& group, const ElementPart& a, const ElementPart& b) {
      const Complex value = group.covariance ? (*group.covariance)(at(a.member), at(b.member)) : Complex(1.0);
      return std::isfinite(value.real()) ? a.factor * std::conj(b.factor) * value : Complex(0.0);
    });
  }

  /// E[e eᵀ]; empty where all errors are circular.
  Eigen::MatrixXcd relation() const {
    const auto is_circular = [](const auto& group) {
      return std::ranges::all_of(group.second, [](const ElementPart& part) { return part.relation == 0.0; });
    };
    if (std::ranges::all_of(groups_, is_circular)) return {};
    return sum([](const Group& group, const ElementPart& a, const ElementPart& b) {
      return group.covariance ? Complex(0.0) : a.factor * b.factor * a.relation;
    });
  }

 private:
  /// A covariance, or one of the independent errors of a system.
  struct Group {
    const Eigen::MatrixXcd* covariance = nullptr;
    const LineErrors* system = nullptr;
    std::size_t member = 0;
    auto operator<=>(const Group&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 in it
  };

  template <class Between>
  Eigen::MatrixXcd sum(Between between) const {
    Eigen::MatrixXcd out = Eigen::MatrixXcd::Zero(at(elements_.size()), at(elements_.size()));
    for (const auto& [group, parts] : groups_) {
      for (const ElementPart& a : parts) {
        for (const ElementPart& b : parts) out(a.place, b.place) += between(group, a, b);
      }
    }
    return out;
  }

  static bool is_finite(const LineErrors& errors, const ErrorTerm& term) {
    if (term.group == ErrorTerm::independent) return std::isfinite(term.factor.real());
    return std::isfinite(errors.covariance[term.group](at(term.member), at(term.member)).real());
  }
  static Group key(const LineErrors& errors, const ErrorTerm& term) {
    if (term.group == ErrorTerm::independent) return {.system = &errors, .member = term.member};
    return {.covariance = &errors.covariance[term.group]};
  }

  std::vector<std::size_t> elements_;
  std::map<Group, std::vector<ElementPart>> groups_;
};

}  // namespace

std::shared_ptr<const minimise::Correlation> correlation_of(const LineLayout& layout, const LineErrors* substructures,
                                                            const LineErrors* assembly, const std::vector<Complex>& variance) {
  if (!substructures && !assembly) return nullptr;
  ElementParts parts;
  std::size_t element = 0;
  for_each_element(layout, [&](ElementOf of, Element at) {
    const auto add = [&](const LineErrors* errors, double factor) {
      if (errors && variance[element].real() > 0.0) parts.add(element, *errors, at.row, at.column, factor);
    };
    if (of != ElementOf::assembly) add(substructures, 1.0);
    if (of != ElementOf::substructures) add(assembly, of == ElementOf::difference ? -1.0 : 1.0);
    ++element;
  });
  Eigen::VectorXcd variances(at(parts.elements().size()));
  for (Eigen::Index i = 0; i < variances.size(); ++i) variances[i] = variance[parts.elements()[static_cast<std::size_t>(i)]];
  minimise::Correlation out =
      minimise::Correlation::of(element, parts.elements(), parts.covariance(), parts.relation(), variances);
  return out.groups().empty() ? nullptr : std::make_shared<const minimise::Correlation>(std::move(out));
}

}  // namespace jointid::ident
