#include <algorithm>

#include "base/error.hpp"
#include "frf/file/columns.hpp"
#include "frf/file/file_head.hpp"
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

}  // namespace

std::unique_ptr<SampleStream> open_column_samples(const std::filesystem::path& path, const StreamOptions& options) {
  const std::uint64_t size = std::filesystem::file_size(path);
  if (size > most_file_bytes) {
    throw InputError({ErrorKind::data, path.string(), "",
                      std::to_string(size >> 20) + " MiB are more than the 2048 MiB that are read into memory",
                      "export the record as HDF5, MATLAB v7.3, UFF or text, which are read in parts"});
  }
  return std::make_unique<ColumnSamples>(looks_like_npy(frf::head_of(path)) ? read_npy(path) : frf::read_columns(path), options);
}

}  // namespace jointid::records
