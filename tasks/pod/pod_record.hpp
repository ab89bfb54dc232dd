#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ident/team/team.hpp"
#include "oscillation/pod/pod.hpp"
#include "tasks/pod/pod_task.hpp"

namespace jointid::tasks {

/// What `pod` reads: the triangle of the record, and what the files say of its channels. Of samples in memory:
/// oscillation::record_triangle().
struct PodRecord {
  std::vector<std::string> names, units;  ///< of the channels
  std::size_t cut = 0;                    ///< samples of longer channels that were left out, of all channels together
  oscillation::RecordTriangle triangle;        ///< sums of the samples and of their products, n channels: n(n+1)/2 numbers
};

/// Reads the files block by block (records::open_samples()); several files are further samples of the same channels. Each process
/// of the team reads its part of every file, and all get the whole. `read` is told how many samples this process has read. Throws
/// InputError, and Interrupted when that was asked for.
PodRecord read_pod_record(const PodTask& task, ident::Team& team, const std::function<void(std::size_t)>& read,
                          const std::function<bool()>& interrupted);

/// A matrix of numbers, a column a column; `rows` of them. Throws InputError for another number of rows or numbers that are
/// missing.
Eigen::MatrixXd read_pod_matrix(const std::filesystem::path& file, std::size_t rows, const std::string& option);

}  // namespace jointid::tasks
