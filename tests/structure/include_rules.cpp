#include "include_rules.hpp"

#include <algorithm>
#include <array>
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
    std::string_view("IpIpoptApplication.hpp"), std::string_view("IpSolveStatistics.hpp"), std::string_view("IpTNLP.hpp"),
    std::string_view("qcustomplot.h"),
};

/// Of Eigen's decompositions: minutes of a build where every caller instantiates them.
constexpr std::array decompositions = {
    std::string_view("Eigen/Dense"), std::string_view("Eigen/Cholesky"), std::string_view("Eigen/Eigenvalues"),
    std::string_view("Eigen/LU"),    std::string_view("Eigen/QR"),       std::string_view("Eigen/SVD"),
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(trimmed(part));
  return parts;
}

/// The folder of a first cell "`frf/`", or empty for any other.
std::string folder_of(const std::string& cell) {
  if (!cell.starts_with('`') || !cell.ends_with("/`")) return "";
  return cell.substr(1, cell.size() - 3);
}

std::set<std::string> allowed_folders(const std::string& cell, const std::set<std::string>& above) {
  if (cell == "all above") return above;
  if (cell == "–") return {};
  const auto names = split(cell, ',');
  return {names.begin(), names.end()};
}

}  // namespace

IncludeTable read_table(std::istream& markdown) {
  IncludeTable table;
  std::map<std::string, std::set<std::string>> above;  // rows so far, of all folders and inside each
  for (std::string line; std::getline(markdown, line);) {
    const auto cells = split(trimmed(line), '|');  // the first is what stands before the first bar
    if (cells.size() < 3 || folder_of(cells[1]).empty()) continue;
    const std::string folder = folder_of(cells[1]);
    const std::size_t slash = folder.rfind('/');
    std::set<std::string>& before = above[slash == std::string::npos ? "" : folder.substr(0, slash)];
    table[folder] = allowed_folders(cells.back(), before);
    before.insert(slash == std::string::npos ? folder : folder.substr(slash + 1));
  }
  return table;
}

std::vector<std::string> includes(std::istream& source) {
  std::vector<std::string> found;
  for (std::string line; std::getline(source, line);) {
    std::string rest = trimmed(line);
    if (!rest.starts_with('#')) continue;
    rest = trimmed(rest.substr(1));
    if (!rest.starts_with("include")) continue;
    const std::size_t open = rest.find_first_of("<\"");
    const std::size_t close = rest.find_first_of(">\"", open + 1);
    if (open != std::string::npos && close != std::string::npos) found.push_back(rest.substr(open + 1, close - open - 1));
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

std::optional<RoomStep> room_step(const std::string& file, const std::string& include) {
  const std::vector<std::string> from = split(file, '/'), to = split(include, '/');
  std::size_t shared = 0;
  while (shared + 1 < from.size() && shared + 1 < to.size() && from[shared] == to[shared]) ++shared;
  if (shared == 0 || (shared + 1 == from.size() && shared + 1 == to.size())) return std::nullopt;
  std::string folder;
  for (std::size_t i = 0; i < shared; ++i) folder += from[i] + "/";
  const auto room = [&](const std::vector<std::string>& parts) { return folder + (shared + 1 < parts.size() ? parts[shared] : "."); };
  return RoomStep{room(from), room(to)};
}

std::vector<std::string> room_violations(const IncludeTable& table, const std::string& file, std::istream& source) {
  std::vector<std::string> found;
  for (const std::string& include : includes(source)) {
    const auto step = room_step(file, include);
    if (!step || !table.contains(step->to)) continue;
    if (!table.contains(step->from) || !table.at(step->from).contains(step->to.substr(step->to.rfind('/') + 1))) {
      found.push_back(step->from + " may not include " + include);
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

std::vector<std::string> decomposition_includes(std::istream& source) {
  std::vector<std::string> found;
  for (const std::string& include : includes(source)) {
    if (std::ranges::find(decompositions, include) != decompositions.end()) found.push_back(include);
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
