#include "frf/hdf5_module/table_sum.hpp"

#include <fmt/format.h>

#include "frf/hdf5/record_journal.hpp"

namespace jointid::frf {

std::string hdf5::header_sum(const TableHeader& header, std::size_t rows) {
  std::string text = fmt::format("{}\n", rows);
  for (const auto& [name, value] : header.texts) text += fmt::format("{}\n{}\n", name, value);
  for (const TableColumn& column : header.columns) {
    text += fmt::format("{}\n{}\n{:016x}\n", column.name, column.unit, std::bit_cast<std::uint64_t>(column.truth));
  }
  return fmt::format("{:016x}", checksum(std::as_bytes(std::span(text))));
}

}  // namespace jointid::frf
