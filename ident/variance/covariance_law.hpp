#pragma once

#include <Eigen/Core>
#include <vector>

namespace jointid::ident {

/// The covariance C = D_H K D_Hᴴ + |c|² B of the errors of R FRFs H to one reference, D_H = diag(H): K of errors in proportion (the
/// hammer's noise is common to all responses), B of constant ones in the quantity of the file, |c|² the squared_factor() of the line.
/// Both are positive semidefinite; VarianceLaw is its diagonal.
struct CovarianceLaw {
  Eigen::MatrixXcd proportional, constant;  ///< [R,R]

  Eigen::MatrixXcd operator()(const Eigen::VectorXcd& frf, double squared_factor) const;
};

/// A covariance that was estimated on some line, and the FRFs there, both in the quantity of the file.
struct CovarianceSample {
  Eigen::VectorXcd frf;
  Eigen::MatrixXcd covariance;
};

/// The law under which samples of errors with these covariances are most likely (normal errors; expectation–maximisation, Dempster,
/// Laird and Rubin 1977, from medians of the variances: K and B stay semidefinite and no sample need be regular). Zero for no samples.
CovarianceLaw fit_covariance(std::vector<CovarianceSample> samples);

}  // namespace jointid::ident
