// Universal files: 58 and 58b as FRFs, their summary, single records, and the modes of 55.
#include "frf/uff/uff_file.hpp"

#include "base/error.hpp"
#include "frf/uff/uff55.hpp"
#include "fuzz_input.hpp"
#include "read_source.hpp"

using namespace jointid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span bytes(data, size);
  fuzz::expect_answer(bytes, {}, [](const auto& path) { fuzz::read_lines(*frf::open_uff(path)); });
  fuzz::expect_answer(bytes, {}, [](const auto& path) {
    frf::OpenOptions options;
    options.spectra = frf::OpenOptions::Spectra::motions;
    fuzz::read_lines(*frf::open_uff(path, options));
  });
  fuzz::expect_answer(bytes, {}, [](const auto& path) {
    const std::size_t records = frf::summarize_uff(path).functions.size();
    for (std::size_t i = 0; i < std::min<std::size_t>(records, 4); ++i) frf::read_uff58(path, i);
  });
  fuzz::expect_answer(bytes, {}, [](const auto& path) { frf::read_uff55(path); });
  return 0;
}
