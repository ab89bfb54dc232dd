#include "cli/options/pdf.hpp"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

#include "base/error.hpp"
#include "base/temporary_file.hpp"
#include "cli/options/child_process.hpp"
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
  const bool ended = ended_well(print_command(browser(), folder.path()));
  std::ifstream in(folder.path() / "page.pdf", std::ios::binary);
  std::string pdf((std::istreambuf_iterator<char>(in)), {});
  if (!ended || !pdf.starts_with("%PDF")) fail("Chromium did not print the page");
  return pdf + (pdf.ends_with('\n') ? "" : "\n") + pdf_mark;
}

}  // namespace jointid::cli
