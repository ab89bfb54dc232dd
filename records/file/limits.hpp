#pragma once

#include <cstdint>

namespace jointid::records {

/// Records are held in memory whole: the largest file, and the most numbers (2 GiB of doubles) in one.
inline constexpr std::uint64_t most_file_bytes = std::uint64_t{2} << 30;
inline constexpr std::uint64_t most_numbers = std::uint64_t{1} << 28;

}  // namespace jointid::records
