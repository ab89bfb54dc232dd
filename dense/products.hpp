#pragma once

#include <Eigen/Core>

// The inner loops of Eigen's products are compiled once, optimised, by products.cpp. Precompiled into every source
// (cmake/JointidBuild.cmake), this header keeps sources that multiply from compiling them again: a tenth of their time.

#ifndef JOINTID_COMPILED_ONCE
#define JOINTID_COMPILED_ONCE extern
#endif

#define JOINTID_MATRIX_PRODUCT(Scalar, ConjugateLeft, ConjugateRight)                                                 \
  JOINTID_COMPILED_ONCE template struct gebp_kernel<Scalar, Scalar, Index, blas_data_mapper<Scalar, Index, ColMajor>, \
                                                    gebp_traits<Scalar, Scalar>::mr, gebp_traits<Scalar, Scalar>::nr, \
                                                    ConjugateLeft, ConjugateRight>;
#define JOINTID_PACKING(Scalar, Order)                                                                                           \
  JOINTID_COMPILED_ONCE template struct gemm_pack_lhs<Scalar, Index, const_blas_data_mapper<Scalar, Index, Order>,               \
                                                      gebp_traits<Scalar, Scalar>::mr, gebp_traits<Scalar, Scalar>::LhsProgress, \
                                                      gebp_traits<Scalar, Scalar>::LhsPacket4Packing, Order>;                    \
  JOINTID_COMPILED_ONCE template struct gemm_pack_rhs<Scalar, Index, const_blas_data_mapper<Scalar, Index, Order>,               \
                                                      gebp_traits<Scalar, Scalar>::nr, Order>;
#define JOINTID_VECTOR_PRODUCT(Left, ConjugateLeft, Right)                                        \
  JOINTID_COMPILED_ONCE template struct general_matrix_vector_product<                            \
      Index, Left, const_blas_data_mapper<Left, Index, ColMajor>, ColMajor, ConjugateLeft, Right, \
      const_blas_data_mapper<Right, Index, RowMajor>, false, 0>;                                  \
  JOINTID_COMPILED_ONCE template struct general_matrix_vector_product<                            \
      Index, Left, const_blas_data_mapper<Left, Index, RowMajor>, RowMajor, ConjugateLeft, Right, \
      const_blas_data_mapper<Right, Index, ColMajor>, false, 0>;
#define JOINTID_BLOCKING(Scalar, Factor)                                                                                   \
  JOINTID_COMPILED_ONCE template void evaluateProductBlockingSizesHeuristic<Scalar, Scalar, Factor, Index>(Index&, Index&, \
                                                                                                           Index&, Index);

namespace Eigen::internal {

using jointid_complex = std::complex<double>;

JOINTID_MATRIX_PRODUCT(double, false, false)
JOINTID_MATRIX_PRODUCT(jointid_complex, false, false)
JOINTID_MATRIX_PRODUCT(jointid_complex, true, false)
JOINTID_MATRIX_PRODUCT(jointid_complex, false, true)
JOINTID_PACKING(double, ColMajor)
JOINTID_PACKING(double, RowMajor)
JOINTID_PACKING(jointid_complex, ColMajor)
JOINTID_PACKING(jointid_complex, RowMajor)
JOINTID_VECTOR_PRODUCT(double, false, double)
JOINTID_VECTOR_PRODUCT(jointid_complex, false, jointid_complex)
JOINTID_VECTOR_PRODUCT(jointid_complex, true, jointid_complex)
JOINTID_BLOCKING(double, 1)
JOINTID_BLOCKING(double, 4)
JOINTID_BLOCKING(jointid_complex, 1)
JOINTID_BLOCKING(jointid_complex, 4)

}  // namespace Eigen::internal

#undef JOINTID_MATRIX_PRODUCT
#undef JOINTID_PACKING
#undef JOINTID_VECTOR_PRODUCT
#undef JOINTID_BLOCKING
#undef JOINTID_COMPILED_ONCE
