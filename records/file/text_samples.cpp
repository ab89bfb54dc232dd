#include <array>
#include <charconv>
#include <cmath>
#include <fstream>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "frf/csv/lvm_file.hpp"
#include "frf/file/column_titles.hpp"
#include "frf/text/number_text.hpp"
#include "records/file/channel_choice.hpp"
#include "records/file/sample_streams.hpp"

namespace jointid::records {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 20;

/// Lines of a file from a byte on, with the byte at which each began.
class Lines {
 public:
  explicit Lines(const std::filesystem::path& path) : in_(path, std::ios::binary), buffer_(buffer_bytes) {
    if (!in_.is_open()) throw InputError({ErrorKind::data, path.string(), "", "cannot be read", ""});
  }

  void seek(std::uint64_t byte) {
    in_.clear();
    in_.seekg(static_cast<std::streamoff>(byte));
    begin_ = byte, next_ = end_ = 0;
  }
  std::uint64_t position() const { return begin_ + next_; }

  /// Without its end; it stands until the next call. False at the end of the file.
  bool next(std::string_view& line) {
    line_.clear();
    for (;;) {
      if (next_ == end_ && !fill()) {
        line = line_;
        return !line_.empty();
      }
      const std::string_view rest(buffer_.data() + next_, end_ - next_);
      const std::size_t stop = rest.find('\n');
      if (stop == std::string_view::npos) {
        line_.append(rest);
        next_ = end_;
        continue;
      }
      next_ += stop + 1;
      if (line_.empty()) {
        line = rest.substr(0, stop);
      } else {
        line = line_.append(rest.substr(0, stop));
      }
      return true;
    }
  }

 private:
  bool fill() {
    begin_ += end_;
    in_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    next_ = 0, end_ = static_cast<std::size_t>(in_.gcount());
    return end_ > 0;
  }

  std::ifstream in_;
  std::vector<char> buffer_;
  std::string line_;
  std::uint64_t begin_ = 0;
  std::size_t next_ = 0, end_ = 0;
};

class TextSamples final : public SampleStream {
 public:
  TextSamples(const std::filesystem::path& path, const StreamOptions& options) : SampleStream(path.string()), lines_(path) {
    begin();
    time_column_ = records::time_column(titles_);
    std::vector<std::size_t> chosen = chosen_columns(titles_, options.channels);
    place_.assign(titles_.columns.size(), {});
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      place_[chosen[k]].push_back(k);
      channels_.push_back({titles_.columns[chosen[k]].name, titles_.columns[chosen[k]].unit});
    }
    const std::uint64_t size = std::filesystem::file_size(path), data = lines_.position(), bytes = size - data;
    const auto border = [&](std::size_t part) {
      return data + bytes / options.parts * part + bytes % options.parts * part / options.parts;
    };
    end_ = options.part + 1 == options.parts ? size : border(options.part + 1);
    const std::uint64_t first = border(options.part);
    if (first == data) return;
    // A line is of the part in which it begins.
    lines_.seek(first - 1);
    std::string_view rest;
    lines_.next(rest);
  }

  std::size_t read(std::span<double> rows) override {
    const std::size_t width = channels_.size();
    std::size_t count = 0;
    std::string_view line;
    while ((count + 1) * width <= rows.size() && lines_.position() < end_) {
      const std::uint64_t byte = lines_.position();
      if (!lines_.next(line)) break;
      const std::string_view text = frf::trimmed(line);
      if (frf::is_comment(text)) continue;
      parse(line, rows.subspan(count++ * width, width), byte);
    }
    return count;
  }

 private:
  /// The titles, if any; leaves the position at the first line of numbers.
  void begin() {
    frf::ColumnTitles head(file_);
    bool began = false;
    std::string_view line;
    for (;;) {
      std::uint64_t byte = lines_.position();
      if (!lines_.next(line)) break;
      if (line.find('\0') != std::string_view::npos) {
        throw InputError(
            {ErrorKind::data, file_, "", "is no text, UFF, MATLAB, HDF5 or numpy file", "export the record as one of them"});
      }
      if (byte == 0 && frf::looks_like_lvm(line)) {
        throw InputError({ErrorKind::data, file_, "", "is a LabVIEW measurement file, which is not streamed",
                          "write its channels as text with one line of titles, or as HDF5"});
      }
      if (byte == 0 && line.starts_with("\xEF\xBB\xBF")) {
        line.remove_prefix(3);
        byte = 3;
      }
      if (!head.begins_with(line, place_of(byte))) continue;
      lines_.seek(byte);
      began = true;
      break;
    }
    if (!began) head.end();
    if (head.empty()) throw InputError({ErrorKind::data, file_, "", "holds no numbers", "give columns of numbers, e.g. t,x"});
    titles_ = head.columns();
    separator_ = head.separator();
    mark_ = frf::DecimalMark(separator_);
  }

  static std::string place_of(std::uint64_t byte) { return "line at byte " + std::to_string(byte); }

  [[noreturn]] void fail(std::uint64_t byte, const std::string& problem, const std::string& remedy) const {
    throw InputError({ErrorKind::data, file_, place_of(byte), problem, remedy});
  }

  void parse(std::string_view line, std::span<double> row, std::uint64_t byte) {
    if (!mark_.fits(line)) fail(byte, frf::mixed_marks, frf::one_mark);
    if (separator_ != ' ' && parse_plain(line, row)) return;
    const std::vector<std::string_view> cells = frf::split(line, separator_);
    if (cells.size() != place_.size()) {
      fail(byte, "has " + std::to_string(cells.size()) + " cells, the first line has " + std::to_string(place_.size()),
           "give every line the same cells; the first line may name the columns");
    }
    for (std::size_t k = 0; k < cells.size(); ++k) {
      double value = 0.0;
      if (!frf::parse_cell(cells[k], mark_.may_be_comma(), value)) {
        fail(byte, "column " + std::to_string(k + 1) + ": '" + std::string(cells[k].substr(0, 40)) + "' is not a number",
             "begin lines that are no numbers with #");
      }
      for (const std::size_t place : place_[k]) row[place] = value;
    }
  }

  /// Lines of plain numbers and empty cells, in place; false for anything else.
  bool parse_plain(std::string_view line, std::span<double> row) const {
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const char *next = line.data(), *const end = line.data() + line.size();
    for (std::size_t k = 0; k < place_.size(); ++k) {
      double value = nan;
      if (next != end && *next != separator_) {
        const auto [stop, error] = std::from_chars(next, end, value);
        if (error != std::errc() || std::isinf(value)) return false;
        next = stop;
      }
      const bool last = k + 1 == place_.size();
      if (last ? next != end : next == end || *next != separator_) return false;
      if (!last) ++next;
      for (const std::size_t place : place_[k]) row[place] = value;
    }
    return true;
  }

  Lines lines_;
  frf::Columns titles_;
  char separator_ = ' ';
  frf::DecimalMark mark_;
  std::vector<std::vector<std::size_t>> place_;  ///< by column of the file, where its numbers go in a row
  std::uint64_t end_ = 0;
};

}  // namespace

std::unique_ptr<SampleStream> open_text_samples(const std::filesystem::path& path, const StreamOptions& options) {
  return std::make_unique<TextSamples>(path, options);
}

}  // namespace jointid::records
