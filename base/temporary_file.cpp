#include "base/temporary_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "base/error.hpp"

namespace jointid {
namespace {

/// A name that no other writer, here or in another process, uses at the same time.
std::filesystem::path temporary_name(const std::filesystem::path& target) {
  static std::atomic<unsigned> count = 0;
  return target.parent_path() / ("." + target.filename().string() + "." + std::to_string(::getpid()) + "." +
                                 std::to_string(count++));
}

/// Waits until the disk holds the file, so that a name never stands for less, and a disk that takes no more says so. 0 or an errno.
int flush(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  const int error = ::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS ? 0 : errno;  // some file systems cannot
  ::close(descriptor);
  return error;
}

/// Names of the files that are being written, for remove_unfinished(); with more than these at once, some are not noted.
using Name = std::atomic<const char*>;
static_assert(Name::is_always_lock_free);  // what a signal handler may touch
std::array<Name, 64> unfinished{};

void note(const char* name) {
  for (Name& slot : unfinished) {
    const char* none = nullptr;
    if (slot.compare_exchange_strong(none, name)) return;
  }
}

void forget(const char* name) {
  for (Name& slot : unfinished) {
    const char* noted = name;
    if (slot.compare_exchange_strong(noted, nullptr)) return;
  }
}

/// The file that a link stands for.
std::filesystem::path without_links(const std::filesystem::path& target) {
  std::error_code error;
  if (!std::filesystem::is_symlink(target, error)) return target;
  std::filesystem::path file = std::filesystem::canonical(target, error);
  return error ? target : file;
}

}  // namespace

void require_regular_file(const std::filesystem::path& path, ErrorKind kind) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (!exists(status) || is_regular_file(status) || is_directory(status)) return;
  throw InputError({kind, path.string(), {}, "is not a regular file", "copy its data into one"});
}

TemporaryFile::TemporaryFile(std::filesystem::path target) : target_(without_links(target)) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(target_, ignored);
  if (exists(status) && !is_regular_file(status)) fail("there is something else than a file");
  std::filesystem::path name = temporary_name(target_);
  const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(std::strerror(errno));
  ::close(descriptor);
  path_ = std::move(name);
  note(path_.c_str());
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  if (path_.empty()) return;
  std::filesystem::remove(path_, ignored);
  forget(path_.c_str());
}

void TemporaryFile::commit() {
  if (const int failed = flush(path_)) fail(std::strerror(failed));
  std::error_code error;
  std::filesystem::rename(path_, target_, error);
  if (error) fail(error.message());
  forget(path_.c_str());
  path_.clear();
}

void TemporaryFile::fail(const std::string& why) const {
  throw InputError({.kind = ErrorKind::data,
                    .file = target_.string(),
                    .place = {},
                    .problem = "cannot be written: " + why,
                    .remedy = "check the folder, its permissions and the space left on the disk"});
}

void remove_unfinished() noexcept {
  for (const Name& slot : unfinished) {
    if (const char* name = slot.load()) ::unlink(name);
  }
}

void write_text(const std::filesystem::path& target, std::string_view text) {
  TemporaryFile temporary(target);
  std::ofstream out(temporary.path(), std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) temporary.fail(std::strerror(errno));
  temporary.commit();
}

std::size_t NumberSpool::put(std::span<const double> numbers) {
  if (!stream_) stream_.reset(std::tmpfile());
  const std::size_t begin = count_;
  if (!stream_ || std::fseek(stream_.get(), 0, SEEK_END) != 0 ||
      std::fwrite(numbers.data(), sizeof(double), numbers.size(), stream_.get()) != numbers.size())
    throw InputError({ErrorKind::data, file_, "", "needs a temporary file as large as its numbers, which cannot be written",
                      "export it as binary UFF (58b)"});
  count_ += numbers.size();
  return begin;
}

void NumberSpool::get(std::size_t first, std::span<double> numbers) {
  if (std::fseek(stream_.get(), static_cast<long>(first * sizeof(double)), SEEK_SET) != 0 ||
      std::fread(numbers.data(), sizeof(double), numbers.size(), stream_.get()) != numbers.size())
    throw InputError({ErrorKind::data, file_, "", "its temporary file cannot be read", "try again: its disk may fail"});
}

}  // namespace jointid
