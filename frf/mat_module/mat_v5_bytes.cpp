#include "frf/mat_module/mat_v5_bytes.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <string>

namespace jointid::frf::mat {
namespace {

constexpr std::size_t buffer_bytes = 65536;
using Buffer = std::array<unsigned char, buffer_bytes>;

class Stored final : public Bytes {
 public:
  Stored(std::ifstream& file, std::uint64_t begin, std::uint64_t size) : file_(file), left_(size) {
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(begin));
  }

  void read(std::span<unsigned char> out) override {
    take(out.size());
    if (!file_.read(reinterpret_cast<char*>(out.data()), static_cast<std::streamsize>(out.size()))) {
      throw Damaged("the file is shorter than it was");
    }
  }

  void skip(std::uint64_t count) override {
    take(count);
    file_.seekg(static_cast<std::streamoff>(count), std::ios::cur);
  }

 private:
  void take(std::uint64_t count) {
    if (count > left_) throw Damaged("it ends early");
    left_ -= count;
  }

  std::ifstream& file_;
  std::uint64_t left_;
};

class Inflated final : public Bytes {
 public:
  Inflated(std::ifstream& file, std::uint64_t begin, std::uint64_t size) : packed_(file, begin, size), packed_left_(size) {
    if (inflateInit(&stream_) != Z_OK) throw Damaged("zlib cannot start");
  }
  ~Inflated() override { inflateEnd(&stream_); }

  void read(std::span<unsigned char> out) override {
    stream_.next_out = out.data();
    stream_.avail_out = static_cast<uInt>(out.size());
    while (stream_.avail_out > 0) {
      if (at_end_) throw Damaged("its packed data end early");
      step();
    }
  }

  void finish() override {
    std::array<unsigned char, 1> more{};
    stream_.next_out = more.data();
    stream_.avail_out = more.size();
    while (!at_end_) {
      step();
      if (stream_.avail_out == 0) throw Damaged("its packed data go on beyond its end");
    }
  }

 private:
  void step() {
    if (stream_.avail_in == 0 && packed_left_ > 0) {
      const std::size_t count = std::min<std::uint64_t>(buffer_.size(), packed_left_);
      packed_.read(std::span(buffer_).first(count));
      packed_left_ -= count;
      stream_.next_in = buffer_.data();
      stream_.avail_in = static_cast<uInt>(count);
    }
    const int outcome = inflate(&stream_, Z_NO_FLUSH);
    at_end_ = outcome == Z_STREAM_END;
    if (outcome == Z_OK || at_end_) return;
    throw Damaged("its packed data cannot be unpacked" + (stream_.msg == nullptr ? "" : " (" + std::string(stream_.msg) + ")"));
  }

  Stored packed_;
  std::uint64_t packed_left_;
  z_stream stream_{};
  Buffer buffer_;
  bool at_end_ = false;
};

}  // namespace

void Bytes::skip(std::uint64_t count) {
  Buffer passed;
  while (count > 0) {
    const std::size_t piece = std::min<std::uint64_t>(passed.size(), count);
    read(std::span(passed).first(piece));
    count -= piece;
  }
}

std::unique_ptr<Bytes> stored_bytes(std::ifstream& file, std::uint64_t begin, std::uint64_t size) {
  return std::make_unique<Stored>(file, begin, size);
}

std::unique_ptr<Bytes> inflated_bytes(std::ifstream& file, std::uint64_t begin, std::uint64_t size) {
  return std::make_unique<Inflated>(file, begin, size);
}

}  // namespace jointid::frf::mat
