#include "ident/likelihood/findings/joint_visibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/eigen.hpp"

namespace jointid::ident {
namespace {

using Numbers = std::vector<double>;

/// Appends |difference|/σ of both parts; weights are 1/σ of each term, 0: not measured.
void add(Complex difference, Complex first, Complex second, Numbers& out) {
  const auto one = [&](double value, double a, double b) {
    if (a > 0.0 && b > 0.0) out.push_back(std::abs(value) / std::hypot(1.0 / a, 1.0 / b));
  };
  one(difference.real(), first.real(), second.real());
  one(difference.imag(), first.imag(), second.imag());
}

/// Elements of the FRFs of parts and assembly that are one FRF.
using Matches = std::vector<std::array<std::size_t, 2>>;

Matches matches_of(const std::vector<Element>& of_sub, const std::vector<Element>& of_asm) {
  std::map<std::array<std::size_t, 2>, std::size_t> places;
  for (std::size_t i = 0; i < of_sub.size(); ++i) places.try_emplace({of_sub[i].row, of_sub[i].column}, i);
  Matches out;
  for (std::size_t i = 0; i < of_asm.size(); ++i) {
    if (const auto found = places.find({of_asm[i].row, of_asm[i].column}); found != places.end()) out.push_back({found->second, i});
  }
  return out;
}

/// Differences of measured FRFs over their errors.
class Effects {
 public:
  explicit Effects(const LineLayout& layout)
      : jn_(matches_of(layout.sub_jn, layout.asm_jn)), jj_(matches_of(layout.sub_jj, layout.asm_jj)) {}

  void add_line(const LineData& data, Numbers& out) const {
    add_block(jn_, data.sub_jn, data.asm_jn, out);
    add_block(jj_, data.sub_jj, data.asm_jj, out);
    for (std::size_t i = 0; i < data.drop_nn.value.size(); ++i) {
      const Complex value = data.drop_nn.value[i], weight = data.drop_nn.weight[i];
      if (weight.real() > 0.0) out.push_back(std::abs(value.real()) * weight.real());
      if (weight.imag() > 0.0) out.push_back(std::abs(value.imag()) * weight.imag());
    }
  }

 private:
  static void add_block(const Matches& matches, const Channel& sub, const Channel& whole, Numbers& out) {
    for (const auto& [j, i] : matches) add(sub.value[j] - whole.value[i], sub.weight[j], whole.weight[i], out);
  }

  Matches jn_, jj_;
};

/// |a_kᵀ δZ a_k| / |x_kᵀ δZ x_k| for every non-joint coordinate k.
void add_deformations(const LineState& state, const ComplexMatrix& dz, Numbers& out) {
  for (Eigen::Index k = 0; k < state.sub_jn.cols(); ++k) {
    const Complex assembled = (state.asm_jn.col(k).transpose() * dz * state.asm_jn.col(k)).value();
    const Complex free = (state.sub_jn.col(k).transpose() * dz * state.sub_jn.col(k)).value();
    if (free != Complex(0.0)) out.push_back(std::abs(assembled / free));
  }
}

/// Of the numbers of all processes.
std::optional<double> median_of_all(const std::vector<double>& own, const LineShares& shares) {
  std::vector<double> values;
  for (const std::vector<double>& each : shares.gathered(own)) values.insert(values.end(), each.begin(), each.end());
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

JointVisibility joint_visibility(const LikelihoodData& data, const LinearisedLikelihood& estimator,
                                 const std::vector<double>& direction) {
  const Effects measured(data.layout());
  Numbers effects, deformations;
  const std::vector<double> origin(direction.size(), 0.0);
  for (std::size_t i = 0; i < data.lines().size(); ++i) {
    const LineState& state = estimator.state_of(i);
    if (state.asm_jn.size() == 0) continue;
    measured.add_line(data.lines()[i], effects);
    add_deformations(state, estimator.impedance_of(i, direction) - estimator.impedance_of(i, origin), deformations);
  }
  return {median_of_all(effects, data.shares()), median_of_all(deformations, data.shares())};
}

namespace {

constexpr double held_together = 0.1;

struct Pair {
  std::size_t i, j;
  double motion;
};

/// The median of |a_i − s a_j| / |x_i − s x_j|, s the product of the DOFs' signs.
std::optional<double> relative_motion(const LikelihoodData& data, const LinearisedLikelihood& estimator, Eigen::Index i, Eigen::Index j,
                                      double sign) {
  Numbers ratios;
  for (std::size_t line = 0; line < data.lines().size(); ++line) {
    const LineState& state = estimator.state_of(line);
    for (Eigen::Index k = 0; k < state.asm_jn.cols(); ++k) {
      const double free = std::abs(state.sub_jn(i, k) - sign * state.sub_jn(j, k));
      if (free > 0.0) ratios.push_back(std::abs(state.asm_jn(i, k) - sign * state.asm_jn(j, k)) / free);
    }
  }
  return median_of_all(ratios, data.shares());
}

std::vector<Pair> held_pairs(const LikelihoodData& data, const LinearisedLikelihood& estimator, const Dofs& joint) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    for (std::size_t j = i + 1; j < joint.size(); ++j) {
      if (joint[i].direction != joint[j].direction) continue;
      const auto motion = relative_motion(data, estimator, at(i), at(j),
                                          joint[i].sign * joint[j].sign);
      if (motion && *motion < held_together) pairs.push_back({i, j, *motion});
    }
  }
  std::ranges::sort(pairs, {}, &Pair::motion);
  return pairs;
}

}  // namespace

std::vector<std::array<std::string, 2>> stiff_pairs(const LikelihoodData& data, const LinearisedLikelihood& estimator) {
  const Dofs& all = data.layout().coordinates;
  const Dofs joint(all.begin() + static_cast<std::ptrdiff_t>(data.layout().others), all.end());
  std::vector<bool> taken(joint.size(), false);
  std::vector<std::array<std::string, 2>> out;
  for (const Pair& pair : held_pairs(data, estimator, joint)) {
    if (taken[pair.i] || taken[pair.j]) continue;
    taken[pair.i] = taken[pair.j] = true;
    out.push_back({joint[pair.i].name(), joint[pair.j].name()});
  }
  if (2 * out.size() == joint.size()) out.clear();
  return out;
}

}  // namespace jointid::ident
