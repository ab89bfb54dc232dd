#include "frf/hdf5/file_origin.hpp"

#include <mutex>
#include <utility>

namespace jointid::frf {
namespace {

std::mutex origin_mutex;
std::function<std::string()> origin;

}  // namespace

void set_file_origin(std::function<std::string()> text) {
  const std::lock_guard lock(origin_mutex);
  origin = std::move(text);
}

std::string file_origin() {
  const std::lock_guard lock(origin_mutex);
  return origin ? origin() : std::string();
}

}  // namespace jointid::frf
