#pragma once

#include "frf/hdf5/table_file.hpp"
#include "ident/result/solution.hpp"
#include "study/order_statistics.hpp"

namespace jointid::study {

/// Columns of a study's result file without the trials that gave no estimate, read in pieces of a fixed number of trials.
class UsableColumns {
 public:
  using RowVisitor = std::function<void(std::span<const std::vector<double>> columns)>;

  explicit UsableColumns(const frf::TableReader& table) : table_(table) {}

  /// How many trials ended so.
  std::size_t count(ident::Status status) const;

  /// Gives the pieces of several columns, as long as each other, in the order of the trials.
  void each_piece(std::vector<std::size_t> columns, const RowVisitor& visit) const;

  ColumnPass pass(std::size_t column) const;

 private:
  const frf::TableReader& table_;
};

}  // namespace jointid::study
