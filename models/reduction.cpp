#include "models/reduction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"
#include "dense/lu.hpp"
#include "models/model.hpp"

namespace jointid::models {
namespace {

constexpr std::size_t grid_lines = 32;  ///< test lines at equal steps
constexpr std::size_t most_resonances = 64;
constexpr double beside_resonance = 1e-4;
constexpr double sigma_share = 0.1;  ///< σ of the square of the highest frequency

std::vector<std::size_t> with_dampers(const std::vector<std::size_t>& coordinates, const ProportionalForm& form) {
  std::set<std::size_t> all(coordinates.begin(), coordinates.end());
  all.insert(form.dampers.begin(), form.dampers.end());
  return {all.begin(), all.end()};
}

/// The poles of the undamped structure that a basis has, rad/s, ascending; rigid-body motion is not among them.
std::vector<double> natural_frequencies(const Eigen::VectorXd& mu, double sigma) {
  std::vector<double> out;
  for (const double each : mu) {
    const double square = 1.0 / each - sigma;
    if (each > 0.0 && square > 0.0) out.push_back(std::sqrt(square));
  }
  std::ranges::sort(out);
  return out;
}

}  // namespace

Reduction::Reduction(const StructureMatrices& matrices, ProportionalForm form, const std::vector<std::size_t>& coordinates)
    : form_(std::move(form)),
      inputs_(with_dampers(coordinates, form_)),
      stiffness_diagonal_(at(inputs_.size())),
      mass_diagonal_(at(inputs_.size())),
      matrices_(matrices) {
  for (const std::size_t damper : form_.dampers) damper_places_.push_back(place_of(damper));
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    stiffness_diagonal_(at(i)) = matrices.stiffness.coeff(at(inputs_[i]), at(inputs_[i]));
    mass_diagonal_(at(i)) = matrices.mass.coeff(at(inputs_[i]), at(inputs_[i]));
  }
}

std::size_t Reduction::place_of(std::size_t coordinate) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(inputs_, coordinate) - inputs_.begin());
}

bool Reduction::has(std::span<const std::size_t> coordinates) const {
  return std::ranges::all_of(coordinates, [&](std::size_t each) { return std::ranges::binary_search(inputs_, each); });
}

bool Reduction::find_modes() {
  const Eigen::MatrixXd mass = basis_->mass(), positive = basis_->stiffness() + basis_->sigma() * mass;
  if (!dense::cholesky(positive)) return false;
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(mass, positive);
  modes_.shapes = basis_->inputs() * eigen.vectors;
  modes_.mu = eigen.values;
  modes_.lacking = eigen.vectors.transpose() * basis_->reached() * eigen.vectors;
  modes_.lacking.diagonal() -= modes_.mu.cwiseAbs2();
  return true;
}

bool Reduction::add_shift(double omega) {
  const Eigen::MatrixXcd off = errors(omega);
  const dense::SymmetricEigen squares =
      dense::symmetric_eigen(off.real().transpose() * off.real() + off.imag().transpose() * off.imag());
  Eigen::Index first = 0;
  while (first + 1 < squares.values.size() && !(squares.values(first) > 0.01 * bound * bound)) ++first;
  const Eigen::MatrixXd combinations = squares.vectors.rightCols(squares.values.size() - first);
  constexpr std::array beside = {1.0, 1.003, 0.997, 1.011};  // where it meets a pole
  for (const double factor : beside) {
    if (!basis_->add(factor * omega * factor * omega, combinations)) continue;
    ++shifts_;
    return true;
  }
  return false;
}

bool Reduction::extend(double omega, double error, Eigen::Index most_vectors) {
  constexpr double least_gain = 0.5;
  constexpr std::size_t vectors_at_once = 32;  // few inputs need several powers to reach a resonance
  const std::size_t powers = 1 + vectors_at_once / inputs_.size();
  if (basis_->prefers_powers() && !powers_are_spent_ && basis_->size() + at(powers * inputs_.size()) <= most_vectors) {
    for (std::size_t i = 0; i < powers; ++i) basis_->add_power();
    if (!find_modes()) return false;
    const double left = errors(omega).cwiseAbs().maxCoeff();
    powers_are_spent_ = left > least_gain * error;
    if (!powers_are_spent_ || left <= accepted) return true;  // what is as small as that is rounding
  }
  return basis_->size() + 2 * at(inputs_.size()) <= most_vectors && add_shift(omega) && find_modes();
}

std::vector<double> Reduction::test_lines(double low, double high) const {
  std::vector<double> out;
  for (std::size_t i = 0; i < grid_lines; ++i)
    out.push_back(low + (high - low) * static_cast<double>(i) / static_cast<double>(grid_lines - 1));
  std::vector<double> poles = natural_frequencies(modes_.mu, basis_->sigma());
  std::erase_if(poles, [&](double each) { return each < low || each > high; });
  const std::size_t step = 1 + poles.size() / most_resonances;
  for (std::size_t i = 0; i < poles.size(); i += step) out.push_back(poles[i] * (1.0 + beside_resonance));
  return out;
}

Eigen::MatrixXcd Reduction::errors(double omega) const {
  const Eigen::ArrayXcd own = receptances(omega);
  const Eigen::MatrixXcd y = own.matrix().asDiagonal() * modes_.shapes.transpose().cast<Complex>();
  const Complex gamma = form_.beta(omega) - form_.alpha(omega) * basis_->sigma();
  return y.transpose() * (modes_.lacking * y) * (gamma * gamma / (modes_.shapes * y).cwiseAbs().maxCoeff());
}

bool Reduction::cover(double low, double high, Eigen::Index most_vectors) {
  if (!basis_) {
    basis_.emplace(matrices_.stiffness, matrices_.mass, inputs_, sigma_share * high * high);
    if (!basis_->begin() || !find_modes()) return false;
  } else {
    low = std::min(low, low_);
    high = std::max(high, high_);
  }
  const double near = 0.5 * (high - low) / static_cast<double>(grid_lines - 1);
  const auto settled = [&](double omega) {
    return std::ranges::any_of(at_rounding_, [&](double each) { return std::abs(each - omega) <= near; });
  };
  std::map<double, double> error;
  powers_are_spent_ = false;
  for (;;) {
    error.clear();
    for (const double omega : test_lines(low, high)) error[omega] = errors(omega).cwiseAbs().maxCoeff();
    double worst = -1.0, largest = aim_;
    for (const auto& [omega, each] : error) {
      if (each <= largest || settled(omega)) continue;
      largest = each;
      worst = omega;
    }
    if (worst < 0.0) break;
    if (!extend(worst, largest, most_vectors)) return false;
    if (errors(worst).cwiseAbs().maxCoeff() < 0.3 * largest) continue;
    at_rounding_.push_back(worst);
    aim_ = std::max({aim_, accepted, std::min(largest, rounding)});
  }
  for (auto line = error.begin(); line != error.end() && line->second > rounding; line = error.begin()) {
    error.erase(line);
    low = error.empty() ? high : error.begin()->first;
  }
  if (error.empty()) return false;
  const auto found = std::ranges::max_element(error, {}, &std::pair<const double, double>::second);
  worst_ = found->first;
  error_ = found->second;
  low_ = low;
  high_ = high;
  return error_ <= rounding;
}

Eigen::ArrayXcd Reduction::receptances(double omega) const {
  const Complex alpha = form_.alpha(omega), gamma = form_.beta(omega) - alpha * basis_->sigma();
  return (alpha + gamma * modes_.mu.array().cast<Complex>()).inverse();
}

Eigen::MatrixXcd Reduction::between(const Eigen::ArrayXcd& own, const std::vector<std::size_t>& rows,
                                    const std::vector<std::size_t>& columns) const {
  Eigen::MatrixXd left(at(rows.size()), modes_.mu.size()), right(modes_.mu.size(), at(columns.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) left.row(at(r)) = modes_.shapes.row(at(rows[r]));
  for (std::size_t c = 0; c < columns.size(); ++c) right.col(at(c)) = modes_.shapes.row(at(columns[c]));
  Eigen::MatrixXcd out(left.rows(), right.cols());
  out.real() = left * (own.real().matrix().asDiagonal() * right);
  out.imag() = left * (own.imag().matrix().asDiagonal() * right);
  return out;
}

/// H − H_E (I + R H_EE)⁻¹ R H_E with the dampers E.
Eigen::MatrixXcd Reduction::damped(double omega, const std::vector<std::size_t>& rows, const std::vector<std::size_t>& columns) const {
  const Eigen::ArrayXcd own = receptances(omega);
  Eigen::MatrixXcd h = between(own, rows, columns);
  if (damper_places_.empty()) return h;
  const Eigen::MatrixXcd rest = form_.rest(omega);
  Eigen::MatrixXcd inner = rest * between(own, damper_places_, damper_places_);
  inner.diagonal().array() += 1.0;
  const Eigen::MatrixXcd forces = dense::solve(inner, rest * between(own, damper_places_, columns));
  h -= between(own, rows, damper_places_) * forces;
  return h;
}

std::optional<Eigen::MatrixXcd> Reduction::receptance(double omega, std::span<const std::size_t> rows,
                                                      std::span<const std::size_t> columns) const {
  std::vector<std::size_t> r, c;
  for (const std::size_t row : rows) r.push_back(place_of(row));
  for (const std::size_t column : columns) c.push_back(place_of(column));
  Eigen::MatrixXcd h = damped(omega, r, c);
  const Eigen::VectorXcd own = (r == c ? h : damped(omega, c, c)).diagonal();
  const Complex alpha = form_.alpha(omega), beta = form_.beta(omega);
  for (std::size_t k = 0; k < c.size(); ++k) {
    const Complex stiffness = alpha * stiffness_diagonal_(at(c[k])) + beta * mass_diagonal_(at(c[k]));
    if (!(std::abs(own(at(k)) * stiffness) < infinite_receptance)) return std::nullopt;
  }
  if (!h.allFinite()) return std::nullopt;
  return h;
}

}  // namespace jointid::models
