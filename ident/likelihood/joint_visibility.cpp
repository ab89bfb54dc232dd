#include "ident/likelihood/joint_visibility.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace jointid::ident {
namespace {

Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

/// Mean square of a few numbers.
struct MeanSquare {
  double sum = 0.0;
  std::size_t count = 0;

  void add(double value) {
    sum += value * value;
    ++count;
  }
};

/// Adds difference/σ of both parts; weights are 1/σ of each term, 0: not measured.
void add(MeanSquare& mean, Complex difference, Complex first, Complex second) {
  const auto one = [&](double value, double a, double b) {
    if (a > 0.0 && b > 0.0) mean.add(value / std::hypot(1.0 / a, 1.0 / b));
  };
  one(difference.real(), first.real(), second.real());
  one(difference.imag(), first.imag(), second.imag());
}

void add_block(MeanSquare& mean, const std::vector<Element>& of_sub, const Channel& sub, const std::vector<Element>& of_asm,
               const Channel& whole) {
  for (std::size_t i = 0; i < of_asm.size(); ++i) {
    const auto found = std::ranges::find_if(of_sub, [&](const Element& e) {
      return e.row == of_asm[i].row && e.column == of_asm[i].column;
    });
    if (found == of_sub.end()) continue;
    const auto j = static_cast<std::size_t>(found - of_sub.begin());
    add(mean, sub.value[j] - whole.value[i], sub.weight[j], whole.weight[i]);
  }
}

std::optional<double> effect(const LineLayout& layout, const LineData& data) {
  MeanSquare mean;
  add_block(mean, layout.x, data.x, layout.a, data.a);
  add_block(mean, layout.y, data.y, layout.b, data.b);
  for (std::size_t i = 0; i < layout.d.size(); ++i) {
    const Complex value = data.d.value[i], weight = data.d.weight[i];
    if (weight.real() > 0.0) mean.add(value.real() * weight.real());
    if (weight.imag() > 0.0) mean.add(value.imag() * weight.imag());
  }
  if (mean.count == 0) return std::nullopt;
  return std::sqrt(mean.sum / static_cast<double>(mean.count));
}

/// Empty unless every joint coordinate has an FRF with a variance.
std::optional<double> deformation(const LineLayout& layout, const LineData& data, const LineState& state) {
  if (state.a.cols() < state.a.rows()) return std::nullopt;
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(at(layout.joint));
  ComplexMatrix a = ComplexMatrix::Zero(at(layout.joint), at(layout.others));
  for (std::size_t i = 0; i < layout.a.size(); ++i) {
    const Complex weight = data.a.weight[i];
    if (!(weight.real() > 0.0 && weight.imag() > 0.0)) continue;
    const auto row = at(layout.a[i].row), column = at(layout.a[i].column);
    variance[row] += 1.0 / (weight.real() * weight.real()) + 1.0 / (weight.imag() * weight.imag());
    a(row, column) = state.a(row, column);
  }
  if (!(variance.minCoeff() > 0.0)) return std::nullopt;
  a = variance.cwiseSqrt().cwiseInverse().asDiagonal() * a;
  const Eigen::SelfAdjointEigenSolver<ComplexMatrix> eigen(ComplexMatrix(a * a.adjoint()), Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, eigen.eigenvalues()[0]));
}

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

JointVisibility joint_visibility(const LikelihoodData& data, const LikelihoodEstimator& estimator) {
  std::vector<double> effects, deformations;
  for (std::size_t i = 0; i < data.lines().size(); ++i) {
    const LineState& state = estimator.state_of(i);
    if (state.a.size() == 0) continue;
    if (const auto value = effect(data.layout(), data.lines()[i])) effects.push_back(*value);
    if (const auto value = deformation(data.layout(), data.lines()[i], state)) deformations.push_back(*value);
  }
  return {median(std::move(effects)), median(std::move(deformations))};
}

}  // namespace jointid::ident
