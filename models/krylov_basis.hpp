#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "models/sparse_factors.hpp"

namespace jointid::models {

/// K and M as seen from a growing basis V of real vectors, VᵀV = I: the rational Krylov space of some inputs B, unit forces. Its
/// receptance BᵀV(VᵀZV)⁻¹VᵀB agrees with BᵀZ⁻¹B and three derivatives at every shift (Grimme 1997, theorem 3.1; Z symmetric).
/// With G = K + σM it begins with G⁻¹B and G⁻¹MG⁻¹B.
class KrylovBasis {
 public:
  using Sparse = Eigen::SparseMatrix<double>;

  /// `stiffness` and `mass` symmetric, N × N; they are kept by reference. `inputs` < N, σ > 0.
  KrylovBasis(const Sparse& stiffness, const Sparse& mass, const std::vector<std::size_t>& inputs, double sigma);
  ~KrylovBasis();
  KrylovBasis(const KrylovBasis&) = delete;
  KrylovBasis& operator=(const KrylovBasis&) = delete;

  /// The first vectors. False where G is not positive definite: nothing else may be called then.
  bool begin();

  /// V gets what is new of G⁻¹MV of the vectors that were added last: no factorisation. It follows slow motions first.
  void add_power();

  /// Whether that takes far less time than add().
  bool prefers_powers() const { return positive_->is_supernodal(); }

  /// V gets what is new of X = (K − sM)⁻¹BW and (K − sM)⁻¹MX by one real factorisation; W has combinations of the inputs for
  /// columns. False, and V as before, where K − sM is singular to rounding.
  bool add(double shift, const Eigen::MatrixXd& combinations);

  Eigen::Index size() const { return size_; }
  double sigma() const { return sigma_; }

  Eigen::MatrixXd stiffness() const { return reduced_stiffness_.topLeftCorner(size_, size_); }  ///< VᵀKV
  Eigen::MatrixXd mass() const { return reduced_mass_.topLeftCorner(size_, size_); }            ///< VᵀMV
  Eigen::MatrixXd inputs() const;                                                               ///< BᵀV
  /// VᵀM G⁻¹ MV: less the same within V it is what V lacks of G⁻¹MV.
  Eigen::MatrixXd reached() const { return reached_.topLeftCorner(size_, size_); }

 private:
  struct Factors;
  Eigen::MatrixXd forces(const Eigen::MatrixXd& combinations) const;
  void append(Eigen::MatrixXd block);
  void take(Eigen::VectorXd vector, double left, Eigen::Index first);
  void reduce_from(Eigen::Index first);
  void make_room(Eigen::Index columns);

  const Sparse &stiffness_, &mass_;
  std::vector<std::size_t> inputs_;
  double sigma_;
  std::unique_ptr<PositiveFactors> positive_;                           ///< of G
  std::unique_ptr<Factors> factors_;                                    ///< of the last shift
  Eigen::MatrixXd power_;                                               ///< G⁻¹MV of the vectors that were added last
  Eigen::MatrixXd basis_, reduced_stiffness_, reduced_mass_, reached_;  ///< with room to grow; `size_` columns count
  Eigen::Index size_ = 0;
};

}  // namespace jointid::models
