#pragma once

#include <cstdio>
#include <string>

namespace jointid::bench {

/// What a command prints, empty when it fails.
inline std::string output_of(const std::string& command) {
  std::string text;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text.push_back(static_cast<char>(c));
  return pclose(pipe) == 0 ? text : std::string();
}

}  // namespace jointid::bench
