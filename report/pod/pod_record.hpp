#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ident/team/team.hpp"
#include "report/pod/pod_task.hpp"
#include "series/pod/pod.hpp"

namespace jointid::report {

/// What `pod` reads: the triangle of the record, and what the files say of its channels.
struct PodRecord {
  std::vector<std::string> names, units;
  std::size_t cut = 0;  ///< samples of longer channels that were left out, of all channels together
  series::RecordTriangle triangle;
};

/// Reads the files block by block (records::open_samples()); several files are further samples of the same channels. Each process
/// of the team reads its part of every file, and all get the whole. `read` is told how many samples this process has read. Throws
/// InputError, and Interrupted when that was asked for.
PodRecord read_pod_record(const PodTask& task, ident::Team& team, const std::function<void(std::size_t)>& read,
                          const std::function<bool()>& interrupted);

/// A matrix of numbers, a column a column; `rows` of them. Throws InputError for another number of rows or numbers that are
/// missing.
Eigen::MatrixXd read_pod_matrix(const std::filesystem::path& file, std::size_t rows, const std::string& option);

}  // namespace jointid::report
