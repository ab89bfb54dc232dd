#include <zlib.h>

#include <algorithm>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "frf/mat_module/files.hpp"

namespace jointid::frf {
namespace {

struct EndInflate {
  void operator()(z_stream* stream) const { inflateEnd(stream); }
};

}  // namespace

std::size_t mat::inflate_raw(std::string_view packed, std::span<char> out) {
  constexpr std::size_t most = std::size_t{1} << 30;  // zlib counts in 32 bits
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) refuse("zlib cannot start");
  const std::unique_ptr<z_stream, EndInflate> owned(&stream);
  std::size_t made = 0, taken = 0;
  for (int outcome = Z_OK; outcome != Z_STREAM_END && made < out.size();) {
    const std::size_t room = std::min(most, out.size() - made), left = std::min(most, packed.size() - taken);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + taken));  // NOLINT: zlib does not write there
    stream.avail_in = static_cast<uInt>(left);
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + made);
    stream.avail_out = static_cast<uInt>(room);
    outcome = inflate(&stream, Z_NO_FLUSH);
    taken += left - stream.avail_in;
    made += room - stream.avail_out;
    if (outcome == Z_BUF_ERROR) refuse("its packed data end early");
    if (outcome != Z_OK && outcome != Z_STREAM_END) refuse("its packed data cannot be unpacked");
  }
  return made;
}

}  // namespace jointid::frf
