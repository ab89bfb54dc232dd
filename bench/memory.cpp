#include "bench/memory.hpp"

#include <malloc.h>

#include <cmath>
#include <fstream>
#include <string>

namespace jointid::bench {
namespace {

/// "VmHWM" or "VmRSS" of this process, MB.
double status_megabytes(const std::string& key) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(key + ":")) return std::stod(line.substr(key.size() + 1)) / 1024.0;
  }
  return std::nan("");
}

}  // namespace

double growth_megabytes(const std::function<void()>& work) {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
  const double before = status_megabytes("VmRSS");
  work();
  return status_megabytes("VmHWM") - before;
}

}  // namespace jointid::bench
