#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "ident/scene/scene.hpp"
#include "ident/variance/covariance_law.hpp"

namespace jointid::ident {

/// Whether a file has covariances and the scene takes its variances from it.
bool covariances_count(const frf::FrfSource& source, const Scene& scene);

/// FRFs and covariances of some responses to one reference at some lines of a file.
struct StoredGroup {
  std::vector<Complex> values, covariances;
  std::size_t size;  ///< responses

  Eigen::VectorXcd frf(std::size_t line) const;
  Eigen::MatrixXcd covariance(std::size_t line) const;
};

StoredGroup read_stored(frf::FrfSource& source, const std::vector<std::size_t>& responses, std::size_t reference,
                        const std::vector<std::size_t>& lines);

/// Degrees of freedom behind the covariances of a file; 0: not known, they are taken as they stand.
double freedom_of(const frf::FrfHeader& header);

/// The i-th line of such a group, line `line` of its file, in the quantity of the file.
CovarianceSample sample_of(const StoredGroup& stored, std::size_t i, const frf::FrfHeader& header, std::size_t line);

/// The law of samples of a file over so many responses; of those that are known on half of them at least, zero for the others. None from
/// so few samples that it would be little more than theirs.
CovarianceLaw law_of(const std::vector<CovarianceSample>& samples, const frf::FrfHeader& header, std::size_t responses);

}  // namespace jointid::ident
