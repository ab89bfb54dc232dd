#include "cli/options/pdf.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include "base/error.hpp"
#include "base/temporary_file.hpp"
#include "cli/options/own_file.hpp"

namespace jointid::cli {
namespace {

using Path = std::filesystem::path;

constexpr std::array browsers = {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"};
constexpr const char* remedy = "write it as .html, which every browser opens and prints, or install the package chromium";

/// The first that is on the PATH; empty where none is.
Path browser() {
  const char* const folders = std::getenv("PATH");
  std::istringstream list(folders == nullptr ? "" : folders);
  for (std::string folder; std::getline(list, folder, ':');) {
    for (const char* name : browsers) {
      if (::access((Path(folder) / name).c_str(), X_OK) == 0) return Path(folder) / name;
    }
  }
  return {};
}

/// A folder of its own that vanishes with the object.
class WorkFolder {
 public:
  WorkFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "jointid-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~WorkFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  const Path& path() const { return path_; }

 private:
  Path path_;
};

/// Runs a program with no input and no output to its end; whether it ended well.
bool run(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  }
  pid_t child = 0;
  const int failed = ::posix_spawn(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return false;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::vector<std::string> print_command(const Path& program, const Path& folder) {
  std::vector<std::string> words = {program.string(), "--headless", "--disable-gpu", "--no-first-run", "--disable-background-networking",
                                    "--virtual-time-budget=20000", "--timeout=60000", "--no-pdf-header-footer", "--print-to-pdf-no-header",
                                    "--user-data-dir=" + (folder / "profile").string(), "--print-to-pdf=" + (folder / "page.pdf").string()};
  if (::geteuid() == 0) words.emplace_back("--no-sandbox");  // it has none for root
  words.push_back("file://" + (folder / "page.html").string());
  return words;
}

}  // namespace

bool is_pdf(const std::string& target) {
  const std::string end = Path(target).extension().string();
  return end == ".pdf" || end == ".PDF";
}

void require_browser(const std::string& option) {
  if (!browser().empty()) return;
  throw InputError({ErrorKind::usage, "", option, "a PDF is printed by Chromium, which is not on the PATH", remedy});
}

std::string printed(const std::string& html, const std::string& target) {
  const WorkFolder folder;
  const auto fail = [&](const char* problem) { throw InputError({ErrorKind::data, target, "", problem, remedy}); };
  if (folder.path().empty()) fail("no temporary folder can be made to print the page in");
  write_text(folder.path() / "page.html", html);
  const bool ended = run(print_command(browser(), folder.path()));
  std::ifstream in(folder.path() / "page.pdf", std::ios::binary);
  std::string pdf((std::istreambuf_iterator<char>(in)), {});
  if (!ended || !pdf.starts_with("%PDF")) fail("Chromium did not print the page");
  return pdf + (pdf.ends_with('\n') ? "" : "\n") + pdf_mark;
}

}  // namespace jointid::cli
