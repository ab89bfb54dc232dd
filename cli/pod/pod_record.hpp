#pragma once

#include <string>
#include <vector>

#include "cli/pod/pod_arguments.hpp"
#include "series/pod/pod.hpp"

namespace jointid::cli {

/// What `pod` reads: the triangle of the record, and what the files say of its channels.
struct PodRecord {
  std::vector<std::string> names, units;
  std::size_t cut = 0;  ///< samples of longer channels that were left out, of all channels together
  series::RecordTriangle triangle;
};

/// The one place that knows how records are read: columns of text, MATLAB and HDF5 files (frf::read_columns()). Several files are
/// further samples of the same channels. Channels of one file that differ in length are cut to the shortest. Throws InputError.
PodRecord read_pod_record(const PodArguments& arguments);

/// A matrix of numbers, a column a column; `rows` of them. Throws InputError for another number of rows or numbers that are
/// missing.
Eigen::MatrixXd read_pod_matrix(const std::filesystem::path& file, std::size_t rows, const std::string& option);

}  // namespace jointid::cli
