#pragma once

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

/// The files of NIST's Statistical Reference Datasets (StRD): numbers as they are written.
namespace jointid::stability {

inline std::filesystem::path nist_folder(const std::string& kind) { return std::filesystem::path(JOINTID_EXTERNAL_DATA) / "nist" / kind; }

struct NistFile {
  std::string name;
  std::vector<std::vector<std::string>> parameters;  ///< the numbers behind B0, b1 =, …
  std::vector<std::vector<std::string>> data;        ///< response first

  explicit NistFile(const std::filesystem::path& path) : name(path.stem().string()) {
    std::ifstream in(path);
    std::string line;
    const std::regex parameter("^ *[Bb][0-9]+ *=? +(.*)$");
    bool in_data = false;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      std::smatch found;
      if (number >= 60 && std::regex_search(line, std::regex("^Data:"))) {
        in_data = true;
      } else if (in_data) {
        if (auto numbers = words(line); numbers.size() > 1) data.push_back(std::move(numbers));
      } else if (std::regex_match(line, found, parameter)) {
        parameters.push_back(words(found[1]));
      }
    }
  }

 private:
  static std::vector<std::string> words(const std::string& line) {
    std::istringstream in(line);
    std::vector<std::string> out;
    for (std::string word; in >> word;) out.push_back(word);
    return out;
  }
};

}  // namespace jointid::stability
