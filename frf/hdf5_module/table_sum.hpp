#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "frf/hdf5/table_file.hpp"

namespace jointid::frf::hdf5 {

constexpr const char* header_sum_name = "checksum";         ///< root attribute: of all but the rows
constexpr const char* column_sums_name = "column_checksum"; ///< dataset [C]: of the numbers of each column

/// Of the numbers of a column, in their order: any number that changes, is missing or stands elsewhere changes it.
class ColumnSum {
 public:
  void add(double number) {
    sum_ = (sum_ ^ std::bit_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15ULL;
    sum_ ^= sum_ >> 29U;
  }

  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325ULL;
};

/// Of texts, names, units and truths of the columns, and the number of rows, in hexadecimal digits.
std::string header_sum(const TableHeader& header, std::size_t rows);

}  // namespace jointid::frf::hdf5
