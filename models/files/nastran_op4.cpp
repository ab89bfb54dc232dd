#include "models/files/nastran_op4.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

#include "base/temporary_file.hpp"
#include "base/text.hpp"
#include "frf/text/number_text.hpp"
#include "models/files/failure.hpp"

namespace jointid::models {
namespace {

constexpr std::size_t header_bytes = 24, long_header_bytes = 48;
constexpr std::int64_t string_base = 65536;

/// The head of a matrix. Types: 1 real single, 2 real double, 3 complex single, 4 complex double precision.
struct Op4Head {
  std::int64_t columns = 0, rows = 0, form = 0, type = 0;
  std::string name;
  bool long_words = false;  ///< integers and reals, single precision too, have 64 bits

  /// Strings have two integers: of 65,536 rows and more one cannot hold the row.
  bool is_big() const { return rows < 0 || rows >= string_base; }
  std::size_t size() const { return static_cast<std::size_t>(std::abs(rows)); }
  bool is_complex() const { return type >= 3; }
  /// Of an element.
  std::size_t words() const {
    if (long_words) return is_complex() ? 2 : 1;
    return type == 1 ? 1 : type == 4 ? 4 : 2;
  }
};

/// What both forms have in common: which matrix is wanted, and where its elements go.
class Op4Reader {
 public:
  Op4Reader(const std::filesystem::path& file, const std::string& wanted) : file_(file), wanted_(wanted), elements_(file) {}
  virtual ~Op4Reader() = default;
  Op4Reader(const Op4Reader&) = delete;
  Op4Reader& operator=(const Op4Reader&) = delete;

  FileMatrix read() {
    while (std::optional<Op4Head> head = next_head()) {
      check(*head);
      names_.push_back(head->name);
      const bool is_this = wanted_.empty() || head->name == wanted_;
      if (is_this && found_)
        refuse_file(file_, head->name, "the file holds several matrices: " + comma_list(names_) + " …",
                    "name one: \"FILE:NAME\"");
      if (is_this) found_ = *head;
      keeps_ = is_this;
      read_columns(*head);
    }
    if (!found_) {
      refuse_file(file_, wanted_,
                  names_.empty() ? "it holds no matrix" : "there is no such matrix; there are: " + comma_list(names_),
                  "name one of them: \"FILE:NAME\"");
    }
    if (static_cast<std::size_t>(found_->columns) != found_->size())
      refuse_file(file_, found_->name, "it is " + std::to_string(found_->size()) + " × " + std::to_string(found_->columns),
                  "mass, damping and stiffness are square");
    return elements_.matrix(found_->size(), FileElements::Mirror::none);
  }

 protected:
  virtual std::optional<Op4Head> next_head() = 0;
  virtual void read_columns(const Op4Head& head) = 0;
  virtual std::string place() const = 0;

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy = "write the matrix again by OUTPUT4") const {
    refuse_file(file_, place(), problem, remedy);
  }

  /// Element number `at` from `row` (from 1) of a column (from 1).
  void put(const Op4Head& head, std::int64_t row, std::int64_t column, double re, double im) {
    if (row < 1 || static_cast<std::size_t>(row) > head.size())
      fail("row " + std::to_string(row) + " of a matrix of " + std::to_string(head.size()) + " rows");
    if (!std::isfinite(re) || !std::isfinite(im))
      fail("element (" + std::to_string(row) + ", " + std::to_string(column) + ") is no finite number");
    if (keeps_ && (re != 0.0 || im != 0.0))
      elements_.add(static_cast<std::size_t>(row - 1), static_cast<std::size_t>(column - 1), re, im);
  }

  /// Row and number of elements of a string; two integers where the matrix is big.
  std::pair<std::int64_t, std::int64_t> string_of(const Op4Head& head, std::int64_t first, std::int64_t second) const {
    const std::int64_t words = head.is_big() ? first - 1 : first / string_base - 1;
    const std::int64_t row = head.is_big() ? second : first % string_base;
    const auto per = static_cast<std::int64_t>(head.words());
    if (words <= 0 || words % per != 0)
      fail("a string of " + std::to_string(words) + " words, of elements of " + std::to_string(per));
    return {row, words / per};
  }

 private:
  void check(const Op4Head& head) const {
    if (head.type < 1 || head.type > 4) fail("type " + std::to_string(head.type) + " is none of 1 to 4");
    if (head.size() < 1 || head.size() > most_sparse_rows || head.columns < 1 ||
        head.columns > static_cast<std::int64_t>(most_sparse_rows))
      fail("it has " + std::to_string(head.rows) + " rows and " + std::to_string(head.columns) + " columns",
           "matrices have 1 to 2000000 rows");
    if (head.form != 1 && head.form != 2 && head.form != 6)
      fail("form " + std::to_string(head.form) + " of matrix " + head.name, "write it as square (1) or symmetric (6)");
  }

  const std::filesystem::path& file_;
  std::string wanted_;
  std::vector<std::string> names_;
  std::optional<Op4Head> found_;
  bool keeps_ = false;
  FileElements elements_;
};

class BinaryOp4 final : public Op4Reader {
 public:
  BinaryOp4(const std::filesystem::path& file, const std::string& wanted)
      : Op4Reader(file, wanted), in_(file, std::ios::binary), left_(std::filesystem::file_size(file)) {
    std::array<char, 4> first{};
    in_.read(first.data(), 4);
    in_.seekg(0);
    const auto is_head = [&](std::size_t bytes) { return integer<std::int32_t>(first.data()) == static_cast<std::int64_t>(bytes); };
    swapped_ = !is_head(header_bytes) && !is_head(long_header_bytes);
    word_ = is_head(long_header_bytes) ? 8 : 4;
  }

 private:
  template <class Number>
  Number number(const char* at) const {
    std::array<char, sizeof(Number)> bytes{};
    std::copy_n(at, sizeof(Number), bytes.begin());
    if (swapped_) std::ranges::reverse(bytes);
    return std::bit_cast<Number>(bytes);
  }

  template <class Integer>
  std::int64_t integer(const char* at) const {
    return number<Integer>(at);
  }

  std::int64_t integer(std::size_t word) const {
    const char* at = record_.data() + word_ * word;
    return word_ == 8 ? integer<std::int64_t>(at) : integer<std::int32_t>(at);
  }

  std::string place() const override { return "byte " + std::to_string(at_); }

  /// A record between its lengths; false at the end of the file.
  bool next_record() {
    if (left_ == 0) return false;
    std::array<char, 4> length{};
    const auto count = [&]() -> std::size_t {
      if (left_ < 4 || !in_.read(length.data(), 4)) fail("the file ends early");
      left_ -= 4;
      at_ += 4;
      return static_cast<std::size_t>(std::max<std::int64_t>(0, integer<std::int32_t>(length.data())));
    };
    const std::size_t bytes = count();
    if (bytes == 0 || bytes > left_) fail("a record of " + std::to_string(bytes) + " bytes goes beyond the end of the file");
    record_.resize(bytes);
    if (!in_.read(record_.data(), static_cast<std::streamsize>(bytes))) fail("the file ends early");
    left_ -= bytes;
    at_ += bytes;
    if (count() != bytes) fail("a record does not end with its length");
    return true;
  }

  std::optional<Op4Head> next_head() override {
    if (!next_record()) return std::nullopt;
    if (record_.size() != 6 * word_) fail("a record of " + std::to_string(record_.size()) + " bytes where a matrix begins");
    Op4Head head{integer(0), integer(1), integer(2), integer(3), std::string(record_.data() + 4 * word_, 2 * word_), word_ == 8};
    std::erase_if(head.name, [](char c) { return c == ' ' || c == '\0'; });  // each word of a name is padded
    return head;
  }

  void read_columns(const Op4Head& head) override {
    for (std::int64_t last = 0;;) {
      if (!next_record() || record_.size() < 3 * word_) fail("the file ends early");
      const std::int64_t column = integer(0), row = integer(1), words = integer(2);
      if (column > head.columns) return;
      if (column <= last) fail("column " + std::to_string(column) + " after column " + std::to_string(last));
      last = column;
      if (words < 0 || static_cast<std::size_t>(words) != record_.size() / word_ - 3 || record_.size() % word_ != 0)
        fail("a column of " + std::to_string(words) + " words in a record of " + std::to_string(record_.size()) + " bytes");
      if (row > 0) {
        put_values(head, row, column, 3, static_cast<std::size_t>(words) / head.words());
        continue;
      }
      std::size_t at = 3;
      const std::size_t end = 3 + static_cast<std::size_t>(words), heading = head.is_big() ? 2 : 1;
      while (at < end) {
        if (at + heading > end) fail("a string of a column is cut");
        const auto [first, count] = string_of(head, integer(at), head.is_big() ? integer(at + 1) : 0);
        at += heading;
        if (at + static_cast<std::size_t>(count) * head.words() > end) fail("a string goes beyond its column");
        put_values(head, first, column, at, static_cast<std::size_t>(count));
        at += static_cast<std::size_t>(count) * head.words();
      }
    }
  }

  void put_values(const Op4Head& head, std::int64_t row, std::int64_t column, std::size_t word, std::size_t count) {
    const bool is_double = head.type == 2 || head.type == 4 || head.long_words;
    const std::size_t bytes = is_double ? 8 : 4;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = word_ * (word + i * head.words());
      const auto value = [&](std::size_t place) {
        const char* from = record_.data() + place;
        return is_double ? number<double>(from) : static_cast<double>(number<float>(from));
      };
      put(head, row + static_cast<std::int64_t>(i), column, value(at), head.is_complex() ? value(at + bytes) : 0.0);
    }
  }

  std::ifstream in_;
  std::size_t left_, at_ = 0;
  std::size_t word_ = 4;  ///< bytes
  bool swapped_ = false;
  std::vector<char> record_;
};

class TextOp4 final : public Op4Reader {
 public:
  TextOp4(const std::filesystem::path& file, const std::string& wanted) : Op4Reader(file, wanted), in_(file) {}

 private:
  std::string place() const override { return "line " + std::to_string(number_); }

  bool next_line() {
    if (kept_) {
      kept_ = false;
      return true;
    }
    if (!std::getline(in_, line_)) return false;
    ++number_;
    while (!line_.empty() && (line_.back() == '\r' || line_.back() == ' ')) line_.pop_back();
    return true;
  }

  void require_line() {
    if (!next_line()) fail("the file ends early");
  }

  std::vector<std::int64_t> integers(std::size_t count) {
    std::istringstream in(line_);
    std::vector<std::int64_t> out;
    for (std::int64_t value = 0; in >> value;) out.push_back(value);
    if (out.size() != count || !in.eof())
      fail("'" + line_.substr(0, 60) + "' is not " + std::to_string(count) + " whole numbers");
    return out;
  }

  /// "      10      10       6       2EYE10   1P,3E23.16"
  std::optional<Op4Head> next_head() override {
    do {
      if (!next_line()) return std::nullopt;
    } while (line_.empty());
    const std::string whole = line_;
    if (whole.size() < 40) fail("'" + whole + "' is no head of a matrix");
    line_ = whole.substr(0, 32);
    const std::vector<std::int64_t> numbers = integers(4);
    Op4Head head{numbers[0], numbers[1], numbers[2], numbers[3], whole.substr(32, 8)};
    head.name.resize(head.name.find_last_not_of(' ') + 1);
    const std::size_t e = whole.find('E', 40), point = whole.find('.', 40);
    double width = 0.0;
    if (e == std::string::npos || point == std::string::npos || point < e ||
        !frf::parse_cell(whole.substr(e + 1, point - e - 1), false, width) || width < 8.0 || width > 80.0)
      fail("'" + whole.substr(40) + "' is no format of numbers such as 1P,3E23.16");
    width_ = static_cast<std::size_t>(width);
    return head;
  }

  /// Numbers of the lines up to one of whole numbers.
  std::vector<double> values() {
    std::vector<double> out;
    while (next_line()) {
      if (line_.find('.') == std::string::npos || line_.find(',') != std::string::npos) {
        kept_ = true;
        break;
      }
      for (std::size_t at = 0; at < line_.size(); at += width_) {
        double value = 0.0;
        if (!parse_real(line_.substr(at, width_), value)) fail("'" + line_.substr(at, width_) + "' is no number");
        out.push_back(value);
      }
    }
    return out;
  }

  void read_columns(const Op4Head& head) override {
    const std::size_t per = head.is_complex() ? 2 : 1;
    for (std::int64_t last = 0;;) {
      require_line();
      const std::vector<std::int64_t> begin = integers(3);
      if (begin[0] > head.columns) {
        values();
        return;
      }
      if (begin[0] <= last) fail("column " + std::to_string(begin[0]) + " after column " + std::to_string(last));
      last = begin[0];
      if (begin[1] > 0) {
        const std::vector<double> read = values();
        const auto words = static_cast<std::size_t>(std::max<std::int64_t>(0, begin[2]));
        if (read.size() % per != 0 || (read.size() != words && read.size() * head.words() != words * per))
          fail("a column of " + std::to_string(begin[2]) + " words has " + std::to_string(read.size()) + " numbers");
        put_values(head, begin[1], begin[0], read);
      } else {
        read_strings(head, begin[0], begin[2]);
      }
    }
  }

  void read_strings(const Op4Head& head, std::int64_t column, std::int64_t words) {
    const std::size_t per = head.is_complex() ? 2 : 1;
    while (words > 0) {
      require_line();
      const std::vector<std::int64_t> string = integers(head.is_big() ? 2 : 1);
      const auto [row, count] = string_of(head, string[0], string.back());
      const std::vector<double> read = values();
      if (read.size() != static_cast<std::size_t>(count) * per)
        fail("a string of " + std::to_string(count) + " elements has " + std::to_string(read.size()) + " numbers");
      put_values(head, row, column, read);
      words -= count * static_cast<std::int64_t>(head.words()) + (head.is_big() ? 2 : 1);
    }
    if (words < 0) fail("strings have more words than their column");
  }

  void put_values(const Op4Head& head, std::int64_t row, std::int64_t column, const std::vector<double>& values) {
    const std::size_t per = head.is_complex() ? 2 : 1;
    for (std::size_t i = 0; i < values.size(); i += per)
      put(head, row + static_cast<std::int64_t>(i / per), column, values[i], per == 2 ? values[i + 1] : 0.0);
  }

  std::ifstream in_;
  std::string line_;
  bool kept_ = false;
  std::size_t number_ = 0, width_ = 0;
};

enum class Op4Kind { none, text, binary };

Op4Kind kind_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string head(100, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, in.gcount())));
  for (const std::size_t bytes : {header_bytes, long_header_bytes}) {
    const std::string little = {static_cast<char>(bytes), '\0', '\0', '\0'}, big(little.rbegin(), little.rend());
    for (const std::string& mark : {little, big}) {
      if (head.starts_with(mark) && head.size() >= bytes + 8 && head.substr(bytes + 4, 4) == mark)
        return Op4Kind::binary;
    }
  }
  const std::string line = head.substr(0, head.find('\n'));
  const bool is_text = line.size() > 40 && line.find(',') != std::string::npos && line.find_first_not_of("0123456789 -") >= 32 &&
                       line.find("1P") >= 34 && line.find("1P") != std::string::npos;
  return is_text ? Op4Kind::text : Op4Kind::none;
}

}  // namespace

bool is_op4(const std::filesystem::path& file) { return kind_of(file) != Op4Kind::none; }

FileMatrix read_op4(const std::filesystem::path& file, const std::string& name) {
  switch (kind_of(file)) {
    case Op4Kind::binary:
      return BinaryOp4(file, name).read();
    case Op4Kind::text:
      return TextOp4(file, name).read();
    case Op4Kind::none:
      break;
  }
  refuse_file(file, "", "it does not begin as OUTPUT4 does", "write the matrix by OUTPUT4");
}

}  // namespace jointid::models
