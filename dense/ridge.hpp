#pragma once

#include <Eigen/Core>
#include <vector>

namespace jointid::dense {

/// min over U of ‖R + BU‖² + ‖U‖² for one B and many right-hand sides R, column by column. Columns of B that are zero but in a
/// few rows are eliminated first, in blocks that share no row; U then is known to about ‖B‖² roundings.
class Ridge {
 public:
  explicit Ridge(Eigen::MatrixXd b);

  const Eigen::MatrixXd& b() const { return blocks_.empty() ? rest_.b() : b_; }

  /// U = −(I + BᵀB)⁻¹BᵀR = −Bᵀ(I + BBᵀ)⁻¹R by the Cholesky factor of the smaller of the two, and one step of refinement.
  Eigen::MatrixXd best(const Eigen::Ref<const Eigen::MatrixXd>& r) const;

  /// At most as many rows as R has columns, with the inner products that [R + BU; U] has: what the best U leaves.
  Eigen::MatrixXd left(const Eigen::Ref<const Eigen::MatrixXd>& r) const;

 private:
  /// A B that has no structure.
  class Full {
   public:
    Full() = default;
    explicit Full(Eigen::MatrixXd b);
    const Eigen::MatrixXd& b() const { return b_; }
    Eigen::MatrixXd best(const Eigen::Ref<const Eigen::MatrixXd>& r) const;
    Eigen::MatrixXd left(const Eigen::Ref<const Eigen::MatrixXd>& r) const;

   private:
    Eigen::MatrixXd first(const Eigen::Ref<const Eigen::MatrixXd>& r) const;
    Eigen::MatrixXd step(const Eigen::Ref<const Eigen::MatrixXd>& r, const Eigen::MatrixXd& u) const;

    Eigen::MatrixXd b_, lower_;
  };

  /// Columns that are zero outside of these rows.
  struct Block {
    std::vector<Eigen::Index> rows, columns;
    Full own;
    Eigen::MatrixXd lower;  ///< L of I + bbᵀ = LLᵀ, by QR of [bᵀ; I]: the sum would square the condition
  };

  void find_blocks(const Eigen::MatrixXd& b);
  /// R with the inner products that the best U of the blocks' columns leaves: of each block L⁻¹ of its rows.
  Eigen::MatrixXd without_blocks(const Eigen::Ref<const Eigen::MatrixXd>& r) const;

  std::vector<Block> blocks_;
  std::vector<Eigen::Index> others_;  ///< columns
  Full rest_;                         ///< these columns without the blocks; all of B where there are none
  Eigen::MatrixXd b_;                 ///< where there are
};

}  // namespace jointid::dense
