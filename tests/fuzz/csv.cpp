// Tables of FRFs, and the columns of text files with loading curves.
#include "frf/csv/csv_file.hpp"

#include "frf/file/columns.hpp"
#include "fuzz_input.hpp"
#include "read_source.hpp"

using namespace jointid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span bytes(data, size);
  fuzz::expect_answer(bytes, {}, [](const auto& path) { fuzz::read_lines(*frf::open_csv(path)); });
  fuzz::expect_answer(bytes, {}, [](const auto& path) { fuzz::read_lines(*frf::open_csv(path, fuzz::two_responses())); });
  fuzz::expect_answer(bytes, {}, [](const auto& path) { frf::read_columns(path); });
  return 0;
}
