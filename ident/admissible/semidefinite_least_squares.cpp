#include "ident/admissible/semidefinite_least_squares.hpp"

#include "dense/cholesky.hpp"
#include "ident/admissible/interior_iteration.hpp"

namespace jointid::ident {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double wanted = 1e-12;  ///< gap over max(1, ‖x‖²)

/// x of θ = origin + basis·x, M = I: every block may touch every x.
class WhitenedSpace {
 public:
  WhitenedSpace(const std::vector<SymmetricBlock>& blocks, const VectorXd& origin, const MatrixXd& basis)
      : blocks_(blocks), origin_(origin), basis_(basis) {}

  Eigen::Index unknowns() const { return basis_.cols(); }
  InteriorBlock block(std::size_t k) const { return {blocks_[k], origin_, basis_}; }
  const VectorXd& own(std::size_t, const VectorXd& x) const { return x; }
  void add(std::size_t, const VectorXd& own, VectorXd& to) const { to += own; }
  const VectorXd& gradient(const VectorXd& x) const { return x; }

  bool factor(const std::vector<InteriorBlock>& blocks) {
    matrix_ = MatrixXd::Identity(basis_.cols(), basis_.cols());
    for (const InteriorBlock& block : blocks) block.add_curvature(matrix_);
    return dense::cholesky_in_place(matrix_);
  }

  void solve(VectorXd& right) const {
    dense::solve_lower(matrix_, right);
    dense::solve_lower_transposed(matrix_, right);
  }

 private:
  const std::vector<SymmetricBlock>& blocks_;
  const VectorXd& origin_;
  const MatrixXd& basis_;
  MatrixXd matrix_;
};

}  // namespace

SemidefiniteFit solve_semidefinite(const std::vector<SymmetricBlock>& blocks, const VectorXd& origin, const MatrixXd& basis) {
  WhitenedSpace space(blocks, origin, basis);
  return InteriorIteration<WhitenedSpace>(space, blocks.size(), wanted).run();
}

}  // namespace jointid::ident
