#include "response/time/collocation.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <vector>

namespace jointid::response {
namespace {

using Wide = long double;

/// Coefficients of Lagrange's polynomials: column i of the result is Π_{k≠i} (σ − c_k)/(c_i − c_k).
Eigen::MatrixXd monomials(const std::vector<Wide>& nodes) {
  const std::size_t count = nodes.size();
  Eigen::MatrixXd coefficients(count, count);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<Wide> polynomial = {1.0L};
    for (std::size_t k = 0; k < count; ++k) {
      if (k == i) continue;
      std::vector<Wide> next(polynomial.size() + 1, 0.0L);
      for (std::size_t p = 0; p < polynomial.size(); ++p) {
        next[p + 1] += polynomial[p] / (nodes[i] - nodes[k]);
        next[p] -= polynomial[p] * nodes[k] / (nodes[i] - nodes[k]);
      }
      polynomial = next;
    }
    for (std::size_t p = 0; p < count; ++p) {
      coefficients(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(i)) = static_cast<double>(polynomial[p]);
    }
  }
  return coefficients;
}

Collocation make_rule() {
  using Gauss = boost::math::quadrature::gauss<Wide, Collocation::points>;
  const auto &half = Gauss::abscissa(), &weight = Gauss::weights();  // those above 0, ascending
  std::vector<Wide> nodes, weights;
  for (std::size_t i = half.size(); i-- > 0;) {
    nodes.push_back(0.5L * (1.0L - half[i]));
    weights.push_back(0.5L * weight[i]);
  }
  for (std::size_t i = 0; i < half.size(); ++i) {
    nodes.push_back(0.5L * (1.0L + half[i]));
    weights.push_back(0.5L * weight[i]);
  }
  Collocation rule;
  rule.nodes.resize(Collocation::points);
  rule.weights.resize(Collocation::points);
  for (int i = 0; i < Collocation::points; ++i) {
    rule.nodes[i] = static_cast<double>(nodes[static_cast<std::size_t>(i)]);
    rule.weights[i] = static_cast<double>(weights[static_cast<std::size_t>(i)]);
  }
  rule.to_monomials = monomials(nodes);
  return rule;
}

}  // namespace

const Collocation& Collocation::rule() {
  static const Collocation rule = make_rule();
  return rule;
}

}  // namespace jointid::response
