#include "modalfit/poles/polyreference.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"
#include "dense/svd.hpp"
#include "modalfit/band/inputs.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// The band takes this share of the half circle; a rational function of z cannot follow the jump at its ends.
constexpr double share_of_circle = 0.95;
constexpr double pole_ridge = 1e-13;
/// Responses per partial sum; sums do not depend on the number of threads.
constexpr std::size_t responses_at_once = 4;

/// At most so many of the outputs, evenly thinned.
std::vector<std::size_t> thinned(std::size_t outputs, std::size_t most) {
  const std::size_t step = (outputs + most - 1) / most;
  std::vector<std::size_t> out;
  for (std::size_t o = 0; o < outputs; o += step) out.push_back(o);
  return out;
}

/// φ(f) = rate·(f − start).
struct CircleMap {
  double start_hz = 0.0, rate = 0.0;

  explicit CircleMap(const Band& band) {
    const double width = (band.frequency_hz.back() - band.frequency_hz.front()) / share_of_circle;
    start_hz = 0.5 * (band.frequency_hz.back() + band.frequency_hz.front() - width);
    rate = std::numbers::pi / width;
  }
  double angle(double f) const { return rate * (f - start_hz); }
  /// The complex frequency s/(2πi) of a z-plane pole.
  Complex frequency(Complex z) const { return std::log(z) / Complex(0.0, rate) + start_hz; }
};

/// cos lφ and sin lφ, [lag, line].
struct Lags {
  MatrixXd cosine, sine;

  Lags(const Band& band, Index order) : cosine(order + 1, at(band.lines())), sine(cosine) {
    const CircleMap map(band);
    for (Index line = 0; line < cosine.cols(); ++line) {
      const double angle = map.angle(band.frequency_hz[static_cast<std::size_t>(line)]);
      for (Index lag = 0; lag <= order; ++lag) {
        cosine(lag, line) = std::cos(static_cast<double>(lag) * angle);
        sine(lag, line) = std::sin(static_cast<double>(lag) * angle);
      }
    }
  }
};

/// The FRFs of an output, weighted: rows of the least-squares problem. Column 0 the weight alone.
struct WeightedRows {
  VectorXd weight;
  MatrixXcd frf;  ///< [line, input]
};

WeightedRows weighted_rows(const Band& band, const InputChoice& choice, std::size_t output) {
  const auto lines = at(band.lines()), inputs = at(choice.inputs.size());
  WeightedRows rows{VectorXd(lines), MatrixXcd(lines, inputs)};
  for (Index line = 0; line < lines; ++line) {
    double variance = 0.0;
    for (Index c = 0; c < inputs; ++c) {
      const std::size_t entry = choice.entry(band, output, static_cast<std::size_t>(c));
      const double* weight = band.weights(entry) + 2 * line;
      variance += 1.0 / (weight[0] * weight[0]) + 1.0 / (weight[1] * weight[1]);
      rows.frf(line, c) = band.value(entry)[line];
    }
    rows.weight(line) = std::isfinite(variance) ? std::sqrt(2.0 * static_cast<double>(inputs) / variance) : 0.0;
    rows.frf.row(line) *= rows.weight(line);
  }
  return rows;
}

/// Block (k, m) of a Toeplitz matrix is lag m − k of `even` ± `odd`.
template <class At>
void fill_toeplitz(MatrixXd& matrix, Index order, Index row, Index column, Index row_step, Index column_step, At at) {
  for (Index m = 0; m <= order; ++m) {
    for (Index k = 0; k <= order; ++k) matrix(k * row_step + row, m * column_step + column) = at(m - k);
  }
}

/// T − SᵀR⁻¹S of one output: the numerator of the output eliminated.
MatrixXd reduced_block(const WeightedRows& rows, const Lags& lags, Index order) {
  const Index inputs = rows.frf.cols();
  MatrixXd r(order + 1, order + 1), s(order + 1, (order + 1) * inputs), t((order + 1) * inputs, (order + 1) * inputs);
  const VectorXd power = lags.cosine * rows.weight.cwiseAbs2();
  fill_toeplitz(r, order, 0, 0, 1, 1, [&](Index lag) { return power(std::abs(lag)); });
  for (Index c = 0; c < inputs; ++c) {
    const VectorXcd cross = rows.frf.col(c).cwiseProduct(rows.weight);
    const VectorXd even = lags.cosine * cross.real(), odd = lags.sine * cross.imag();
    fill_toeplitz(s, order, 0, c, 1, inputs, [&](Index lag) { return lag >= 0 ? odd(lag) - even(lag) : -odd(-lag) - even(-lag); });
    for (Index d = 0; d < inputs; ++d) {
      const VectorXcd product = rows.frf.col(c).conjugate().cwiseProduct(rows.frf.col(d));
      const VectorXd both = lags.cosine * product.real(), turned = lags.sine * product.imag();
      fill_toeplitz(t, order, c, d, inputs, inputs,
                    [&](Index lag) { return lag >= 0 ? both(lag) - turned(lag) : both(-lag) + turned(-lag); });
    }
  }
  r.diagonal().array() += pole_ridge * r.diagonal().sum();
  t.noalias() -= s.transpose() * dense::solve_positive(r, s);
  return t;
}

MatrixXd normal_matrix(const Band& band, const InputChoice& choice, const std::vector<std::size_t>& outputs, Index order) {
  const Lags lags(band, order);
  const std::size_t chunks = (outputs.size() + responses_at_once - 1) / responses_at_once;
  std::vector<MatrixXd> parts(chunks);
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t i) {
    for (std::size_t o = i * responses_at_once; o < std::min(outputs.size(), (i + 1) * responses_at_once); ++o) {
      band.look();
      const WeightedRows rows = weighted_rows(band, choice, outputs[o]);
      if (rows.weight.isZero(0.0)) continue;
      MatrixXd block = reduced_block(rows, lags, order);
      parts[i].size() == 0 ? parts[i].swap(block) : void(parts[i] += block);
    }
  });
  const Index size = (order + 1) * at(choice.inputs.size());
  MatrixXd sum = MatrixXd::Zero(size, size);
  for (const MatrixXd& part : parts) {
    if (part.size() > 0) sum += part;
  }
  return sum;
}

/// Solves one order after the other from the leading blocks of the normal matrix M.
class OrderSolver {
 public:
  OrderSolver(const Band& band, MatrixXd normal, Index inputs, double equations)
      : map_(band), band_(band), normal_(std::move(normal)), inputs_(inputs), equations_(equations) {
    const Index rest = normal_.rows() - inputs_;
    MatrixXd block = normal_.bottomRightCorner(rest, rest);
    block.diagonal().array() += pole_ridge * block.diagonal().sum();
    dense::cholesky_in_place(block);  // what rounding spoils at high orders is not reached by low ones
    lower_ = block.triangularView<Eigen::Lower>();
  }

  OrderPoles solve(Index order) const {
    const Index size = order * inputs_;
    const auto lower = lower_.topLeftCorner(size, size).triangularView<Eigen::Lower>();
    const MatrixXd side = normal_.block(inputs_, 0, size, inputs_);
    const MatrixXd half = lower.solve(side);
    const MatrixXd alpha = -lower.transpose().solve(half);  // α₁ … α_order below each other
    const MatrixXd residual = (normal_.topLeftCorner(inputs_, inputs_) - half.transpose() * half) /
                              std::max(1.0, equations_ - static_cast<double>(size));
    MatrixXd companion = MatrixXd::Zero(size, size);
    for (Index k = 0; k < order; ++k) companion.block(0, k * inputs_, inputs_, inputs_) = -alpha.middleRows(k * inputs_, inputs_);
    companion.bottomLeftCorner(size - inputs_, size - inputs_).setIdentity();
    OrderPoles out{.order = static_cast<std::size_t>((size + 1) / 2), .poles = {}};
    const VectorXcd roots = dense::eigenvalues(companion);
    for (Index i = 0; i < size; ++i) append(roots(i), alpha, residual, out.poles);
    return out;
  }

 private:
  /// `y` = 1/z is a root of Σ y^(m−k) α_k.
  void append(Complex y, const MatrixXd& alpha, const MatrixXd& residual, std::vector<CandidatePole>& poles) const {
    if (y.imag() >= 0.0 || y == 0.0) return;  // z above the real axis
    const Complex f = map_.frequency(1.0 / y);
    const double modulus = std::abs(f);
    if (f.real() < band_.frequency_hz.front() || f.real() > band_.frequency_hz.back()) return;
    poles.push_back({modulus, f.imag() / modulus, deviation(y, alpha, residual) / (map_.rate * std::numbers::sqrt2)});
  }

  /// Standard deviation of ln y: dy = −wᴴ(Σ y^(m−k) dα_k)v / (wᴴP'(y)v) with wᴴP(y) = 0 = P(y)v and
  /// cov(α) = (residual covariance) ⊗ (normal matrix)⁻¹.
  double deviation(Complex y, const MatrixXd& alpha, const MatrixXd& residual) const {
    const Index order = alpha.rows() / inputs_;
    MatrixXcd p = MatrixXcd::Identity(inputs_, inputs_), slope = MatrixXcd::Zero(inputs_, inputs_);
    for (Index k = 0; k < order; ++k) {  // Horner
      slope = slope * y + p;
      p = p * y + alpha.middleRows(k * inputs_, inputs_);
    }
    const dense::ComplexSvd svd = dense::jacobi_svd(p, dense::Vectors::full, dense::Vectors::full);
    const VectorXcd w = svd.u.col(inputs_ - 1), v = svd.v.col(inputs_ - 1);
    VectorXcd u(alpha.rows());
    Complex factor = 1.0;
    for (Index k = order; k-- > 0; factor *= y) u.segment(k * inputs_, inputs_) = factor * w.conjugate();
    const auto lower = lower_.topLeftCorner(alpha.rows(), alpha.rows()).triangularView<Eigen::Lower>();
    const double spread = lower.solve(u).squaredNorm() * std::abs(v.dot(residual * v));
    return std::sqrt(spread) / (std::abs((w.adjoint() * slope * v).value()) * std::abs(y));
  }

  CircleMap map_;
  const Band& band_;
  MatrixXd normal_, lower_;
  Index inputs_;
  double equations_;
};

/// Polynomial orders from 2 to `highest`, at most `count` of them.
std::vector<Index> orders(Index highest, std::size_t count) {
  std::vector<Index> list;
  const Index step = std::max<Index>(1, (highest + at(count) - 1) / at(count));
  for (Index order = highest; order >= 2; order -= step) list.insert(list.begin(), order);
  return list;
}

}  // namespace

std::vector<OrderPoles> polyreference_poles(const Band& band, const PolyreferenceOptions& options) {
  const InputChoice choice = choose_inputs(band, options.inputs);
  const auto inputs = at(choice.inputs.size());
  const Index wanted = (2 * at(options.most_poles) + inputs - 1) / inputs;
  const Index highest = std::clamp<Index>(at(band.lines()) / 2 - 1, 2, wanted);
  const std::vector<std::size_t> outputs = thinned(choice.outputs, options.most_outputs);
  const auto count = static_cast<double>(outputs.size());
  const double equations = (2.0 * static_cast<double>(band.lines()) - static_cast<double>(highest + 1)) * count;
  const OrderSolver solver(band, normal_matrix(band, choice, outputs, highest), inputs, equations);
  const std::vector<Index> list = orders(highest, options.orders);
  std::vector<OrderPoles> out(list.size());
  tbb::parallel_for(std::size_t{0}, list.size(), [&](std::size_t i) {
    band.look();
    out[i] = solver.solve(list[i]);
  });
  return out;
}

}  // namespace jointid::modalfit
