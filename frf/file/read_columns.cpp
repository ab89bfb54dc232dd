#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "frf/csv/csv_pipes.hpp"
#include "frf/csv/lvm_file.hpp"
#include "frf/file/column_titles.hpp"
#include "frf/file/column_units.hpp"
#include "frf/file/columns.hpp"
#include "frf/file/number_cell.hpp"
#include "frf/file/other_format.hpp"
#include "frf/file/table_remarks.hpp"
#include "frf/file/variables.hpp"
#include "frf/mat/mat_column.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/text/footer.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/plain_text.hpp"
#include "frf/text/special_number.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

[[noreturn]] void fail(const std::string& file, std::string place, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, file, std::move(place), std::move(problem), std::move(remedy)});
}

class TextColumns {
 public:
  explicit TextColumns(const std::filesystem::path& path) : out_{path.string(), {}}, titles_(out_.file) {}

  Columns read(std::string_view rest) {
    constexpr std::size_t of_head = 4096;
    require_read_format(out_.file, rest.substr(0, of_head));
    if (rest.find('\0') != std::string_view::npos) {
      fail(out_.file, {}, "is no text, MATLAB, HDF5 or numpy file", "export the columns as CSV, MATLAB, HDF5 or npz");
    }
    const bool cut = ends_in_a_cut_number(rest);
    for (line_ = 1; !rest.empty(); ++line_) {
      const std::string_view line = take_until(rest, '\n');
      if (!out_.columns.empty()) {
        if (!is_comment(trimmed(line))) take(line);
      } else if (titles_.begins_with(line, place())) {
        begin();
        add(line);
      }
    }
    if (out_.columns.empty()) titles_.end();
    if (titles_.empty()) fail(out_.file, {}, "holds no numbers", "give columns of numbers, e.g. u,F");
    if (out_.columns.empty()) begin();
    if (cut) fail(out_.file, "line " + std::to_string(line_ - 1), cut_number, whole_file);
    require_no_factor(out_);
    return std::move(out_);
  }

 private:
  std::string place() const { return "line " + std::to_string(line_); }

  void begin() {
    out_ = titles_.columns();
    mark_ = DecimalMark(titles_.separator());
  }

  /// A row, or a line of words below them.
  void take(std::string_view line) {
    const std::vector<std::string_view> cells = table_cells(line, titles_.separator());
    if (cells.size() > 1 && std::ranges::all_of(cells, [](std::string_view cell) { return cell.empty(); })) {
      empty_.push_back(std::string(line));  // of a spreadsheet, below the numbers
      return;
    }
    if (!out_.columns.front().values.empty() && is_footer(cells, out_.columns.size())) {
      if (words_.empty() && !is_page_mark(line)) words_ = std::string(trimmed(line).substr(0, 40)), words_place_ = place();
      if (lower_case(line).find("unit") != std::string::npos)
        fail(out_.file, place(), "'" + std::string(trimmed(line).substr(0, 40)) + "' below the numbers is not read",
             "write units into the titles, and begin lines that are no numbers with #");
    } else if (words_.empty()) {
      for (const std::string& row : std::exchange(empty_, {})) add(row);
      add(line);
    } else {
      fail(out_.file, words_place_ + ", column 1", "'" + words_ + "' is not a number", "begin lines that are no numbers with #");
    }
  }

  void add(std::string_view line) {
    const std::vector<std::string_view> cells = table_cells(line, titles_.separator());
    if (cells.size() != out_.columns.size()) {
      fail(out_.file, place(),
           "has " + std::to_string(cells.size()) + " cells, the lines above have " + std::to_string(out_.columns.size()),
           "give every line the same cells; the first line may name the columns");
    }
    if (!mark_.fits(line)) fail(out_.file, place(), mixed_marks, one_mark);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      double value = 0.0;
      const auto unit = read_number_cell(cells[i], mark_.may_be_comma(), value);
      if (unit && !unit->empty()) take_unit(i, *unit);
      if (!unit) value = number_of_label(i, cells[i]);
      if (std::isnan(value) && !states_no_value(cells[i])) {
        fail(out_.file, place() + ", column " + std::to_string(i + 1),
             "'" + std::string(cells[i].substr(0, 40)) + "' is not a number", remedy_of_text(cells[i]));
      }
      out_.columns[i].values.push_back(value);
    }
  }

  /// 21 of the node "PART-1-1.21" in a column of names of nodes, all behind the same letters; NaN for anything else.
  double number_of_label(std::size_t i, std::string_view cell) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    constexpr std::string_view digits = "0123456789";
    const NumberColumn& column = out_.columns[i];
    const std::size_t last = cell.find_last_not_of(digits);
    double value = none;
    if (!is_name_of_nodes(column.name) || last == std::string_view::npos || last + 1 == cell.size() ||
        !parse_cell(cell.substr(last + 1), false, value))
      return none;
    const std::string before(cell.substr(0, last + 1));
    if (std::ranges::none_of(before, [](unsigned char c) { return std::isalpha(c) != 0; })) return none;
    const auto [known, fresh] = labels_.emplace(i, before);
    return known->second == before && (!fresh || column.values.empty()) ? value : none;
  }

  /// Of a number of column i; all of its numbers have one.
  void take_unit(std::size_t i, std::string_view unit) {
    NumberColumn& column = out_.columns[i];
    if (column.unit.empty() && column.values.empty()) column.unit = unit;
    const auto own = parse_unit(column.unit), other = parse_unit(unit);
    if (own && other && own->same_dimension(*other) && own->si == other->si) return;
    fail(out_.file, place() + ", column " + std::to_string(i + 1),
         "'" + std::string(unit) + "' is behind a number, and '" + column.unit + "' is the unit of the others",
         "write all numbers of a column in one unit");
  }

  Columns out_;
  ColumnTitles titles_;
  DecimalMark mark_;
  std::map<std::size_t, std::string> labels_;  ///< what is before the numbers of a column of names
  std::vector<std::string> empty_;
  std::string words_, words_place_;  ///< first of the lines of words below the rows
  std::size_t line_ = 0;
};

/// Records are held in memory whole.
constexpr std::uint64_t most_numbers = std::uint64_t{1} << 28;
/// Measured numbers pack to a tenth of their size at best; a few idle channels more.
constexpr std::uint64_t freely_unpacked = std::uint64_t{64} << 20, most_unpacked = 64;

std::uint64_t numbers_of(const MatInfo& info) {
  std::uint64_t count = 1;
  for (const std::size_t extent : info.dims)
    count = extent > 0 && count > most_numbers / extent ? most_numbers + 1 : count * extent;
  return count;
}

void require_bounded(const MatFile& file) {
  std::uint64_t numbers = 0, columns = 0;
  for (const MatInfo& info : file.variables()) {
    if (!is_column(info)) continue;
    numbers = std::min(numbers + numbers_of(info), most_numbers + 1);
    columns += columns_of(info);
  }
  if (numbers > most_numbers)
    fail(file.file(), {}, "holds more than 268 million numbers", "keep the variables that are needed, or split it");
  if (columns > most_columns)
    fail(file.file(), {},
         std::to_string(columns) + " columns are more than the " + std::to_string(most_columns) + " that are read",
         "keep the variables that are needed; are the axes of a matrix exchanged?");
  const std::uint64_t bytes = sizeof(double) * numbers, size = std::filesystem::file_size(file.file());
  if (bytes <= std::max(freely_unpacked, most_unpacked * size)) return;
  fail(file.file(), {},
       "unpacks to " + std::to_string(bytes >> 20) + " MB, " + std::to_string(bytes / size) +
           " times its size, where measured numbers give ten",
       "keep the variables that are needed, or store them without compression");
}

/// Rows of `count` columns each into the columns from `first` on.
void append_rows(const std::vector<double>& rows, std::size_t count, Columns& out, std::size_t first) {
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double>& values = out.columns[first + k].values;
    for (std::size_t at = k; at < rows.size(); at += count) values.push_back(rows[at]);
  }
}

/// The samples of a real vector or matrix, the short side of a matrix one by one.
void append_values(MatFile& file, const MatInfo& info, std::size_t count, std::size_t samples, Columns& out, std::size_t first) {
  if (file.reads_samples() && !info.dims.empty()) {
    constexpr std::size_t block = 65536;
    for (std::size_t at = 0; at < samples; at += block)
      append_rows(file.read_samples(info, at, std::min(block, samples - at)), count, out, first);
    return;
  }
  const MatVariable variable = file.read(info);
  const bool by_column = info.dims.empty() || info.dims[0] >= count * samples / info.dims[0];
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < samples; ++k)
      out.columns[first + i].values.push_back(variable.values[by_column ? k + samples * i : i + count * k].real());
  }
}

void add_variable(MatFile& file, const MatInfo& info, const ColumnUnits& units, Columns& out) {
  const std::size_t size = numbers_of(info), count = size == 0 ? 0 : columns_of(info), first = out.columns.size();
  if (count == 0) return;
  const std::vector<std::string> stated = units.of(info);
  for (std::size_t i = 0; i < count; ++i) {
    out.columns.push_back({column_name(info, i), stated[i], {}});
    out.columns.back().values.reserve(size / count);
  }
  append_values(file, info, count, size / count, out, first);
}

/// Single numbers that are attributes of the arrays, of their groups and of the file, with a unit behind them or without.
void add_attributes(MatFile& file, Columns& out) {
  constexpr std::size_t most_arrays = 100;
  std::set<std::string> known;
  std::size_t arrays = 0;
  for (const MatInfo& info : file.variables()) {
    if (!is_column(info) || ++arrays > most_arrays) continue;
    for (const auto& [name, text] : file.notes(info)) {
      const std::string_view number = trimmed(text);
      const std::size_t blank = std::min(number.find(' '), number.size());
      double value = 0.0;
      if (!number.empty() && parse_cell(number.substr(0, blank), false, value) && known.insert(name).second)
        out.attributes.push_back({name, std::string(trimmed(number.substr(blank))), {value}});
    }
  }
}

Columns read_variables(MatFile& file) {
  Columns out{file.file(), {}};
  require_bounded(file);
  const ColumnUnits units(file);
  for (const MatInfo& info : file.variables()) {
    const bool number = info.kind == MatKind::real && info.dims.empty();
    if (number || is_column(info)) add_variable(file, info, units, out);
  }
  if (out.columns.empty())
    fail(out.file, {}, "has no real vector or matrix",
         "store each channel as a vector of doubles; of a table (compound) write each field as a dataset");
  for (auto& [name, text] : units.unread()) out.remarks.push_back({name, name + ": " + text});
  add_attributes(file, out);
  take_unit_suffixes(out);
  require_no_factor(out);
  return out;
}

/// Channels behind their axis, "X_Value [s]" where it is one of times.
Columns columns_of(LvmFile&& lvm) {
  Columns out{lvm.file, {}};
  const bool times = lower_case(lvm.dimension) == "time";
  out.columns.push_back({times ? "Time" : lvm.dimension, lvm.x_unit.empty() && times ? "s" : lvm.x_unit, std::move(lvm.x)});
  for (LvmFile::Channel& channel : lvm.channels) {
    out.columns.push_back(titled_column(channel.name));
    if (!channel.unit.empty()) out.columns.back().unit = channel.unit;
    out.columns.back().values = std::move(channel.values);
  }
  return out;
}

}  // namespace

Columns read_columns(const std::filesystem::path& path) {
  if (const auto file = open_variables(path)) return read_variables(*file);
  std::string text = read_plain_text(path);
  if (auto piped = tabs_for_pipes(text)) text = std::move(*piped);
  return looks_like_lvm(text) ? columns_of(read_lvm(path.string(), text)) : TextColumns(path).read(text);
}

}  // namespace jointid::frf
