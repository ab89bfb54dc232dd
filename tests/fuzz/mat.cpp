// MATLAB v5 to v7 (matio) and v7.3 (HDF5).
#include "frf/mat/mat_file.hpp"

#include "frf/file/columns.hpp"
#include "fuzz_input.hpp"
#include "read_source.hpp"

using namespace jointid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span bytes(data, size);
  const fuzz::Allowance allowance{.base = std::size_t{16} << 20, .per_byte = 1200};  // deflate
  const bool hdf5 = size > 0 && (data[0] == 0x89 || (size > 520 && data[512] == 0x89));
  fuzz::expect_answer(bytes, allowance, [&](const auto& path) {
    fuzz::read_lines(*(hdf5 ? frf::open_mat_v73(path, fuzz::two_responses()) : frf::open_mat_v5(path, fuzz::two_responses())));
  });
  fuzz::expect_answer(bytes, allowance, [](const auto& path) { frf::read_columns(path); });
  return 0;
}
