#include "ident/likelihood/errors/block_jackknife.hpp"

#include <algorithm>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t least_lines = 3, most_blocks = 20, least_blocks = 6;

}  // namespace

BlockScores::BlockScores(std::size_t lines, std::size_t unknowns)
    : lines_(lines), unknowns_(unknowns), blocks_(std::clamp<std::size_t>(lines / least_lines, 1, most_blocks)) {}

Scores& BlockScores::block(std::size_t b) {
  if (blocks_[b].gradient.size() == 0) blocks_[b] = Scores::none(unknowns_);
  return blocks_[b];
}

void BlockScores::add(const ScoredLine& line) { block(line.line * blocks_.size() / lines_).add(line); }

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

std::optional<Eigen::MatrixXd> BlockScores::covariance(const Eigen::MatrixXd& whole) const {
  if (blocks_.size() < least_blocks) return std::nullopt;
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(whole.rows(), whole.cols());
  for (const Scores& block : blocks_) {
    if (block.gradient.size() == 0) continue;
    const auto rest = dense::solve_definite(whole - block.information, block.gradient);
    if (!rest) return std::nullopt;
    out += rest->x * rest->x.transpose();
  }
  const auto count = static_cast<double>(blocks_.size());
  return (count - 1.0) / count * out;
}

}  // namespace jointid::ident
