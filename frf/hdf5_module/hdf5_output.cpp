#include "frf/hdf5_module/hdf5_output.hpp"

#include <cstring>

#include "frf/hdf5_module/hdf5_disk.hpp"

namespace jointid::frf::hdf5 {

Output::Output(const TemporaryFile& file) : temporary_(file), file_(create_file(temporary_.path(), disk_error_)) {
  require(file_.is_open());
}

void Output::require(bool ok) const {
  if (disk_error_ != 0) fail(std::strerror(disk_error_));
  if (!ok) fail(last_failure());
}

void Output::finish(bool closed) {
  require(closed && file_.close());
}

}  // namespace jointid::frf::hdf5
