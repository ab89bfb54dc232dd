#include "records/file/sample_stream.hpp"

#include <algorithm>
#include <fstream>

#include "base/error.hpp"
#include "frf/file/columns.hpp"
#include "frf/file/file_format.hpp"
#include "frf/uff/uff_file.hpp"
#include "records/file/channel_choice.hpp"
#include "records/file/limits.hpp"
#include "records/file/npy_file.hpp"
#include "records/file/sample_streams.hpp"

namespace jointid::records {
namespace {

/// Columns that are in memory.
class ColumnSamples final : public SampleStream {
 public:
  ColumnSamples(frf::Columns columns, const StreamOptions& options) : SampleStream(columns.file), columns_(std::move(columns)) {
    time_column_ = records::time_column(columns_);
    chosen_ = chosen_columns(columns_, options.channels);
    std::size_t shortest = columns_.columns[chosen_.front()].values.size();
    for (const std::size_t k : chosen_) shortest = std::min(shortest, columns_.columns[k].values.size());
    for (const std::size_t k : chosen_) {
      channels_.push_back({columns_.columns[k].name, columns_.columns[k].unit});
      cut_ += columns_.columns[k].values.size() - shortest;
    }
    range_ = range_of(options, shortest);
  }

  std::size_t read(std::span<double> rows) override {
    const std::size_t count = std::min(rows.size() / chosen_.size(), range_.last - range_.first);
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
      const std::vector<double>& values = columns_.columns[chosen_[k]].values;
      for (std::size_t i = 0; i < count; ++i) rows[i * chosen_.size() + k] = values[range_.first + i];
    }
    range_.first += count;
    return count;
  }

 private:
  frf::Columns columns_;
  std::vector<std::size_t> chosen_;
  SampleRange range_;
};

std::string head_of(const std::filesystem::path& path) {
  std::string head(512, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

}  // namespace

SampleRange range_of(const StreamOptions& options, std::size_t count) {
  return {count / options.parts * options.part + std::min(options.part, count % options.parts),
          count / options.parts * (options.part + 1) + std::min(options.part + 1, count % options.parts)};
}

std::unique_ptr<SampleStream> open_column_samples(const std::filesystem::path& path, const StreamOptions& options) {
  const std::uint64_t size = std::filesystem::file_size(path);
  if (size > most_file_bytes) {
    throw InputError({ErrorKind::data, path.string(), "",
                      std::to_string(size >> 20) + " MiB are more than the 2048 MiB that are read into memory",
                      "export the record as HDF5, MATLAB v7.3, UFF or text, which are read in parts"});
  }
  return std::make_unique<ColumnSamples>(looks_like_npy(head_of(path)) ? read_npy(path) : frf::read_columns(path), options);
}

std::unique_ptr<SampleStream> open_samples(const std::filesystem::path& path, const StreamOptions& options) {
  if (options.part >= options.parts)
    throw InputError({ErrorKind::usage, path.string(), "part", "is not one of " + std::to_string(options.parts), ""});
  const auto binary = frf::detect_binary_format(path);
  if (binary && *binary == frf::FileFormat::matlab_v5) return open_column_samples(path, options);
  if (binary) return open_hdf5_samples(path, options);
  const std::string head = head_of(path);
  if (frf::looks_like_uff(head)) return open_uff_samples(path, options);
  return looks_like_npy(head) ? open_column_samples(path, options) : open_text_samples(path, options);
}

}  // namespace jointid::records
