#include "frf/hdf5_module/hdf5_checked_disk.hpp"

#include <fcntl.h>
#include <hdf5.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>

#include "frf/hdf5_module/hdf5_global_heap.hpp"

namespace jointid::frf::hdf5 {
namespace {

/// What HDF5 holds for an open file; it knows the first member only.
struct CheckedDisk {
  H5FD_t base{};
  int descriptor = -1;
  haddr_t used = 0;  ///< end of what HDF5 means to use
  haddr_t end = 0;   ///< of the file
  struct stat status {};
};

CheckedDisk& checked(H5FD_t* file) { return *reinterpret_cast<CheckedDisk*>(file); }
const CheckedDisk& checked(const H5FD_t* file) { return *reinterpret_cast<const CheckedDisk*>(file); }

H5FD_t* open_for_reading(const char* name, unsigned, hid_t access, haddr_t) {
  const MayOpen& may_open = **static_cast<const MayOpen* const*>(H5Pget_driver_info(access));
  if (may_open && !may_open(name)) return nullptr;
  CheckedDisk opened;
  opened.descriptor = ::open(name, O_RDONLY | O_CLOEXEC);
  if (opened.descriptor < 0) return nullptr;
  if (::fstat(opened.descriptor, &opened.status) != 0) {
    ::close(opened.descriptor);
    return nullptr;
  }
  opened.end = static_cast<haddr_t>(opened.status.st_size);
  return &(new CheckedDisk(opened))->base;
}

herr_t close_checked(H5FD_t* file) {
  ::close(checked(file).descriptor);
  delete &checked(file);
  return 0;
}

/// By device and inode, as HDF5 tells that two names are of one open file.
int compare(const H5FD_t* one, const H5FD_t* other) {
  const struct stat &a = checked(one).status, &b = checked(other).status;
  if (a.st_dev != b.st_dev) return a.st_dev < b.st_dev ? -1 : 1;
  return a.st_ino == b.st_ino ? 0 : (a.st_ino < b.st_ino ? -1 : 1);
}

herr_t query_checked(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_POSIX_COMPAT_HANDLE | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t get_used(const H5FD_t* file, H5FD_mem_t) { return checked(file).used; }
haddr_t get_end(const H5FD_t* file, H5FD_mem_t) { return checked(file).end; }

herr_t set_used(H5FD_t* file, H5FD_mem_t, haddr_t address) {
  checked(file).used = address;
  return 0;
}

herr_t get_handle(H5FD_t* file, hid_t, void** handle) {
  *handle = &checked(file).descriptor;
  return 0;
}

/// Fails with words that last_failure() finds.
herr_t refuse(const char* why) {
  H5Epush2(H5E_DEFAULT, __FILE__, __func__, __LINE__, H5E_ERR_CLS, H5E_IO, H5E_READERROR, "%s", why);
  return -1;
}

herr_t read_checked(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t size, void* buffer) {
  const CheckedDisk& from = checked(file);
  if (address > from.end || size > from.end - address) return refuse("it points beyond the end of the file");
  auto* to = static_cast<char*>(buffer);
  for (size_t left = size; left > 0;) {
    const ssize_t got = ::pread(from.descriptor, to, left, static_cast<off_t>(address + (size - left)));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return refuse(got < 0 ? std::strerror(errno) : "the file ends before it");
    to += got;
    left -= static_cast<size_t>(got);
  }
  if (!begins_global_heap(buffer, size) || is_sound_global_heap(from.descriptor, address)) return 0;
  return refuse("the heap of its texts is damaged");
}

/// As HDF5's own driver does: who writes the file keeps readers out.
herr_t lock(H5FD_t* file, hbool_t) {
  return ::flock(checked(file).descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK ? -1 : 0;
}

herr_t unlock(H5FD_t* file) {
  ::flock(checked(file).descriptor, LOCK_UN);
  return 0;
}

herr_t write_nothing(H5FD_t*, H5FD_mem_t, hid_t, haddr_t, size_t, const void*) { return -1; }

H5FD_class_t checked_class() {
  H5FD_class_t driver{};
  driver.name = "jointid_checked";
  driver.maxaddr = static_cast<haddr_t>(std::numeric_limits<off_t>::max());
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(const MayOpen*);
  driver.open = open_for_reading;
  driver.close = close_checked;
  driver.cmp = compare;
  driver.query = query_checked;
  driver.get_eoa = get_used;
  driver.set_eoa = set_used;
  driver.get_eof = get_end;
  driver.get_handle = get_handle;
  driver.read = read_checked;
  driver.write = write_nothing;
  driver.lock = lock;
  driver.unlock = unlock;
  constexpr H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(map), std::end(map), driver.fl_map);
  return driver;
}

}  // namespace

Handle open_checked(const std::filesystem::path& path, const MayOpen& may_open) {
  static const H5FD_class_t driver = checked_class();
  static const hid_t driver_id = H5FDregister(&driver);
  const Handle access(H5Pcreate(H5P_FILE_ACCESS));
  const MayOpen* const asked = &may_open;
  H5Pset_driver(access.get(), driver_id, &asked);
  return Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()));
}

}  // namespace jointid::frf::hdf5
