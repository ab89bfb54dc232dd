#include "counted_memory.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> bytes_in_use{0}, peak_bytes{0};
constexpr std::size_t head = alignof(std::max_align_t);  // each block is preceded by its size

void* counted_or_null(std::size_t size) noexcept {
  auto* block = static_cast<char*>(std::malloc(size + head));
  if (block == nullptr) return nullptr;
  *reinterpret_cast<std::size_t*>(block) = size;
  const std::size_t now = bytes_in_use += size;
  std::size_t peak = peak_bytes;
  while (now > peak && !peak_bytes.compare_exchange_weak(peak, now)) {
  }
  return block + head;
}

void* counted(std::size_t size) {
  void* block = counted_or_null(size);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void release(void* pointer) noexcept {
  if (pointer == nullptr) return;
  char* block = static_cast<char*>(pointer) - head;
  bytes_in_use -= *reinterpret_cast<std::size_t*>(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
// Also the forms that do not throw, which std::stable_sort takes its buffer from: a sanitizer has its own, without the head.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted_or_null(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted_or_null(size); }
void operator delete(void* pointer) noexcept { release(pointer); }
void operator delete[](void* pointer) noexcept { release(pointer); }
void operator delete(void* pointer, std::size_t) noexcept { release(pointer); }
void operator delete[](void* pointer, std::size_t) noexcept { release(pointer); }
void operator delete(void* pointer, const std::nothrow_t&) noexcept { release(pointer); }
void operator delete[](void* pointer, const std::nothrow_t&) noexcept { release(pointer); }

namespace jointid {

std::size_t peak_bytes_of(const std::function<void()>& work) {
  const std::size_t before = bytes_in_use;
  peak_bytes = before;
  work();
  return peak_bytes - before;
}

}  // namespace jointid
