#include "frf/uff/uff_bytes.hpp"

#include "base/error.hpp"

namespace jointid::frf::uff {

void Place::fail(const std::string& detail, const std::string& problem, const std::string& remedy) const {
  const std::string at = " (byte " + std::to_string(byte) + ")";
  throw InputError({.kind = ErrorKind::data,
                    .file = file,
                    .place = dataset + (dataset.empty() || detail.empty() ? "" : ", ") + detail + at,
                    .problem = problem,
                    .remedy = remedy});
}

ByteFile::ByteFile(const std::filesystem::path& path) : name_(path.string()) {
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error)) stream_.open(path, std::ios::binary);
  if (!stream_.is_open()) {
    throw InputError({.kind = ErrorKind::data,
                      .file = name_,
                      .place = {},
                      .problem = "cannot open the file",
                      .remedy = "check its name and that you may read it"});
  }
  size_ = std::filesystem::file_size(path);
}

void ByteFile::seek(std::uint64_t position) {
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(position));
  position_ = position;
}

bool ByteFile::next_line(std::string_view& line) {
  if (position_ >= size_ || !std::getline(stream_, line_)) return false;
  position_ += line_.size() + (stream_.eof() ? 0 : 1);
  if (!line_.empty() && line_.back() == '\r') line_.pop_back();
  line = line_;
  return true;
}

std::string ByteFile::read(std::uint64_t offset, std::uint64_t count) {
  seek(offset);
  std::string bytes(count, '\0');
  if (!stream_.read(bytes.data(), static_cast<std::streamsize>(count))) {
    Place{name_, {}, offset}.fail({}, "cannot read " + std::to_string(count) + " bytes",
                                  "the file changed or its disk fails");
  }
  position_ = offset + count;
  return bytes;
}

}  // namespace jointid::frf::uff
