// For formats whose parts are found by their places: most mutations change some bytes and leave the others where they are.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

constexpr std::array<std::uint8_t, 8> telling = {0x00, 0x01, 0x02, 0x08, 0x7f, 0x80, 0xfe, 0xff};

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
  std::minstd_rand random(seed);
  if (size == 0 || random() % 8 == 0) return LLVMFuzzerMutate(data, size, max_size);
  const std::size_t changes = 1 + random() % 3;
  for (std::size_t i = 0; i < changes; ++i) {
    const std::size_t at = random() % size, length = std::min<std::size_t>(random() % 4 == 0 ? 4 : 1, size - at);
    const bool flip = random() % 2 == 0;
    for (std::size_t j = at; j < at + length; ++j) {
      data[j] = flip ? static_cast<std::uint8_t>(data[j] ^ (1U << random() % 8)) : telling[random() % telling.size()];
    }
  }
  return size;
}
