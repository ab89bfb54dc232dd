#include "response/identify/consistency.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/statistics.hpp"
#include "dense/cholesky.hpp"
#include "response/harmonic/harmonic_line.hpp"

namespace jointid::response {
namespace {

/// One harmonic of one state: χ² = dᴴ P d of d = Y − H_mP_n, P without what joint forces can do.
struct Piece {
  std::size_t level = 0;
  Eigen::VectorXcd measured, free;
  Eigen::MatrixXcd weight;  ///< P

  Eigen::VectorXcd difference() const { return measured - free; }
};

/// C⁻¹ − C⁻¹T(TᴴC⁻¹T)⁻¹TᴴC⁻¹, and the forces that go with d.
struct Weights {
  Weights(const Eigen::MatrixXcd& covariance, const Eigen::MatrixXcd& to_joints) {
    const Eigen::Index responses = to_joints.rows(), joints = to_joints.cols();
    Eigen::MatrixXcd both(responses, responses + joints);
    both << Eigen::MatrixXcd::Identity(responses, responses), to_joints;
    const Eigen::MatrixXcd solved = dense::solve_positive(covariance, both);
    const Eigen::MatrixXcd inverse = solved.leftCols(responses), weighted = solved.rightCols(joints);
    // Columns of norm 1: stiff and soft joints differ by many orders.
    const Eigen::MatrixXcd normal = to_joints.adjoint() * weighted;
    const Eigen::VectorXd scale = normal.diagonal().real().cwiseSqrt().cwiseInverse();
    to_forces = scale.asDiagonal() *
                dense::solve_positive(Eigen::MatrixXcd(scale.asDiagonal() * normal * scale.asDiagonal()),
                                      Eigen::MatrixXcd(scale.asDiagonal() * weighted.adjoint()));
    left = inverse - weighted * to_forces;
  }
  Eigen::MatrixXcd left, to_forces;
};

Piece piece_of(const Receptance& structure, const MeasuredState& state, const HarmonicLine::One& part, Eigen::Index row) {
  const int n = state.harmonics[static_cast<std::size_t>(row)];
  Piece piece{.measured = state.response.row(row).transpose(), .free = part.free, .weight = {}};
  const Eigen::MatrixXcd own = Eigen::VectorXd(state.deviation.row(row).transpose().cwiseAbs2()).cast<Complex>().asDiagonal();
  const Weights first(own, part.to_joints);
  piece.weight = first.left;
  const std::vector<ReceptanceError> errors = structure.errors(n * state.omega);
  const bool has_force_errors = state.knows_force_errors() && state.force.row(n) >= 0;
  if (errors.empty() && !has_force_errors) return piece;
  Eigen::VectorXcd acting(structure.joints() + structure.forces());
  acting << first.to_forces * piece.difference(), state.force.of(n);
  Eigen::MatrixXcd covariance = own;
  for (const ReceptanceError& error : errors) {
    const Eigen::VectorXcd moved = (error.shape * acting).tail(structure.responses());
    covariance += 0.5 * (error.variance.real() + error.variance.imag()) * moved * moved.adjoint();
  }
  if (has_force_errors) {
    const Eigen::MatrixXcd by_force = structure.at(n * state.omega).bottomRightCorner(structure.responses(), structure.forces());
    const Eigen::VectorXd variance = state.force_deviation.row(state.force.row(n)).transpose().cwiseAbs2();
    covariance += by_force * variance.cast<Complex>().asDiagonal() * by_force.adjoint();
  }
  piece.weight = Weights(covariance, part.to_joints).left;
  return piece;
}

std::vector<Piece> pieces_of(const Receptance& structure, const std::vector<MeasuredState>& states,
                             const std::vector<std::size_t>& level) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const MeasuredState& state = states[i];
    const HarmonicLine line = harmonic_line(structure, Harmonics(state.harmonics), state.force, state.omega);
    for (Eigen::Index n = 0; n < state.response.rows(); ++n) {
      if (state.harmonics[static_cast<std::size_t>(n)] == 0) continue;
      pieces.push_back(piece_of(structure, state, line.harmonics[static_cast<std::size_t>(n)], n));
      pieces.back().level = level[i];
    }
  }
  return pieces;
}

double chi_square_of(const std::vector<Piece>& pieces) {
  double sum = 0.0;
  for (const Piece& piece : pieces) sum += (piece.difference().adjoint() * piece.weight * piece.difference())(0).real();
  return sum;
}

bool concerns(const DataFault& fault, std::size_t level) { return !fault.level || *fault.level == level; }

/// The gain by which χ² is least, that of the others being 1; the best is linear, for d changes by (gain − 1) times this.
Complex best_gain(const std::vector<Piece>& pieces, const DataFault& fault) {
  Complex against = 0.0;
  double own = 0.0;
  for (const Piece& piece : pieces) {
    if (!concerns(fault, piece.level)) continue;
    Eigen::VectorXcd change = -piece.free;
    if (fault.kind == DataFault::Kind::response) {
      change.setZero();
      change(fault.first) = piece.measured(fault.first);
    }
    const Eigen::VectorXcd weighted = piece.weight * change;
    against += weighted.dot(piece.difference());
    own += change.dot(weighted).real();
  }
  return own > 0.0 ? 1.0 - against / own : Complex(1.0);
}

/// With those of the state of another level at the same line, if there is one.
void exchange_forces(std::vector<MeasuredState>& states, const std::vector<std::size_t>& level, std::size_t i,
                     std::size_t other) {
  for (std::size_t k = 0; k < states.size(); ++k) {
    if (level[k] != other || states[k].omega != states[i].omega) continue;
    std::swap(states[k].force, states[i].force);
    std::swap(states[k].force_deviation, states[i].force_deviation);
    return;
  }
}

void mend(std::vector<MeasuredState>& states, const std::vector<std::size_t>& level, const DataFault& fault) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    MeasuredState& state = states[i];
    switch (fault.kind) {
      case DataFault::Kind::response:
        state.response.col(fault.first) *= fault.gain;
        state.deviation.col(fault.first) *= std::abs(fault.gain);
        break;
      case DataFault::Kind::force:
        if (concerns(fault, level[i])) state.force.amplitudes *= fault.gain;
        break;
      case DataFault::Kind::exchanged:
        state.response.col(fault.first).swap(state.response.col(fault.second));
        state.deviation.col(fault.first).swap(state.deviation.col(fault.second));
        break;
      case DataFault::Kind::levels:
        if (level[i] == *fault.level) exchange_forces(states, level, i, fault.other_level);
        break;
    }
  }
}

std::vector<DataFault> possible(Eigen::Index responses, const std::vector<std::size_t>& level) {
  using enum DataFault::Kind;
  std::vector<DataFault> all;
  for (Eigen::Index r = 0; r < responses; ++r) all.push_back({.kind = response, .first = r});
  all.push_back({.kind = force});
  const std::set<std::size_t> numbers(level.begin(), level.end());
  for (const std::size_t each : numbers) {
    if (numbers.size() > 1) all.push_back({.kind = force, .level = each});
    for (const std::size_t other : numbers) {
      if (other < each) all.push_back({.kind = levels, .level = other, .other_level = each});
    }
  }
  for (Eigen::Index r = 0; r < responses; ++r) {
    for (Eigen::Index s = 0; s < r; ++s) all.push_back({.kind = exchanged, .first = s, .second = r});
  }
  return all;
}

/// The fault with its gain, found again from states that the first one mended: their weights are better.
DataFault tried(const Receptance& structure, const std::vector<MeasuredState>& states, const std::vector<std::size_t>& level,
                const std::vector<Piece>& pieces, DataFault fault) {
  const bool has_gain = fault.kind == DataFault::Kind::response || fault.kind == DataFault::Kind::force;
  if (has_gain) fault.gain = best_gain(pieces, fault);
  for (int round = 0;; ++round) {
    std::vector<MeasuredState> mended = states;
    mend(mended, level, fault);
    const std::vector<Piece> again = pieces_of(structure, mended, level);
    fault.chi_square = chi_square_of(again);
    if (round == 2 || !has_gain || !(std::abs(fault.gain) > 0.0)) return fault;
    fault.gain *= best_gain(again, fault);
  }
}

/// A gain of nearly 0 leaves a channel out: no gain of it mends the data.
bool is_gain(const DataFault& fault) { return std::abs(fault.gain) > 1e-4 && std::abs(fault.gain) < 1e4; }

}  // namespace

Consistency test_consistency(const Receptance& structure, const std::vector<MeasuredState>& states, const std::vector<std::size_t>& level) {
  require_valid(states, structure);
  Consistency test;
  const Eigen::Index more = structure.responses() - structure.joints();
  if (more <= 0) return test;
  const std::vector<Piece> pieces = pieces_of(structure, states, level);
  if (pieces.empty()) return test;
  test.chi_square = chi_square_of(pieces);
  test.freedom = 2 * more * at(pieces.size());
  const auto levels = static_cast<double>(std::set<std::size_t>(level.begin(), level.end()).size());
  test.limit = levels * chi_square_quantile(static_cast<double>(test.freedom) / levels, 4.0);
  if (!test.contradicts()) return test;
  const auto freedom = static_cast<double>(test.freedom);
  for (const DataFault& fault : possible(structure.responses(), level)) {
    const DataFault found = tried(structure, states, level, pieces, fault);
    if (found.chi_square < freedom + 0.1 * (test.chi_square - freedom) && is_gain(found)) test.faults.push_back(found);
  }
  std::ranges::sort(test.faults, {}, &DataFault::chi_square);
  std::erase_if(test.faults, [&](const DataFault& each) {
    return each.chi_square > 2.0 * std::max(freedom, test.faults.front().chi_square);
  });
  return test;
}

}  // namespace jointid::response
