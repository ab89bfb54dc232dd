#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace jointid::records {

/// What the samples of a stream are of.
struct StreamChannel {
  std::string name, unit;
};

/// Which of the columns of a file, and which part of its samples.
struct StreamOptions {
  std::vector<std::string> channels;  ///< names, or numbers from 1; empty: all but a column of times
  std::size_t part = 0, parts = 1;    ///< the part-th of so many stretches of about equal size, part < parts
};

/// The samples of a record in order of time, an instant a row, without holding it in memory.
class SampleStream {
 public:
  virtual ~SampleStream() = default;
  SampleStream(const SampleStream&) = delete;
  SampleStream& operator=(const SampleStream&) = delete;

  const std::string& file() const { return file_; }
  const std::vector<StreamChannel>& channels() const { return channels_; }
  /// Numbers at the ends of longer channels that are left out, of all channels of the whole file together.
  std::size_t cut() const { return cut_; }
  /// The column of times among those that are left out by default; empty: none.
  const std::string& time_column() const { return time_column_; }
  /// Samples per second where the file states them beside its columns (UFF), else the given ones. Throws InputError where they
  /// contradict each other, or times are in a unit that is not understood.
  virtual std::optional<double> rate_hz(std::optional<double> given_hz = {}) { return given_hz; }

  /// Fills rows of as many numbers as there are channels, from the front of `rows` on, and returns how many; 0 at the end. NaN
  /// where a sample is missing.
  virtual std::size_t read(std::span<double> rows) = 0;

 protected:
  explicit SampleStream(std::string file) : file_(std::move(file)) {}

  std::string file_;
  std::vector<StreamChannel> channels_;
  std::size_t cut_ = 0;
  std::string time_column_;
};

}  // namespace jointid::records
