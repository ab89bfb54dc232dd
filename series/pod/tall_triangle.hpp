#pragma once

#include "base/eigen.hpp"

namespace jointid::series {

/// R of A = QR, upper triangular [n, n], of a tall matrix [m ≥ n, n] that is overwritten: Householder reflections in panels of 16
/// columns, applied to the rest as products of matrices (compact WY form: Schreiber & Van Loan 1989). Eigen's own panels of 48
/// columns leave most of the work on some 65 columns to products with vectors, which take twice the time.
Eigen::MatrixXd tall_triangle(Eigen::MatrixXd& a);

}  // namespace jointid::series
