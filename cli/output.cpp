#include "cli/output.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "frf/error.hpp"

namespace jointid::cli {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw InputError({ErrorKind::data, path.string(), "", "cannot be written: " + why,
                    "check that the folder exists, is writable and has room"});
}

/// A file that is removed again unless it is kept.
class Temporary {
 public:
  explicit Temporary(std::filesystem::path path) : path_(std::move(path)) {}
  ~Temporary() {
    std::error_code ignored;  // nothing is left to do when even that fails
    if (!path_.empty()) std::filesystem::remove(path_, ignored);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void rename_to(const std::filesystem::path& to) {
    std::filesystem::rename(path_, to);
    path_.clear();
  }

 private:
  std::filesystem::path path_;
};

}  // namespace

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::path name = path;
  name += ".part" + std::to_string(getpid());
  Temporary temporary(name);
  std::ofstream file(temporary.path(), std::ios::binary);
  if (!file) fail(path, std::strerror(errno));
  file << text;
  file.close();
  if (!file) fail(path, std::strerror(errno));
  try {
    temporary.rename_to(path);
  } catch (const std::filesystem::filesystem_error& error) {
    fail(path, error.code().message());
  }
}

void write_target(const std::string& target, const std::string& text, std::ostream& out) {
  if (target == "-") {
    out << text;
  } else {
    write_file(target, text);
  }
}

}  // namespace jointid::cli
