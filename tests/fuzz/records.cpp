// Time records: arrays of numpy, UFF 58, columns.
#include "fuzz_input.hpp"
#include "records/file/read_record.hpp"

using namespace jointid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span bytes(data, size);
  records::RecordOptions options{{records::parse_channel("1=1:+Z N"), records::parse_channel("2=2:+Z g")}, {}, 100.0};
  fuzz::expect_answer(bytes, {}, [&](const auto& path) { records::read_records(path, options); });
  options.rate_hz.reset();
  options.time = "1";
  fuzz::expect_answer(bytes, {}, [&](const auto& path) { records::read_records(path, options); });
  return 0;
}
