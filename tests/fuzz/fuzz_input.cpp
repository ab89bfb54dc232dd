#include "fuzz_input.hpp"

#include <sanitizer/allocator_interface.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/error.hpp"

namespace jointid::fuzz {
namespace {

std::atomic<std::size_t> live = 0, peak = 0;

void on_malloc(const volatile void* memory, std::size_t) {
  if (memory == nullptr) return;
  const std::size_t now = live += __sanitizer_get_allocated_size(const_cast<const void*>(memory));
  if (now > peak) peak = now;
}

void on_free(const volatile void* memory) {
  if (memory != nullptr) live -= __sanitizer_get_allocated_size(const_cast<const void*>(memory));
}

constexpr const char* sanitizer_options = "allocator_may_return_null=1:max_allocation_size_mb=64";

const int counting = __sanitizer_install_malloc_and_free_hooks(on_malloc, on_free);

}  // namespace

/// HDF5 asks malloc for what a damaged size says before it tries to read as much, and takes no for an answer. The C++ operator new
/// has no such excuse: there, a request beyond the limit is a finding.
extern "C" const char* __asan_default_options() { return sanitizer_options; }

InputFile::InputFile(std::span<const std::uint8_t> bytes) : descriptor_(::memfd_create("input", MFD_CLOEXEC)) {
  if (counting == 0 || descriptor_ < 0 || ::write(descriptor_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    std::abort();
  }
  path_ = "/proc/self/fd/" + std::to_string(descriptor_);
}

InputFile::~InputFile() { ::close(descriptor_); }

void expect_answer(std::span<const std::uint8_t> bytes, const Allowance& allowance,
                   const std::function<void(const std::filesystem::path&)>& read) {
  const InputFile file(bytes);
  const std::size_t before = live;
  peak = before;
  try {
    read(file.path());
  } catch (const InputError&) {
  }
  const std::size_t taken = peak - before, allowed = allowance.base + allowance.per_byte * bytes.size();
  if (taken <= allowed) return;
  std::fprintf(stderr, "a file of %zu bytes took %zu bytes of memory, allowed are %zu\n", bytes.size(), taken, allowed);
  std::abort();
}

}  // namespace jointid::fuzz
