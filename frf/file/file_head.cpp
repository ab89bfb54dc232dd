#include "frf/file/file_head.hpp"

#include <fstream>

#include "frf/uff/uff_file.hpp"

namespace jointid::frf {

std::string head_of(const std::filesystem::path& path) {
  std::string head(4096, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

bool is_universal_file(const std::filesystem::path& path) { return looks_like_uff(head_of(path)); }

}  // namespace jointid::frf
