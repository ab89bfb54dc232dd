#include "records/file/file_head.hpp"

#include <fstream>

namespace jointid::records {

std::string head_of(const std::filesystem::path& path) {
  std::string head(512, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

}  // namespace jointid::records
