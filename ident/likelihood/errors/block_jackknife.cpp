#include "ident/likelihood/errors/block_jackknife.hpp"

#include <algorithm>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "dense/cholesky.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t least_lines = 3, most_blocks = 20, least_blocks = 6;

/// Of the unknowns, where the others are `taken`.
Scores without(const Scores& all, const Eigen::VectorXd& taken) {
  const Eigen::Index n = all.gradient.size() - taken.size();
  return {all.information.topLeftCorner(n, n), all.gradient.head(n) - all.information.topRightCorner(n, taken.size()) * taken};
}

}  // namespace

BlockScores::BlockScores(std::size_t lines, std::size_t unknowns, std::size_t first, std::size_t more)
    : lines_(lines),
      unknowns_(unknowns),
      first_(first),
      more_(more),
      blocks_(std::clamp<std::size_t>(lines / least_lines, 1, most_blocks)) {}

Scores& BlockScores::block(std::size_t b) {
  if (blocks_[b].gradient.size() == 0) blocks_[b] = Scores::none(unknowns_ + more_);
  return blocks_[b];
}

void BlockScores::add(const ScoredLine& line) {
  std::vector<std::size_t> columns = line.columns;
  for (std::size_t& column : columns) {
    if (column < unknowns_) continue;
    column = column >= first_ && column < first_ + more_ ? unknowns_ + column - first_ : unknowns_ + more_;
  }
  block(line.line * blocks_.size() / lines_).add({line.line, line.weight, columns, line.reduced, line.data});
}

BlockScores& BlockScores::operator+=(const BlockScores& other) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (other.blocks_[b].gradient.size() > 0) block(b) += other.blocks_[b];
  }
  return *this;
}

std::vector<double> BlockScores::numbers() {
  std::vector<double> out;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Scores& block = this->block(b);
    out.insert(out.end(), block.information.data(), block.information.data() + block.information.size());
    out.insert(out.end(), block.gradient.data(), block.gradient.data() + block.gradient.size());
  }
  return out;
}

void BlockScores::take(const std::vector<double>& numbers) {
  auto from = numbers.begin();
  for (Scores& block : blocks_) {
    std::copy_n(from, block.information.size(), block.information.data());
    from += block.information.size();
    std::copy_n(from, block.gradient.size(), block.gradient.data());
    from += block.gradient.size();
  }
}

std::optional<Jackknife> BlockScores::jackknife(const Scores& whole, const Eigen::VectorXd& taken) const {
  if (blocks_.size() < least_blocks) return std::nullopt;
  const Scores all = without(whole, taken);
  const Eigen::Index n = all.information.rows();
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd inverse = minimise::covariance_of(all.information);
  const Eigen::VectorXd place = inverse * all.gradient;
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(n), expected = squares;
  std::vector<Eigen::MatrixXd> moves;  // covariances of the moves without a block
  Jackknife out{.variance = {}, .step = inverse * whole.gradient.head(n), .blocks = blocks_.size()};
  for (const Scores& each : blocks_) {
    if (each.gradient.size() == 0) continue;
    const Scores block = without(each, taken);
    const auto rest = dense::solve_definite(all.information - block.information, all.gradient - block.gradient);
    if (!rest || !(rest->reciprocal_condition > 1e-13)) return std::nullopt;
    squares += (rest->x - place).cwiseAbs2();
    moves.push_back(dense::solve_positive(all.information - block.information, unit) - inverse);
    expected += moves.back().diagonal();
  }
  if (!(expected.minCoeff() > 0.0)) return std::nullopt;
  const auto count = static_cast<double>(blocks_.size());
  out.variance = (count - 1.0) / count * squares;
  out.mean = squares.cwiseQuotient(expected).mean();
  // The variance of the mean, that of a quadratic form of normal moves.
  const Eigen::VectorXd scale = expected.cwiseSqrt().cwiseInverse();
  double variance = 0.0;
  for (const Eigen::MatrixXd& each : moves) variance += 2.0 * (scale.asDiagonal() * each * scale.asDiagonal()).squaredNorm();
  const double freedom = 2.0 * static_cast<double>(n * n) / variance;
  out.likely = chi_square_quantile(freedom, 5.0) / freedom;
  return out;
}

}  // namespace jointid::ident
