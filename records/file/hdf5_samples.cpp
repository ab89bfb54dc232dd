#include <algorithm>

#include "base/error.hpp"
#include "frf/file/column_titles.hpp"
#include "frf/file/column_units.hpp"
#include "frf/mat/mat_column.hpp"
#include "records/file/channel_choice.hpp"
#include "records/file/sample_streams.hpp"

namespace jointid::records {
namespace {

/// Where a column of a file stands.
struct Source {
  std::size_t variable = 0, column = 0;  ///< of the file; of the variable
};

class Hdf5Samples final : public SampleStream {
 public:
  Hdf5Samples(const std::filesystem::path& path, const StreamOptions& options)
      : SampleStream(path.string()), mat_(frf::open_mat_variables_v73(path)) {
    frf::Columns titles{file_, {}};
    std::vector<Source> sources;
    const frf::ColumnUnits units(*mat_);
    for (std::size_t v = 0; v < mat_->variables().size(); ++v) add(v, units, titles, sources);
    if (titles.columns.empty())
      throw InputError({ErrorKind::data, file_, "", "has no real vector or matrix", "store the channels as vectors of doubles"});
    frf::take_unit_suffixes(titles);
    time_column_ = records::time_column(titles);
    std::size_t shortest = static_cast<std::size_t>(-1);
    for (const std::size_t k : chosen_columns(titles, options.channels)) {
      channels_.push_back({titles.columns[k].name, titles.columns[k].unit});
      sources_.push_back(sources[k]);
      shortest = std::min(shortest, samples(sources[k].variable));
    }
    for (const Source& source : sources_) cut_ += samples(source.variable) - shortest;
    range_ = range_of(options, shortest);
  }

  std::size_t read(std::span<double> rows) override {
    const std::size_t width = sources_.size(), count = std::min(rows.size() / width, range_.last - range_.first);
    if (count == 0) return 0;
    std::size_t read = static_cast<std::size_t>(-1);
    std::vector<double> values;
    for (std::size_t k = 0; k < width; ++k) {
      const frf::MatInfo& info = mat_->variables()[sources_[k].variable];
      if (sources_[k].variable != read) values = mat_->read_samples(info, range_.first, count);
      read = sources_[k].variable;
      const std::size_t others = values.size() / count;
      for (std::size_t i = 0; i < count; ++i) rows[i * width + k] = values[i * others + sources_[k].column];
    }
    range_.first += count;
    return count;
  }

 private:
  /// As frf::read_columns() names them.
  void add(std::size_t variable, const frf::ColumnUnits& units, frf::Columns& titles, std::vector<Source>& sources) const {
    const frf::MatInfo& info = mat_->variables()[variable];
    if (!frf::is_column(info)) return;
    const std::size_t count = frf::columns_of(info);
    if (titles.columns.size() + count > frf::most_columns) {
      throw InputError({ErrorKind::data, file_, "",
                        "holds more than the " + std::to_string(frf::most_columns) + " columns that are read",
                        "keep the variables that are needed; are the axes of a matrix exchanged?"});
    }
    const std::vector<std::string> stated = units.of(info);
    for (std::size_t k = 0; k < count; ++k) {
      titles.columns.push_back({frf::column_name(info, k), stated[k], {}});
      sources.push_back({variable, k});
    }
  }

  std::size_t samples(std::size_t variable) const { return *std::ranges::max_element(mat_->variables()[variable].dims); }

  std::unique_ptr<frf::MatFile> mat_;
  std::vector<Source> sources_;
  SampleRange range_;
};

}  // namespace

std::unique_ptr<SampleStream> open_hdf5_samples(const std::filesystem::path& path, const StreamOptions& options) {
  return std::make_unique<Hdf5Samples>(path, options);
}

}  // namespace jointid::records
