#include "frf/uff/uff_bytes.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

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
  if (std::filesystem::is_regular_file(path, error)) {
    size_ = std::filesystem::file_size(path, error);
    stream_.open(path, std::ios::binary);
    exact_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  }
  if (!stream_.is_open() || exact_ < 0) {
    if (exact_ >= 0) ::close(exact_);
    throw InputError({.kind = ErrorKind::data,
                      .file = name_,
                      .place = {},
                      .problem = "cannot open the file",
                      .remedy = "check its name and that you may read it"});
  }
}

ByteFile::~ByteFile() {
  if (exact_ >= 0) ::close(exact_);
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
  std::string bytes(count, '\0');
  for (std::uint64_t done = 0; done < count;) {
    const ssize_t got = ::pread(exact_, bytes.data() + done, count - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) {
      Place{name_, {}, offset}.fail({}, "cannot read " + std::to_string(count) + " bytes", "the file changed or its disk fails");
    }
    done += static_cast<std::uint64_t>(got);
  }
  return bytes;
}

}  // namespace jointid::frf::uff
