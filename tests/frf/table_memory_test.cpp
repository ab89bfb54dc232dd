#include <gtest/gtest.h>
#include <malloc.h>

#include "file_fixture.hpp"
#include "frf/hdf5/table_file.hpp"

namespace jointid::frf {
namespace {

/// Bytes that the process has from the C library, HDF5's among them; 0 under the sanitizers, which have their own.
std::size_t bytes_in_use() {
  const auto info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
}

class TableMemory : public FileTest {
 protected:
  static constexpr std::size_t columns = 27;

  std::size_t peak_of_writing(std::size_t rows) const {
    TableHeader header{.texts = {}, .columns = std::vector<TableColumn>(columns, {"x", "N/m", 1.0})};
    TableWriter table(path("t.h5"), header, rows);
    std::vector<double> block(4096 * columns, 0.5);
    std::size_t peak = 0;
    for (std::size_t row = 0; row < rows; row += 4096) {
      table.append(block);
      peak = std::max(peak, bytes_in_use());
    }
    table.finish();
    return peak;
  }

  std::size_t peak_of_reading() const {
    const TableReader table(path("t.h5"));
    std::vector<double> numbers(4096);
    std::size_t peak = 0;
    for (std::size_t column = 0; column < columns; ++column) {
      for (std::size_t row = 0; row < table.rows(); row += 4096) {
        table.read(column, row, numbers);
        peak = std::max(peak, bytes_in_use());
      }
    }
    return peak;
  }
};

/// Each chunk has a place in HDF5's index, which takes 272 bytes of memory and more.
TEST_F(TableMemory, DoesNotGrowWithTheRows) {
  const std::size_t few = 64 * 4096, many = 3 * few;
  const std::size_t write_few = peak_of_writing(few), read_few = peak_of_reading();
  EXPECT_LT(peak_of_writing(many), write_few + 200'000);
  EXPECT_LT(peak_of_reading(), read_few + 200'000);
}

}  // namespace
}  // namespace jointid::frf
