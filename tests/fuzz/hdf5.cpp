// HDF5: jointid-frf, tables of studies, and the columns of any other file.
#include "frf/hdf5/hdf5_file.hpp"

#include "frf/file/columns.hpp"
#include "frf/hdf5/table_file.hpp"
#include "fuzz_input.hpp"
#include "read_source.hpp"

using namespace jointid;

namespace {

void read_table(const std::filesystem::path& path) {
  const frf::TableReader table(path);
  std::vector<double> numbers(std::min<std::size_t>(table.rows(), 1024));
  for (std::size_t column = 0; column < table.header().columns.size(); ++column) table.read(column, 0, numbers);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span bytes(data, size);
  // HDF5's own caches and free lists, and what deflate unpacks.
  const fuzz::Allowance allowance{.base = std::size_t{16} << 20, .per_byte = 1200};
  fuzz::expect_answer(bytes, allowance, [](const auto& path) { fuzz::read_lines(*frf::open_hdf5(path)); });
  fuzz::expect_answer(bytes, allowance, read_table);
  fuzz::expect_answer(bytes, allowance, [](const auto& path) { frf::read_columns(path); });
  return 0;
}
