#include "frf/file/columns.hpp"

#include <algorithm>
#include <cctype>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/csv/csv_table.hpp"
#include "frf/file/file_format.hpp"
#include "frf/mat/mat_variable.hpp"
#include "frf/text/number_text.hpp"

namespace jointid::frf {
namespace {

[[noreturn]] void fail(const std::string& file, std::string place, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, file, std::move(place), std::move(problem), std::move(remedy)});
}

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

char separator_of(std::string_view line) {
  const char separator = csv_separator(trimmed(line));
  return separator == '\0' ? ' ' : separator;
}

class TextColumns {
 public:
  explicit TextColumns(const std::filesystem::path& path) : out_{path.string(), {}} {}

  Columns read(std::string_view rest) {
    if (rest.find('\0') != std::string_view::npos) {
      fail(out_.file, {}, "is no text, MATLAB or HDF5 file", "export the columns as CSV, MATLAB or HDF5");
    }
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    for (line_ = 1; !rest.empty(); ++line_) {
      const std::string_view line = take_until(rest, '\n'), text = trimmed(line);
      if (text.empty() || text.front() == '#' || text.front() == '%') continue;
      out_.columns.empty() ? begin(line) : add(line);
    }
    if (out_.columns.empty()) fail(out_.file, {}, "holds no numbers", "give columns of numbers, e.g. u,F");
    return std::move(out_);
  }

 private:
  void begin(std::string_view line) {
    separator_ = separator_of(line);
    const std::vector<std::string_view> cells = split(line, separator_);
    double value = 0.0;
    const bool numbers = std::ranges::all_of(cells, [&](std::string_view cell) { return parse_cell(cell, separator_ == ';', value); });
    for (std::size_t i = 0; i < cells.size(); ++i)
      out_.columns.push_back(numbers ? NumberColumn{std::to_string(i + 1), {}, {}} : titled_column(cells[i]));
    if (numbers) add(line);
  }

  void add(std::string_view line) {
    const std::vector<std::string_view> cells = split(line, separator_);
    const std::string place = "line " + std::to_string(line_);
    if (cells.size() != out_.columns.size()) {
      fail(out_.file, place, "has " + std::to_string(cells.size()) + " cells, the lines above have " + std::to_string(out_.columns.size()),
           "give every line the same cells; the first line may name the columns");
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      double value = 0.0;
      if (!parse_cell(cells[i], separator_ == ';', value)) {
        fail(out_.file, place + ", column " + std::to_string(i + 1), "'" + std::string(cells[i].substr(0, 40)) + "' is not a number",
             "begin lines that are no numbers with #");
      }
      out_.columns[i].values.push_back(value);
    }
  }

  Columns out_;
  std::size_t line_ = 0;
  char separator_ = ' ';
};

/// Adds a real vector, or the short side of a real matrix one by one.
void add_variable(const MatVariable& variable, Columns& out) {
  const std::vector<std::size_t>& dims = variable.info.dims;
  const std::size_t rows = dims.empty() ? 1 : dims[0], columns = rows == 0 ? 0 : variable.values.size() / rows;
  const bool by_column = rows >= columns;
  const std::size_t count = std::min(rows, columns), samples = std::max(rows, columns);
  for (std::size_t i = 0; i < count; ++i) {
    NumberColumn column{count == 1 ? variable.info.name : variable.info.name + "(" + std::to_string(i + 1) + ")", {}, {}};
    for (std::size_t k = 0; k < samples; ++k) column.values.push_back(variable.values[by_column ? k + rows * i : i + rows * k].real());
    out.columns.push_back(std::move(column));
  }
}

Columns read_variables(MatFile& file) {
  Columns out{file.file(), {}};
  for (const MatInfo& info : file.variables()) {
    const bool of_array = info.name.find('(') != std::string::npos;  // an array of structs
    if (info.kind == MatKind::real && info.dims.size() <= 2 && !of_array) add_variable(file.read(info), out);
  }
  if (out.columns.empty()) fail(out.file, {}, "has no real vector or matrix", "store displacement and force as vectors of doubles");
  return out;
}

std::string listed(const Columns& columns) {
  return comma_list(columns.columns, &NumberColumn::name);
}

}  // namespace

NumberColumn titled_column(std::string_view header) {
  const bool bracket = header.ends_with(']');
  const std::size_t open = bracket || header.ends_with(')') ? header.rfind(bracket ? '[' : '(') : std::string_view::npos;
  if (open == std::string_view::npos) return {std::string(header), {}, {}};
  return {std::string(trimmed(header.substr(0, open))), std::string(trimmed(header.substr(open + 1, header.size() - open - 2))), {}};
}

const NumberColumn& Columns::column(std::string_view name_or_number) const {
  const std::string wanted = lower(name_or_number);
  for (const NumberColumn& column : columns) {
    if (lower(column.name) == wanted) return column;
  }
  const bool number = !wanted.empty() && wanted.size() < 6 && std::ranges::all_of(wanted, [](char c) { return c >= '0' && c <= '9'; });
  const std::size_t index = number ? static_cast<std::size_t>(std::stoul(wanted)) : 0;
  if (index >= 1 && index <= columns.size()) return columns[index - 1];
  fail(file, {}, "there is no column '" + std::string(name_or_number) + "'", "the columns are " + listed(*this));
}

const NumberColumn* Columns::find(const std::vector<std::string_view>& words, const std::vector<std::string_view>& without) const {
  for (const NumberColumn& column : columns) {
    std::string text = lower(column.name);
    std::ranges::replace_if(text, [](unsigned char c) { return std::isalnum(c) == 0; }, ' ');
    const std::vector<std::string_view> parts = split(text, ' ');
    if (std::ranges::find_first_of(parts, words) != parts.end() && std::ranges::find_first_of(parts, without) == parts.end())
      return &column;
  }
  return nullptr;
}

Columns read_columns(const std::filesystem::path& path) {
  const std::optional<FileFormat> binary = detect_binary_format(path);
  if (!binary) return TextColumns(path).read(read_text(path));
  const auto file = *binary == FileFormat::matlab_v5 ? open_mat_variables_v5(path) : open_mat_variables_v73(path);
  return read_variables(*file);
}

}  // namespace jointid::frf
