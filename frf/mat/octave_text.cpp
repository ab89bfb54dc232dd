#include "frf/mat/octave_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "frf/mat/mat_lookup.hpp"
#include "frf/mat/mat_reader.hpp"
#include "frf/text/number_text.hpp"

namespace jointid::frf {
namespace {

constexpr int deepest = 16;
constexpr std::size_t most_dims = 8;

/// "H" of "# name: H" where the key is "name".
std::optional<std::string_view> value_of(std::string_view line, std::string_view key) {
  std::string_view text = trimmed(line);
  if (!text.starts_with('#')) return std::nullopt;
  text = trimmed(text.substr(1));
  if (!text.starts_with(key) || !text.substr(key.size()).starts_with(':')) return std::nullopt;
  return trimmed(text.substr(key.size() + 1));
}

std::optional<double> number_of(std::string_view text) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double value = 0.0;
  if (text == "Inf" || text == "-Inf") return text.front() == '-' ? -infinite : infinite;
  if (text == "NA") return std::numeric_limits<double>::quiet_NaN();
  return !text.empty() && parse_cell(text, false, value) ? std::optional(value) : std::nullopt;
}

class OctaveText final : public MatFile {
 public:
  explicit OctaveText(const std::filesystem::path& path) : MatFile(path.string()), text_(read_text(path)), rest_(text_) {
    while (next_name()) variable(std::string(name_), 0);
    for (const MatVariable& each : content_) variables_.push_back(each.info);
    require_distinct_names();
    rest_ = {}, text_.clear();
  }

  MatVariable read_variable(const MatInfo& info) override {
    const auto found = std::ranges::find(variables_, info.name, &MatInfo::name);
    return content_[static_cast<std::size_t>(found - variables_.begin())];
  }

 private:
  [[noreturn]] void broken(const std::string& name, const std::string& problem) const {
    throw InputError({.kind = ErrorKind::data,
                      .file = file_,
                      .place = place_of(name),
                      .problem = problem,
                      .remedy = "the file is damaged or cut off; save it again"});
  }

  std::string_view next_line() { return take_until(rest_, '\n'); }

  /// Up to "# name: H".
  bool next_name() {
    while (!rest_.empty()) {
      if (const auto name = value_of(next_line(), "name")) return name_ = *name, true;
    }
    return false;
  }

  std::string_view key(const std::string& name, std::string_view wanted) {
    const std::string_view line = next_line();
    const auto value = value_of(line, wanted);
    if (!value) broken(name, "has no line '# " + std::string(wanted) + ":'");
    return *value;
  }

  std::size_t count(const std::string& name, std::string_view text) const {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value > text_.size())
      broken(name, "'" + std::string(text.substr(0, 20)) + "' is no size");
    return value;
  }

  /// The variable whose name was read, and those inside of it.
  void variable(const std::string& name, int depth) {
    if (depth > deepest) broken(name, "is nested too deeply");
    const std::string type(key(name, "type"));
    if (type == "scalar struct" || type == "struct") return structure(name, type == "struct", depth);
    if (type == "cell") return cell(name, depth);
    MatVariable read{.info = {.name = name, .kind = MatKind::other, .dims = {1, 1}}, .values = {}, .texts = {}};
    const bool complex = type.find("complex") != std::string::npos, diagonal = type.find("diagonal") != std::string::npos;
    if (type == "string" || type == "sq_string") {
      strings(read);
    } else if (type.ends_with("range")) {
      range(read);
    } else if (type.ends_with("matrix") && !diagonal && type.find("sparse") == std::string::npos) {
      matrix(read, complex);
    } else if (type.ends_with("scalar") || type == "bool") {
      read.info.kind = complex ? MatKind::complex : MatKind::real;
      numbers(read, next_line(), 1, complex);
    }
    content_.push_back(std::move(read));
  }

  void strings(MatVariable& read) {
    const std::string& name = read.info.name;
    std::size_t elements = 1;
    std::string_view line = next_line();
    if (const auto given = value_of(line, "elements")) elements = count(name, *given), line = {};
    for (std::size_t i = 0; i < elements; ++i) {
      const auto length = value_of(line.empty() ? next_line() : line, "length");
      if (!length) broken(name, "has no line '# length:'");
      line = {};
      std::string_view text = next_line();
      if (text.ends_with('\r')) text.remove_suffix(1);
      read.texts.emplace_back(text.substr(0, count(name, *length)));
    }
    read.info.kind = MatKind::text;
    read.info.dims = {elements, read.texts.empty() ? 0 : read.texts.front().size()};
  }

  void range(MatVariable& read) {
    next_line();  // # base, limit, increment
    const std::vector<std::string_view> cells = split(trimmed(next_line()), ' ');
    const auto at = [&](std::size_t i) { return i < cells.size() ? number_of(cells[i]) : std::nullopt; };
    const auto base = at(0), limit = at(1), step = at(2);
    const double steps = base && limit && step ? (*limit - *base) / *step : std::nan("");
    if (!(steps >= 0.0) || steps > 1e8) broken(read.info.name, "is no range of base, limit and increment");
    const auto size = static_cast<std::size_t>(std::floor(steps * (1.0 + 1e-15) + 1e-9)) + 1;
    for (std::size_t i = 0; i < size; ++i) read.values.emplace_back(*base + static_cast<double>(i) * *step);
    read.info.kind = MatKind::real;
    read.info.dims = {1, size};
  }

  /// The numbers of a line behind those that were read.
  void numbers(MatVariable& read, std::string_view line, std::size_t wanted, bool complex) const {
    const std::vector<std::string_view> cells = split(trimmed(line), ' ');
    const std::size_t before = read.values.size();
    for (const std::string_view text : cells) {
      if (text.empty()) continue;
      const bool enclosed = complex && text.size() > 2 && text.front() == '(' && text.back() == ')';
      const std::size_t comma = enclosed ? text.find(',') : std::string_view::npos;
      const auto re = number_of(enclosed ? text.substr(1, std::min(comma, text.size() - 1) - 1) : text);
      const auto im = enclosed && comma != std::string_view::npos ? number_of(text.substr(comma + 1, text.size() - comma - 2))
                                                                    : std::optional(0.0);
      if (!re || !im || enclosed != (comma != std::string_view::npos) || enclosed != complex)
        broken(read.info.name, "'" + std::string(text.substr(0, 40)) + "' is not a number");
      read.values.emplace_back(*re, *im);
    }
    if (read.values.size() - before != wanted)
      broken(read.info.name, "a line has " + std::to_string(read.values.size() - before) + " numbers, not " + std::to_string(wanted));
  }

  void matrix(MatVariable& read, bool complex) {
    const std::string& name = read.info.name;
    read.info.kind = complex ? MatKind::complex : MatKind::real;
    const std::string_view line = next_line();
    if (const auto dims = value_of(line, "ndims")) {
      sizes(name, count(name, *dims), read.info.dims);
      const std::size_t all = size(read.info);
      if (all > text_.size()) broken(name, "has more numbers than the file has letters");
      for (std::size_t i = 0; i < all; ++i) numbers(read, next_line(), 1, complex);
      return;
    }
    const auto given = value_of(line, "rows");
    if (!given) broken(name, "has no line '# rows:'");
    const std::size_t rows = count(name, *given), columns = count(name, key(name, "columns"));
    read.info.dims = {rows, columns};
    for (std::size_t i = 0; i < rows; ++i) numbers(read, next_line(), columns, complex);
    by_columns(read.values, rows, columns);
  }

  void sizes(const std::string& name, std::size_t dims, std::vector<std::size_t>& out) {
    const std::vector<std::string_view> cells = split(trimmed(next_line()), ' ');
    if (cells.size() != dims || dims > most_dims) broken(name, "has other sizes than '# ndims:' states");
    out.clear();
    for (const std::string_view text : cells) out.push_back(count(name, text));
  }

  /// Rows one behind the other into MATLAB's order.
  static void by_columns(std::vector<Complex>& values, std::size_t rows, std::size_t columns) {
    const std::vector<Complex> by_rows = values;
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = 0; j < columns; ++j) values[i + rows * j] = by_rows[i * columns + j];
    }
  }

  /// Texts together are one; numbers among them leave it another kind.
  void cell(const std::string& name, int depth) {
    const std::size_t begin = content_.size();
    const std::vector<std::size_t> dims = elements(name, [](std::size_t) { return std::string("<cell-element>"); }, depth);
    MatVariable read{.info = {.name = name, .kind = MatKind::text, .dims = dims}, .values = {}, .texts = {}};
    for (std::size_t i = begin; i < content_.size(); ++i) {
      if (content_[i].info.kind != MatKind::text) read.info.kind = MatKind::other;
      for (const std::string& text : content_[i].texts) read.texts.push_back(text);
    }
    content_.resize(begin);
    content_.push_back(std::move(read));
  }

  /// Those of a cell, each by a name.
  template <class Name>
  std::vector<std::size_t> elements(const std::string& name, const Name& named, int depth) {
    std::vector<std::size_t> dims;
    const std::string_view line = next_line();
    if (const auto given = value_of(line, "ndims")) {
      sizes(name, count(name, *given), dims);
    } else {
      const auto rows = value_of(line, "rows");
      if (!rows) broken(name, "has no line '# rows:'");
      dims = {count(name, *rows), count(name, key(name, "columns"))};
    }
    const std::size_t all = size(MatInfo{.name = {}, .dims = dims});
    for (std::size_t i = 0; i < all; ++i) {
      if (!next_name()) broken(name, "has fewer elements than its sizes state");
      variable(named(i), depth + 1);
    }
    return dims;
  }

  void structure(const std::string& name, bool array, int depth) {
    std::string_view line = next_line();
    std::vector<std::size_t> dims = {1, 1};
    if (const auto given = value_of(line, "ndims")) sizes(name, count(name, *given), dims), line = next_line();
    const auto length = value_of(line, "length");
    if (!length) broken(name, "has no line '# length:'");
    const std::size_t fields = count(name, *length);
    for (std::size_t i = 0; i < fields; ++i) {
      if (!next_name()) broken(name, "has fewer fields than '# length:' states");
      const std::string field(name_);
      if (!array) {
        variable(name + "." + field, depth + 1);
        continue;
      }
      if (key(name, "type") != "cell") broken(name, "is no array of structs");
      elements(name, [&](std::size_t k) { return name + "(" + std::to_string(k + 1) + ")." + field; }, depth);
    }
    content_.push_back({.info = {.name = name, .kind = MatKind::other, .dims = dims}, .values = {}, .texts = {}});
  }

  std::string text_;
  std::string_view rest_, name_;
  std::vector<MatVariable> content_;  ///< as variables_
};

}  // namespace

bool looks_like_octave_text(std::span<const char> head) {
  std::string_view rest(head.data(), head.size());
  bool named = false;
  while (!rest.empty()) {
    const std::string_view line = trimmed(take_until(rest, '\n'));
    if (named) return value_of(line, "type").has_value();
    if (!line.empty() && !line.starts_with('#')) return false;
    named = value_of(line, "name").has_value();
  }
  return false;
}

std::unique_ptr<MatFile> open_octave_variables(const std::filesystem::path& path) { return std::make_unique<OctaveText>(path); }

std::unique_ptr<FrfSource> open_octave_text(const std::filesystem::path& path, const OpenOptions& options) {
  OctaveText file(path);
  return from_memory(read_mat_frfs(file, options));
}

}  // namespace jointid::frf
