#include "frf/hdf5/record_journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cerrno>
#include <cstring>

#include "base/error.hpp"

namespace jointid::frf {
namespace {

constexpr char magic[17] = "jointid-journa2\n", older_magic[17] = "jointid-journal\n";
constexpr std::size_t most_parts = 6, header_bytes = 72, records_at_a_time = 4096;

struct Header {
  std::array<char, 16> name{};
  std::uint64_t columns = 0;
  std::array<std::uint64_t, most_parts> parts{};
};
static_assert(sizeof(Header) == header_bytes);

std::array<std::uint64_t, most_parts> checksums(const JournalKey& key) {
  assert(key.size() <= most_parts);
  std::array<std::uint64_t, most_parts> sums{};
  std::ranges::transform(key, sums.begin(), [](const JournalPart& part) { return checksum(std::as_bytes(std::span(part.text))); });
  return sums;
}

/// Never 0 for a slot of zeros, which is what a hole in the file reads as.
double record_checksum(std::size_t index, std::span<const double> record) {
  const std::uint64_t place = index;
  const std::uint64_t start = checksum(std::as_bytes(std::span(&place, 1)));
  return std::bit_cast<double>(checksum(std::as_bytes(record), start) | 1U);
}

}  // namespace

std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t start) {
  for (const std::byte byte : bytes) start = (start ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3ULL;
  return start;
}

std::string named_others(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " and ") + ("another " + name);
  return text;
}

RecordJournal::RecordJournal(std::filesystem::path path, const JournalKey& key, std::size_t columns, Start start)
    : path_(std::move(path)), columns_(columns) {
  const int exclusive = start == Start::fresh ? O_EXCL : 0;
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | exclusive, 0666);
  if (file_ < 0 && errno == EEXIST) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = path_.string(),
                      .place = {},
                      .problem = "an interrupted run left it, or one is under way",
                      .remedy = "continue with --resume, or remove the file to start anew"});
  }
  if (file_ < 0) fail(std::string("cannot be opened: ") + std::strerror(errno));
  try {
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) fail("another run is writing it");
    ::lseek(file_, 0, SEEK_END) == 0 ? start_file(key) : check_file(key);
  } catch (...) {
    ::close(file_);
    throw;
  }
}

RecordJournal::~RecordJournal() { ::close(file_); }

void RecordJournal::start_file(const JournalKey& key) {
  Header header{.name = {}, .columns = columns_, .parts = checksums(key)};
  std::copy_n(magic, header.name.size(), header.name.begin());
  if (::pwrite(file_, &header, sizeof header, 0) != static_cast<ssize_t>(sizeof header)) fail(std::strerror(errno));
}

void RecordJournal::check_file(const JournalKey& key) {
  Header header;
  const ssize_t got = ::pread(file_, &header, sizeof header, 0);
  if (std::equal(header.name.begin(), header.name.end(), older_magic)) refuse("it is of an older version of jointid");
  if (got != static_cast<ssize_t>(sizeof header) || !std::equal(header.name.begin(), header.name.end(), magic)) fail("is no journal");
  std::vector<std::string> others;
  const auto sums = checksums(key);
  for (std::size_t i = 0; i < key.size(); ++i) {
    if (sums[i] != header.parts[i]) others.push_back(key[i].name);
  }
  if (others.empty() && header.columns != columns_) others.emplace_back("set of unknowns");
  if (!others.empty()) refuse("it belongs to " + named_others(others));
}

void RecordJournal::refuse(const std::string& problem) const {
  throw InputError({.kind = ErrorKind::usage,
                    .file = path_.string(),
                    .place = {},
                    .problem = problem,
                    .remedy = "repeat the run as it was, or remove the file to start anew"});
}

void RecordJournal::put(std::size_t index, std::span<const double> record) {
  assert(record.size() == columns_);
  std::vector<double> slot(record.begin(), record.end());
  slot.push_back(record_checksum(index, record));
  const auto* from = reinterpret_cast<const char*>(slot.data());
  std::size_t left = slot.size() * sizeof(double);
  auto at = static_cast<off_t>(header_bytes + index * left);
  while (left > 0) {
    const ssize_t put = ::pwrite(file_, from, left, at);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) fail(std::string("cannot be written: ") + std::strerror(errno));
    from += put;
    at += put;
    left -= static_cast<std::size_t>(put);
  }
}

/// Fills `slots` from slot `first` on and returns how many whole slots the file had.
std::size_t RecordJournal::load(std::size_t first, std::vector<double>& slots) const {
  const std::size_t slot_bytes = (columns_ + 1) * sizeof(double), wanted = slots.size() * sizeof(double);
  auto* to = reinterpret_cast<char*>(slots.data());
  std::size_t got = 0;
  while (got < wanted) {
    const ssize_t more = ::pread(file_, to + got, wanted - got, static_cast<off_t>(header_bytes + first * slot_bytes + got));
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) fail(std::string("cannot be read: ") + std::strerror(errno));
    if (more == 0) break;
    got += static_cast<std::size_t>(more);
  }
  return got / slot_bytes;
}

bool RecordJournal::is_whole(std::size_t index, const double* slot) const {
  return std::bit_cast<std::uint64_t>(slot[columns_]) == std::bit_cast<std::uint64_t>(record_checksum(index, {slot, columns_}));
}

std::vector<IndexRange> RecordJournal::missing(std::size_t count) const {
  std::vector<IndexRange> missing;
  std::vector<double> slots(std::min(count, records_at_a_time) * (columns_ + 1));
  std::size_t loaded = 0;
  for (std::size_t index = 0; index < count; ++index) {
    const std::size_t at = index % records_at_a_time;
    if (at == 0) loaded = load(index, slots);
    if (at < loaded && is_whole(index, slots.data() + at * (columns_ + 1))) continue;
    if (missing.empty() || missing.back().end < index) missing.push_back({index, index});
    ++missing.back().end;
  }
  return missing;
}

std::vector<double> RecordJournal::read(std::size_t first, std::size_t count) const {
  std::vector<double> slots(count * (columns_ + 1)), numbers;
  if (load(first, slots) < count) fail("is shorter than it was");
  numbers.reserve(count * columns_);
  for (std::size_t i = 0; i < count; ++i) {
    const double* slot = slots.data() + i * (columns_ + 1);
    if (!is_whole(first + i, slot)) fail("record " + std::to_string(first + i) + " is damaged");
    numbers.insert(numbers.end(), slot, slot + columns_);
  }
  return numbers;
}

void RecordJournal::sync() const { ::fdatasync(file_); }

void RecordJournal::remove() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void RecordJournal::fail(const std::string& problem) const {
  throw InputError({.kind = ErrorKind::data,
                    .file = path_.string(),
                    .place = {},
                    .problem = problem,
                    .remedy = "check the folder, its permissions and the space left on the disk"});
}

}  // namespace jointid::frf
