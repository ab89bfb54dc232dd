#include "tasks/json_file.hpp"

#include <fstream>

namespace jointid::tasks {

bool is_json_file(const std::filesystem::path& file) {
  char first = ' ';
  std::ifstream in(file);
  return in >> first && first == '{';
}

}  // namespace jointid::tasks
