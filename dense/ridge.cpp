#include "dense/ridge.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "dense/cholesky.hpp"
#include "dense/gram.hpp"
#include "dense/qr.hpp"

namespace jointid::dense {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

/// The lower triangle of I + BᵀB, which is positive definite.
MatrixXd one_and_gram(const MatrixXd& b) {
  MatrixXd sum = MatrixXd::Identity(b.cols(), b.cols());
  add_gram(b.data(), static_cast<std::size_t>(b.rows()), static_cast<std::size_t>(b.cols()), static_cast<std::size_t>(b.rows()),
           sum.data());
  return sum;
}

/// Rows in groups that grow together.
class Groups {
 public:
  explicit Groups(Index rows) : leader_(static_cast<std::size_t>(rows)), size_(leader_.size(), 1) {
    std::iota(leader_.begin(), leader_.end(), Index{0});
  }
  Index of(Index row) {
    while (leader_[at(row)] != row) row = leader_[at(row)] = leader_[at(leader_[at(row)])];
    return row;
  }
  /// Makes one group of those of these rows, if it has no more rows than that.
  bool join(const std::vector<Index>& rows, Index most) {
    std::vector<Index> groups;
    for (const Index row : rows) groups.push_back(of(row));
    std::ranges::sort(groups);
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    Index sum = 0;
    for (const Index group : groups) sum += size_[at(group)];
    if (sum > most) return false;
    for (const Index group : groups) leader_[at(group)] = groups.front();
    size_[at(groups.front())] = sum;
    return true;
  }

 private:
  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
  std::vector<Index> leader_, size_;
};

}  // namespace

Ridge::Full::Full(MatrixXd b) : b_(std::move(b)) {
  lower_ = b_.rows() < b_.cols() ? one_and_gram(b_.transpose()) : one_and_gram(b_);
  cholesky_in_place(lower_);
}

/// Of a wide B by (I + BBᵀ)⁻¹: what a step from zero leaves of gradients of the size ‖B‖‖R‖ has lost the digits of a small U.
MatrixXd Ridge::Full::first(const Eigen::Ref<const MatrixXd>& r) const {
  if (b_.rows() >= b_.cols()) return step(r, MatrixXd::Zero(b_.cols(), r.cols()));
  MatrixXd solved = r;
  solve_lower(lower_, solved);
  solve_lower_transposed(lower_, solved);
  return -(b_.transpose() * solved);
}

/// Of the normal equations (I + BᵀB)δ = −(Bᵀ(R + BU) + U).
MatrixXd Ridge::Full::step(const Eigen::Ref<const MatrixXd>& r, const MatrixXd& u) const {
  MatrixXd gradient = -(b_.transpose() * (r + b_ * u) + u);
  if (b_.rows() >= b_.cols()) {
    solve_lower(lower_, gradient);
    solve_lower_transposed(lower_, gradient);
    return gradient;
  }
  MatrixXd solved = b_ * gradient;  // (I + BᵀB)⁻¹ = I − Bᵀ(I + BBᵀ)⁻¹B
  solve_lower(lower_, solved);
  solve_lower_transposed(lower_, solved);
  return gradient - b_.transpose() * solved;
}

MatrixXd Ridge::Full::best(const Eigen::Ref<const MatrixXd>& r) const {
  if (b_.cols() == 0) return MatrixXd::Zero(0, r.cols());
  const MatrixXd u = first(r);
  return u + step(r, u);
}

MatrixXd Ridge::Full::left(const Eigen::Ref<const MatrixXd>& r) const {
  const MatrixXd u = best(r);
  MatrixXd all(r.rows() + u.rows(), r.cols());
  all << r + b_ * u, u;
  return all.rows() > all.cols() ? triangle_of(all) : all;
}

Ridge::Ridge(MatrixXd b) {
  find_blocks(b);
  if (blocks_.empty()) {
    rest_ = Full(std::move(b));
  } else {
    rest_ = Full(without_blocks(b(Eigen::all, others_)));
    b_ = std::move(b);
  }
}

/// Columns of the fewest rows come first into blocks; a B of few rows or of few such columns has none.
void Ridge::find_blocks(const MatrixXd& b) {
  constexpr Index most = 24;  // rows of a block
  if (b.rows() < 2 * most) return;
  std::vector<std::pair<std::vector<Index>, Index>> columns;  // their rows, and which
  for (Index c = 0; c < b.cols(); ++c) {
    std::vector<Index> rows;
    for (Index r = 0; r < b.rows() && static_cast<Index>(rows.size()) <= most; ++r) {
      if (b(r, c) != 0.0) rows.push_back(r);
    }
    columns.emplace_back(std::move(rows), c);
  }
  std::ranges::stable_sort(columns, {}, [](const auto& column) { return column.first.size(); });
  Groups groups(b.rows());
  std::vector<std::pair<Index, Index>> inside;  // a row of the group, and which column
  for (const auto& [rows, c] : columns) {
    if (!rows.empty() && groups.join(rows, most)) {
      inside.emplace_back(rows.front(), c);
    } else {
      others_.push_back(c);
    }
  }
  if (4 * inside.size() < columns.size()) return;
  std::map<Index, Block> found;
  for (const auto& [row, c] : inside) found[groups.of(row)].columns.push_back(c);
  for (Index r = 0; r < b.rows(); ++r) {
    if (const auto block = found.find(groups.of(r)); block != found.end()) block->second.rows.push_back(r);
  }
  for (auto& [group, block] : found) {
    MatrixXd own = b(block.rows, block.columns);
    MatrixXd both(own.cols() + own.rows(), own.rows());
    both << own.transpose(), MatrixXd::Identity(own.rows(), own.rows());
    block.lower = triangle_of(both).transpose();
    block.own = Full(std::move(own));
    blocks_.push_back(std::move(block));
  }
}

MatrixXd Ridge::without_blocks(const Eigen::Ref<const MatrixXd>& r) const {
  MatrixXd out = r;
  for (const Block& block : blocks_) {
    MatrixXd own = r(block.rows, Eigen::all);
    solve_lower(block.lower, own);
    out(block.rows, Eigen::all) = own;
  }
  return out;
}

MatrixXd Ridge::best(const Eigen::Ref<const MatrixXd>& r) const {
  if (blocks_.empty()) return rest_.best(r);
  MatrixXd u(b_.cols(), r.cols());
  const MatrixXd of_others = rest_.best(without_blocks(r)), left = r + b_(Eigen::all, others_) * of_others;
  u(others_, Eigen::all) = of_others;
  for (const Block& block : blocks_) u(block.columns, Eigen::all) = block.own.best(left(block.rows, Eigen::all));
  return u;
}

MatrixXd Ridge::left(const Eigen::Ref<const MatrixXd>& r) const {
  return blocks_.empty() ? rest_.left(r) : rest_.left(without_blocks(r));
}

}  // namespace jointid::dense
