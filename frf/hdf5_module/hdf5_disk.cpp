#include "frf/hdf5_module/hdf5_disk.hpp"

#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>

namespace jointid::frf::hdf5 {
namespace {

constexpr haddr_t largest_address = static_cast<haddr_t>(std::numeric_limits<off_t>::max());

/// What HDF5 holds for an open file; it knows the first member only.
struct Disk {
  H5FD_t base{};
  int descriptor = -1;
  haddr_t allocated = 0;  ///< end of what HDF5 means to use
  haddr_t written = 0;    ///< end of the file
  int* error = nullptr;
};

Disk& disk(H5FD_t* file) { return *reinterpret_cast<Disk*>(file); }
const Disk& disk(const H5FD_t* file) { return *reinterpret_cast<const Disk*>(file); }

H5FD_t* open_disk(const char* name, unsigned, hid_t access, haddr_t) {
  int* const error = *static_cast<int* const*>(H5Pget_driver_info(access));
  const int descriptor = ::open(name, O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    *error = errno;
    return nullptr;
  }
  auto* opened = new Disk;
  opened->descriptor = descriptor;
  opened->error = error;
  return &opened->base;
}

herr_t close_disk(H5FD_t* file) {
  if (::close(disk(file).descriptor) != 0 && *disk(file).error == 0) *disk(file).error = errno;
  delete &disk(file);
  return 0;
}

herr_t query(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t get_allocated(const H5FD_t* file, H5FD_mem_t) { return disk(file).allocated; }
haddr_t get_written(const H5FD_t* file, H5FD_mem_t) { return disk(file).written; }
herr_t set_allocated(H5FD_t* file, H5FD_mem_t, haddr_t address) {
  disk(file).allocated = address;
  return 0;
}

/// Beyond the end of the file lie zeros.
herr_t read_disk(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t size, void* buffer) {
  auto* to = static_cast<char*>(buffer);
  while (size > 0) {
    const ssize_t got = ::pread(disk(file).descriptor, to, size, static_cast<off_t>(address));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return -1;
    if (got == 0) {
      std::memset(to, 0, size);
      return 0;
    }
    to += got;
    address += static_cast<haddr_t>(got);
    size -= static_cast<size_t>(got);
  }
  return 0;
}

herr_t write_disk(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t size, const void* buffer) {
  Disk& to = disk(file);
  const auto* from = static_cast<const char*>(buffer);
  to.written = std::max<haddr_t>(to.written, address + size);
  while (size > 0 && *to.error == 0) {
    const ssize_t put = ::pwrite(to.descriptor, from, size, static_cast<off_t>(address));
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) {
      *to.error = errno;
      break;
    }
    from += put;
    address += static_cast<haddr_t>(put);
    size -= static_cast<size_t>(put);
  }
  return 0;
}

herr_t truncate_disk(H5FD_t* file, hid_t, hbool_t) {
  Disk& of = disk(file);
  if (of.allocated == of.written) return 0;
  if (*of.error == 0 && ::ftruncate(of.descriptor, static_cast<off_t>(of.allocated)) != 0) *of.error = errno;
  of.written = of.allocated;
  return 0;
}

H5FD_class_t driver_class() {
  H5FD_class_t driver{};
  driver.name = "jointid_disk";
  driver.maxaddr = largest_address;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(int*);
  driver.open = open_disk;
  driver.close = close_disk;
  driver.query = query;
  driver.get_eoa = get_allocated;
  driver.set_eoa = set_allocated;
  driver.get_eof = get_written;
  driver.read = read_disk;
  driver.write = write_disk;
  driver.truncate = truncate_disk;
  constexpr H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(map), std::end(map), driver.fl_map);
  return driver;
}

}  // namespace

Handle create_file(const std::filesystem::path& path, int& error) {
  static const H5FD_class_t driver = driver_class();
  static const hid_t driver_id = H5FDregister(&driver);
  const Handle access(H5Pcreate(H5P_FILE_ACCESS));
  int* const report_to = &error;
  H5Pset_driver(access.get(), driver_id, &report_to);
  return Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()));
}

}  // namespace jointid::frf::hdf5
