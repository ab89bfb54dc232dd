#include "include_rules.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>
#include <string_view>

namespace jointid::structure {
namespace {

constexpr std::array heavy = {
    std::string_view("Eigen/Dense"),       std::string_view("Eigen/Sparse"),  std::string_view("Eigen/Eigenvalues"),
    std::string_view("Eigen/QR"),          std::string_view("Eigen/SVD"),     std::string_view("hdf5.h"),
    std::string_view("hdf5_hl.h"),         std::string_view("matio.h"),       std::string_view("toml++/toml.h"),
    std::string_view("nlohmann/json.hpp"), std::string_view("CLI/CLI.hpp"),   std::string_view("cholmod.h"),
    std::string_view("SuiteSparseQR.hpp"), std::string_view("ceres/ceres.h"),
};

std::set<std::string> allowed_folders(const std::string& cell, const std::set<std::string>& above) {
  if (cell.find("all above") != std::string::npos) return above;
  std::set<std::string> folders;
  const std::regex word("[a-z_]+");
  for (std::sregex_iterator it(cell.begin(), cell.end(), word), end; it != end; ++it) folders.insert(it->str());
  return folders;
}

}  // namespace

IncludeTable read_table(std::istream& markdown) {
  const std::regex row(R"(^\| `([a-z_]+)/` \|.*\|([^|]*)\|\s*$)");
  IncludeTable table;
  std::set<std::string> above;
  std::string line;
  while (std::getline(markdown, line)) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    table[match[1]] = allowed_folders(match[2], above);
    above.insert(match[1]);
  }
  return table;
}

std::vector<std::string> includes(std::istream& source) {
  const std::regex directive(R"(^\s*#\s*include\s*["<]([^">]+)[">].*)");
  std::vector<std::string> found;
  std::string line;
  while (std::getline(source, line)) {
    std::smatch match;
    if (std::regex_match(line, match, directive)) found.push_back(match[1]);
  }
  return found;
}

std::vector<std::string> violations(const IncludeTable& table, const std::string& folder, std::istream& source) {
  std::vector<std::string> found;
  for (const std::string& include : includes(source)) {
    const std::string target = include.substr(0, include.find('/'));
    const bool ours = include.find('/') != std::string::npos && table.contains(target);
    if (ours && target != folder && !table.at(folder).contains(target)) {
      found.push_back(folder + " may not include " + include);
    }
    if (include.find('/') == std::string::npos && include.ends_with(".hpp") &&
        std::ranges::find(heavy, include) == heavy.end()) {
      found.push_back(include + " is included without its folder");
    }
  }
  return found;
}

std::vector<std::string> heavy_includes(std::istream& header) {
  std::vector<std::string> found;
  for (const std::string& include : includes(header)) {
    if (std::ranges::find(heavy, include) != heavy.end()) found.push_back(include);
  }
  return found;
}

std::vector<std::filesystem::path> sources(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".hpp" || extension == ".cpp") found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace jointid::structure
