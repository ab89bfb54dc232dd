#include "frf/uff/uff_scan.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "base/stop_scope.hpp"
#include "frf/text/footer.hpp"
#include "frf/uff/uff_text.hpp"

namespace jointid::frf::uff {
namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
constexpr const char* damaged = "the file is damaged or cut off; export it again";

class Scanner {
 public:
  explicit Scanner(ByteFile& file) : file_(file) {}

  std::vector<Dataset> run() {
    while (find_opening()) {
      datasets_.push_back(dataset());
    }
    return std::move(datasets_);
  }

 private:
  Place here() const { return {file_.name(), {}, file_.position()}; }

  /// Reads up to and including the next opening -1; false at the end of the file. Marks of UTF-8 stand where files were joined,
  /// too; an end-of-file byte of DOS is passed where a dataset follows, and is the end where anything else does.
  bool find_opening() {
    for (Place place = here(); file_.next_line(line_); place = here()) {
      const bool ends = line_.starts_with('\x1A');
      if (ends) line_.remove_prefix(1);
      if (line_.starts_with(utf8_mark)) line_.remove_prefix(utf8_mark.size());
      if (is_delimiter(line_)) return true;
      if (trim(line_).empty()) continue;
      if (ends || (!datasets_.empty() && only_words_follow())) return false;
      const std::string text = to_utf8(one_byte_per_column(line_.substr(0, 20)));
      place.fail({}, "a dataset must begin with '    -1' but '" + text + "' is here",
                 datasets_.empty() ? "this is not a UFF file" : damaged);
    }
    return false;
  }

  /// Whether the line that was read and all others to the end of the file, a few, are words and no numbers: "End of file".
  bool only_words_follow() {
    constexpr std::size_t most_lines = 20;
    const std::uint64_t back = file_.position();
    const std::string first(line_);
    bool words = false;
    std::size_t count = 0;
    for (line_ = first;; ++count) {
      const std::string_view text = trim(line_);
      const bool plain = std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; });
      words = text.empty() || (plain && is_footer({text}, 2) && !is_delimiter(line_) && text.find_first_of("+-.") != 0);
      if (!words || count == most_lines || !file_.next_line(line_)) break;
    }
    words = words && count < most_lines;
    if (!words) file_.seek(back), kept_ = first, line_ = kept_;
    return words;
  }

  Dataset dataset() {
    Dataset found = number_line();
    if (found.number == 58) {
      header58(found);
    } else if (found.binary) {
      binary_other(found);
      return found;
    }
    if (found.binary) {
      binary58(found);
    } else if (!passes_text58(found)) {
      text(found);
    }
    return found;
  }

  /// The identifier record: number in six columns, "b" in column 7, then for binary data I6 byte order, I6
  /// float format, I12 number of text lines, I12 number of bytes.
  Dataset number_line() {
    Dataset found;
    do {
      found.place = here();
      if (!file_.next_line(line_)) found.place.fail({}, "the file ends after '    -1'", damaged);
    } while (is_delimiter(line_));
    const auto fields = words(line_);
    std::string_view number = fields.empty() ? std::string_view() : fields[0];
    found.binary = number.ends_with('b') || number.ends_with('B');
    if (found.binary) number.remove_suffix(1);
    const bool apart = number == "58" && fields.size() > 4 && (fields[1] == "b" || fields[1] == "B");  // "58 b"
    found.binary = found.binary || apart;
    const auto value = parse_integer(number);
    if (number.empty() || !value || *value < 1 || *value > 999'999) {
      found.place.fail(
          {}, "'" + to_utf8(one_byte_per_column(line_.substr(0, 20))) + "' is not a dataset number",
          number.starts_with("58") ? "write 58 for numbers as text, 58b for binary ones; or export it again" : damaged);
    }
    found.number = static_cast<int>(*value);
    found.place.dataset =
        "dataset " + std::to_string(found.number) + " number " + std::to_string(++counts_[found.number]);
    if (found.binary) binary_fields(found, fields, apart ? 2 : 1);
    found.payload_begin = file_.position();
    return found;
  }

  /// By words, from the one at `first` on, where columns make no sense.
  void binary_fields(Dataset& found, const std::vector<std::string_view>& fields, std::size_t first) {
    std::array<std::int64_t, 4> values{};
    const auto is_field = [](std::size_t i, const std::optional<std::int64_t>& value) {
      return value && *value >= 0 && (i >= 2 || *value <= 9);
    };
    bool by_words = fields.size() >= first + values.size(), by_columns = true;
    constexpr std::array<std::size_t, 4> begins = {7, 13, 19, 31};
    constexpr std::array<std::size_t, 4> widths = {6, 6, 12, 12};
    for (std::size_t i = 0; i < values.size(); ++i) {
      by_columns = by_columns && is_field(i, parse_integer(column(line_, begins[i], widths[i])));
      by_words = by_words && is_field(i, parse_integer(fields[first + i]));
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool word = !by_columns && by_words;
      const auto value = parse_integer(word ? fields[first + i] : column(line_, begins[i], widths[i]));
      if (!is_field(i, value)) {
        found.place.fail("number line",
                         "'" + std::string(column(line_, begins[i], widths[i])) + "' is not valid", damaged);
      }
      values[i] = *value;
    }
    found.byte_order = static_cast<int>(values[0]);
    found.float_format = static_cast<int>(values[1]);
    declared_lines_ = values[2];
    declared_bytes_ = static_cast<std::uint64_t>(values[3]);
  }

  void header58(Dataset& found) {
    std::array<std::string, header_lines> lines;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!file_.next_line(line_) || (i > 4 && is_delimiter(line_))) {
        found.place.fail("record " + std::to_string(i + 1), "the header ends before its 11 lines", damaged);
      }
      lines[i] = line_;
    }
    found.function = parse_header58(lines, found.place);
    found.payload_begin = file_.position();
  }

  /// Passes the text of a function whose lines are all as long as the first one, which need not be looked at: where the last one
  /// that record 7 implies would stand, there is one of as many numbers as are left, and the closing -1 after it. Anything else
  /// is read by text().
  bool passes_text58(Dataset& found) {
    constexpr std::uint64_t few = 64;  // are read faster than looked for
    if (!found.function) return false;
    const std::uint64_t numbers = found.function->points * found.function->numbers_per_point();
    const std::uint64_t in_line = text_columns(*found.function).size();
    const std::uint64_t whole = (numbers - 1) / in_line;  // lines before the last
    if (whole < few) return false;
    const auto holds = [&](std::uint64_t count) { return file_.next_line(line_) && words(line_).size() == count; };
    const bool even = holds(in_line);
    const std::uint64_t length = file_.position() - found.payload_begin;
    if (even && whole < file_.size() / length) {
      const std::uint64_t last = found.payload_begin + whole * length;
      if (last < file_.size() && file_.read(last - 1, 1) == "\n") {
        file_.seek(last);
        if (holds(numbers - whole * in_line)) {
          found.payload_end = file_.position();
          found.payload_lines = whole + 1;
          if (file_.next_line(line_) && is_delimiter(line_)) return true;
        }
      }
    }
    found.payload_lines = 0;
    file_.seek(found.payload_begin);
    return false;
  }

  /// Passes text up to and including the closing -1.
  void text(Dataset& found) {
    found.payload_end = file_.position();
    while (file_.next_line(line_)) {
      stop_point();
      if (is_delimiter(line_)) return;
      found.payload_end = file_.position();
      if (!trim(line_).empty()) ++found.payload_lines;
    }
    found.cut_off = file_.size() > 0 && file_.read(file_.size() - 1, 1) != "\n";
  }

  /// Whether a closing -1 stands at `offset`, after at most one line end, or the file ends there.
  bool closes_at(std::uint64_t offset) {
    if (offset > file_.size()) return false;
    file_.seek(offset);
    for (int i = 0; i < 2; ++i) {
      if (!file_.next_line(line_)) return true;
      if (is_delimiter(line_)) return true;
      if (!trim(line_).empty()) return false;
    }
    return file_.position() == file_.size();
  }

  void binary58(Dataset& found) {
    const Header58& header = *found.function;
    const std::uint64_t width = header.is_double() ? 8 : 4;
    const std::uint64_t ordinates = header.points * width * (header.is_complex() ? 2 : 1);
    std::vector<std::uint64_t> abscissas = {header.even ? 0 : width};
    if (!header.even && header.is_double()) abscissas.push_back(4);
    std::stable_partition(abscissas.begin(), abscissas.end(), [&](std::uint64_t bytes) {
      return ordinates + header.points * bytes == declared_bytes_;
    });
    for (const std::uint64_t bytes : abscissas) {
      found.abscissa_bytes = bytes;
      found.payload_end = found.payload_begin + ordinates + header.points * bytes;
      if (closes_at(found.payload_end)) return;
    }
    unclosed58(found, ordinates + header.points * abscissas.back(), width);
  }

  [[noreturn]] void unclosed58(const Dataset& found, std::uint64_t bytes, std::uint64_t width) const {
    const std::uint64_t left = file_.size() - found.payload_begin;
    const std::uint64_t numbers = found.function->points * found.function->numbers_per_point();
    if (left < bytes) {
      found.place.fail("data",
                       "at most " + std::to_string(left / width) + " of " + std::to_string(numbers) +
                           " values were found before the end of the file",
                       damaged);
    }
    found.place.fail("data",
                     "no closing '    -1' is after the " + std::to_string(bytes) +
                         " bytes that record 7 implies (the number line declares " +
                         std::to_string(declared_bytes_) + ")",
                     damaged);
  }

  /// A binary dataset of another number: its text lines and bytes as it declares them.
  void binary_other(Dataset& found) {
    for (std::int64_t i = 0; i < declared_lines_; ++i) {
      if (!file_.next_line(line_)) found.place.fail("header", "the file ends inside the header", damaged);
    }
    const std::uint64_t begin = file_.position();
    if (declared_bytes_ > file_.size() - begin) {
      found.place.fail("data",
                       "declares " + std::to_string(declared_bytes_) + " bytes but the file holds " +
                           std::to_string(file_.size() - begin) + " more",
                       damaged);
    }
    found.payload_end = begin + declared_bytes_;
    if (!closes_at(found.payload_end)) {
      found.place.fail(
          "data",
          "no closing '    -1' is after the declared " + std::to_string(declared_bytes_) + " bytes",
          damaged);
    }
  }

  ByteFile& file_;
  std::string_view line_;
  std::string kept_;
  std::int64_t declared_lines_ = 0;
  std::uint64_t declared_bytes_ = 0;
  std::map<int, int> counts_;
  std::vector<Dataset> datasets_;
};

}  // namespace

std::vector<Dataset> scan(ByteFile& file) {
  file.seek(0);
  return Scanner(file).run();
}

}  // namespace jointid::frf::uff
