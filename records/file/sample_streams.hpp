#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>

#include "records/file/sample_stream.hpp"

/// The kinds of streams that open_samples() chooses from.
namespace jointid::records {

std::unique_ptr<SampleStream> open_text_samples(const std::filesystem::path& path, const StreamOptions& options);
std::unique_ptr<SampleStream> open_uff_samples(const std::filesystem::path& path, const StreamOptions& options);
std::unique_ptr<SampleStream> open_hdf5_samples(const std::filesystem::path& path, const StreamOptions& options);
/// Of what is held in memory: MATLAB v5 to v7, .npy.
std::unique_ptr<SampleStream> open_column_samples(const std::filesystem::path& path, const StreamOptions& options);

/// The samples [first, last) of `count` that are of a part.
struct SampleRange {
  std::size_t first = 0, last = 0;
};
inline SampleRange range_of(const StreamOptions& options, std::size_t count) {
  const std::size_t each = count / options.parts, rest = count % options.parts;
  return {each * options.part + std::min(options.part, rest), each * (options.part + 1) + std::min(options.part + 1, rest)};
}

}  // namespace jointid::records
