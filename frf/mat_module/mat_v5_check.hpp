#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "frf/mat_module/mat_v5_matrix.hpp"

namespace jointid::frf::mat {

/// The variables of a MATLAB v5 to v7 file, walked before matio sees them: matio trusts what a file declares, asks for gigabytes
/// that a damaged size names, and takes a packed variable whose checksum is wrong. Throws InputError naming the variable.
class V5Check {
 public:
  /// Walks the file but for the numbers and characters of its variables.
  explicit V5Check(const std::filesystem::path& path);

  /// In the order of the file.
  std::vector<std::string> names() const;

  /// Walks a variable to its end; of packed ones the checksum must agree.
  void require_whole(const std::string& name);

 private:
  struct Element {
    std::string name;
    std::uint64_t begin = 0, bytes = 0;  ///< after its tag
    bool packed = false;
  };

  void read_header();
  void list();
  std::string walk(const Element& element, Extent extent);
  [[noreturn]] void fail(const std::string& place, const std::string& problem) const;

  std::string path_;
  std::uint64_t size_;
  std::ifstream file_;
  bool big_endian_ = false;
  Nested nested_;
  std::vector<Element> elements_;
};

}  // namespace jointid::frf::mat
