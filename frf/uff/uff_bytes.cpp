#include "frf/uff/uff_bytes.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "base/error.hpp"
#include "frf/text/plain_text.hpp"

namespace jointid::frf::uff {

void Place::fail(const std::string& detail, const std::string& problem, const std::string& remedy) const {
  const std::string at = " (byte " + std::to_string(byte) + ")";
  throw InputError({.kind = ErrorKind::data,
                    .file = file,
                    .place = dataset + (dataset.empty() || detail.empty() ? "" : ", ") + detail + at,
                    .problem = problem,
                    .remedy = remedy});
}

namespace {

constexpr std::size_t first_block = 4096, largest_block = std::size_t{1} << 20;

}  // namespace

ByteFile::ByteFile(const std::filesystem::path& path) : name_(path.string()), block_(first_block) {
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error)) {
    size_ = std::filesystem::file_size(path, error);
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  }
  if (descriptor_ < 0) {
    throw InputError({.kind = ErrorKind::data,
                      .file = name_,
                      .place = {},
                      .problem = "cannot open the file",
                      .remedy = "check its name and that you may read it"});
  }
  take_plain_text();
}

ByteFile::~ByteFile() { ::close(descriptor_); }

void ByteFile::take_plain_text() {
  if (!needs_plain_text(read(0, std::min<std::uint64_t>(first_block, size_)))) return;
  std::string text = read_plain_text(name_);
  if (text.find("58b") != std::string::npos || text.find("58 b") != std::string::npos) {
    Place{name_, {}, 0}.fail({}, "has binary records (58b), and its lines end with CR alone or are UTF-16",
                             "copy it byte for byte, or export it as text (58)");
  }
  plain_ = std::move(text);
  size_ = plain_.size();
}

void ByteFile::seek(std::uint64_t position) {
  const std::uint64_t begin = position_ - used_;
  if (position >= begin && position - begin <= filled_) {
    used_ = static_cast<std::size_t>(position - begin);
  } else {
    used_ = filled_ = 0;
    block_ = first_block;
  }
  position_ = position;
}

/// Forgets what was used and reads the next block; false where the file ends.
bool ByteFile::read_ahead() {
  std::copy(ahead_.begin() + static_cast<std::ptrdiff_t>(used_), ahead_.begin() + static_cast<std::ptrdiff_t>(filled_), ahead_.begin());
  filled_ -= std::exchange(used_, 0);
  const std::uint64_t next = position_ + filled_;
  if (next >= size_) return false;
  const std::size_t count = std::min<std::uint64_t>(block_, size_ - next);
  if (ahead_.size() < filled_ + count) ahead_.resize(filled_ + count);
  fill(next, std::span(ahead_).subspan(filled_, count));
  filled_ += count;
  block_ = std::min(2 * block_, largest_block);
  return true;
}

bool ByteFile::next_line(std::string_view& line) {
  if (position_ >= size_) return false;
  const auto ahead = [this] { return std::string_view(ahead_.data(), filled_); };
  std::size_t end = ahead().find('\n', used_);
  while (end == std::string_view::npos) {
    const std::size_t searched = filled_ - used_;
    if (!read_ahead()) break;
    end = ahead().find('\n', searched);
  }
  const std::size_t length = std::min(end, filled_) - used_;
  line = ahead().substr(used_, length);
  const std::size_t passed = length + (end == std::string_view::npos ? 0 : 1);
  used_ += passed;
  position_ += passed;
  if (line.ends_with('\r')) line.remove_suffix(1);
  return true;
}

std::string ByteFile::read(std::uint64_t offset, std::uint64_t count) {
  std::string bytes(count, '\0');
  fill(offset, bytes);
  return bytes;
}

void ByteFile::fill(std::uint64_t offset, std::span<char> bytes) {
  if (!plain_.empty()) {
    plain_.copy(bytes.data(), bytes.size(), offset);
    return;
  }
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t got = ::pread(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) {
      Place{name_, {}, offset}.fail({}, "cannot read " + std::to_string(bytes.size()) + " bytes", "the file changed or its disk fails");
    }
    done += static_cast<std::size_t>(got);
  }
}

}  // namespace jointid::frf::uff
