#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "include_rules.hpp"

namespace jointid::structure {
namespace {

const std::filesystem::path tree = JOINTID_SOURCE_DIR;

/// The "now" of each row of the table of figures in docs/architecture.md.
std::map<std::string, std::string> figures_of_the_docs() {
  std::ifstream markdown(tree / "docs/architecture.md");
  static const std::regex row(R"(^\| ([^|]*) \| [^|]* \| ([^|]*) \| [^|]* \|$)");
  std::map<std::string, std::string> out;
  bool inside = false;
  for (std::string line; std::getline(markdown, line);) {
    if (line.starts_with("## ")) inside = line == "## Figures";
    std::smatch cells;
    if (inside && std::regex_match(line, cells, row)) out[cells[1]] = cells[2];
  }
  return out;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream source(path);
  return {std::istreambuf_iterator<char>(source), {}};
}

/// Folders of the product.
std::vector<std::string> folders() {
  std::ifstream markdown(tree / "docs/architecture.md");
  std::vector<std::string> out;
  for (const auto& row : read_table(markdown)) {
    if (row.first.find('/') == std::string::npos) out.push_back(row.first);
  }
  return out;
}

std::map<std::string, std::size_t> lines_by_folder() {
  std::map<std::string, std::size_t> out;
  for (const std::string& folder : folders()) {
    for (const auto& path : sources(tree / folder)) {
      const std::string text = text_of(path);
      out[folder] += static_cast<std::size_t>(std::ranges::count(text, '\n'));
    }
  }
  return out;
}

/// Distinct matches in the lines of the product that hold `word`, without constant plans; a declaration and its definition are one.
std::size_t matches(const std::string& word, const std::regex& pattern) {
  static const std::regex constant(R"(const (ident::)?Plan&)");
  std::set<std::string> found;
  for (const std::string& folder : folders()) {
    for (const auto& path : sources(tree / folder)) {
      std::ifstream source(path);
      for (std::string line; std::getline(source, line);) {
        if (line.find(word) == std::string::npos) continue;
        line = std::regex_replace(line, constant, "");
        for (std::sregex_iterator at(line.begin(), line.end(), pattern); at != std::sregex_iterator(); ++at) found.insert((*at)[1]);
      }
    }
  }
  return found.size();
}

std::size_t most_files(const std::vector<std::string>& below) {
  std::size_t most = 0;
  for (const std::string& folder : below) {
    std::map<std::filesystem::path, std::size_t> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(tree / folder)) {
      if (entry.is_regular_file() && !sources(entry.path().parent_path()).empty()) ++files[entry.path().parent_path()];
    }
    for (const auto& [directory, count] : files) most = std::max(most, count);
  }
  return most;
}

TEST(Figures, OfTheDocsAreThoseOfTheTree) {
  const auto lines = lines_by_folder();
  std::size_t all = 0;
  for (const auto& [folder, count] : lines) all += count;
  const auto largest = std::ranges::max_element(lines, {}, [](const auto& each) { return each.second; });
  const auto percent = static_cast<std::size_t>(std::lround(100.0 * static_cast<double>(largest->second) / static_cast<double>(all)));
  const std::map<std::string, std::string> of_the_tree = {
      {"largest folder's share of the lines", std::to_string(percent) + " % (`" + largest->first + "/`)"},
      {"most files in one directory of the product; of the tests",
       std::to_string(most_files(folders())) + "; " + std::to_string(most_files({"tests"}))},
      {"functions that may change a `Plan`", std::to_string(matches("Plan& ", std::regex(R"((\w+)\((?:[^();]*, )?(?:ident::)?Plan& \w)")))},
      {"I + HZ written", std::to_string(matches("Identity(", std::regex(R"((Identity\([^;]*\) \+ [^;]*(?:\* (?:z|impedance)\b|\b(?:z|impedance) \*)))")))},
  };
  const auto told = figures_of_the_docs();
  for (const auto& [name, value] : of_the_tree) {
    ASSERT_TRUE(told.contains(name)) << name << " is " << value;
    EXPECT_EQ(told.at(name), value) << name;
  }
}

}  // namespace
}  // namespace jointid::structure
