// Files of named arrays: MATLAB v4, v5 to v7 (matio) and v7.3 (HDF5), numpy.
#include "frf/mat/mat_file.hpp"

#include "frf/file/columns.hpp"
#include "frf/file/variables.hpp"
#include "frf/npy/npy_file.hpp"
#include "frf/npy/npy_header.hpp"
#include "fuzz_input.hpp"
#include "read_source.hpp"

using namespace jointid;

namespace {

/// All of them, sparse matrices too.
void read_arrays(const std::filesystem::path& path) {
  const auto file = frf::open_variables(path);
  if (!file) return;
  for (const frf::MatInfo& info : file->variables()) {
    if (info.kind != frf::MatKind::other) file->read(info);
  }
}

void read_numpy(std::span<const std::uint8_t> bytes, bool archive) {
  // Deflated singles become complex doubles, once as the file holds them and once in our order.
  const fuzz::Allowance allowance{.base = std::size_t{16} << 20, .per_byte = 8192};
  fuzz::expect_answer(bytes, allowance, [&](const auto& path) {
    frf::OpenOptions options = fuzz::two_responses();
    if (!archive) options.frequency_variable = path.filename().string();
    fuzz::read_lines(*(archive ? frf::open_npz(path, options) : frf::open_npy(path, options)));
  });
  fuzz::expect_answer(bytes, allowance, read_arrays);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span bytes(data, size);
  const std::string_view head(reinterpret_cast<const char*>(data), size);
  if (frf::looks_like_npy(head) || frf::looks_like_npz(head)) {
    read_numpy(bytes, frf::looks_like_npz(head));
    return 0;
  }
  const fuzz::Allowance allowance{.base = std::size_t{16} << 20, .per_byte = 1200};  // deflate
  const bool hdf5 = size > 0 && (data[0] == 0x89 || (size > 520 && data[512] == 0x89));
  fuzz::expect_answer(bytes, allowance, [&](const auto& path) {
    fuzz::read_lines(*(hdf5 ? frf::open_mat_v73(path, fuzz::two_responses()) : frf::open_mat_v5(path, fuzz::two_responses())));
  });
  fuzz::expect_answer(bytes, allowance, [](const auto& path) { frf::read_columns(path); });
  fuzz::expect_answer(bytes, allowance, read_arrays);
  return 0;
}
