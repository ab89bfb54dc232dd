#include "frf/csv/csv_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "frf/csv/csv_blanks.hpp"
#include "frf/csv/csv_columns.hpp"
#include "frf/csv/csv_decibels.hpp"
#include "frf/csv/csv_nodes.hpp"
#include "frf/csv/csv_pipes.hpp"
#include "frf/csv/csv_row_names.hpp"
#include "frf/csv/lvm_file.hpp"
#include "frf/polar/polar_search.hpp"
#include "frf/set/line_scale.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "frf/text/located.hpp"
#include "frf/text/plain_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

using enum CsvPart;

constexpr std::size_t fewest_phases = 8;
constexpr double surely_degrees = 1.0, surely_radians = 3.0;
constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void fail(const CsvTable& table, std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = table.file,
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

/// The unit that the file gives its FRFs first, and where; empty where it gives none.
struct StatedUnit {
  std::string label, place;
};

StatedUnit first_unit(const CsvTable& table, const CsvColumns& columns) {
  const auto key = table.keys.find("unit");
  if (key != table.keys.end()) return {key->second, "# unit"};
  for (const auto& [pair, of_pair] : columns.pairs()) {
    std::size_t column = 0;
    if (const std::string& unit = columns.unit(of_pair, column); !unit.empty())
      return {unit, table.place(table.units_line, column)};
  }
  return {};
}

/// What the user says stands in place of what the file says of the FRFs, understood or not.
void set_unit(CsvTable& table, const CsvColumns& columns, const std::string& unit) {
  table.keys["unit"] = unit;
  for (const auto& [pair, of_pair] : columns.pairs()) {
    for (const CsvPart part : {re, im, mag}) {
      if (of_pair.has(part)) table.units[of_pair[part]].clear();
    }
  }
}

/// FRFs of a LabVIEW measurement file.
CsvTable table_of(LvmFile&& lvm, const CsvGiven& given) {
  CsvTable table;
  table.file = lvm.file, table.header_line = table.units_line = lvm.titles_line;
  if (lower_case(lvm.dimension) != "frequency" && given.frequency_unit.empty())
    fail(table, "X_Dimension", "is over '" + shown_label(lvm.dimension) + "', not over frequencies",
         "make FRFs of time records by jointid frf, or give the unit of the axis: --frequency-unit, in a scene frequency_unit");
  const std::string& axis = given.frequency_unit.empty() ? lvm.x_unit : given.frequency_unit;
  table.hz_per_unit = located(table.file, "X_Unit_Label", [&] { return hertz_per(axis).value_or(1.0); });
  table.columns = {"Frequency"}, table.units = {""}, table.places = {0};
  for (const LvmFile::Channel& channel : lvm.channels) {
    CsvTitle title = csv_title(channel.name);
    table.places.push_back(table.columns.size());
    table.columns.push_back(std::move(title.title));
    table.units.push_back(channel.unit.empty() ? title.unit : as_ratio(channel.unit));
  }
  for (std::size_t row = 0; row < lvm.x.size(); ++row) {
    table.lines.push_back(lvm.titles_line + 1 + row);
    table.cells.push_back(lvm.x[row]);
    for (const LvmFile::Channel& channel : lvm.channels) table.cells.push_back(channel.values[row]);
  }
  return table;
}

/// Numbers that nobody says what they are, as analysers export them below a head of their own.
void require_titles(const std::string& text, const std::string& file, const OpenOptions& options) {
  if (!options.frequency_unit.empty() || looks_like_lvm(text) || find_csv_header(text)) return;
  const std::size_t line = line_without_titles(text);
  if (line == 0) return;
  throw InputError({.kind = ErrorKind::data,
                    .file = file,
                    .place = "line " + std::to_string(line),
                    .problem = "the numbers have no row of titles above them, which states what each column holds",
                    .remedy = std::string(write_titles)});
}

CsvTable read_table(const std::filesystem::path& path, const OpenOptions& options) {
  const CsvGiven given{.unit = !options.unit.empty(), .frequency_unit = options.frequency_unit};
  std::string text = read_plain_text(path);
  if (auto piped = tabs_for_pipes(text)) {
    text = std::move(*piped);
  } else if (auto named = without_row_names(text)) {
    text = std::move(*named);
  } else if (auto table = tabs_for_blanks(text)) {
    text = std::move(*table);
  }
  require_titles(text, path.string(), options);
  return looks_like_lvm(text) ? table_of(read_lvm(path.string(), text), given) : read_csv_table(path.string(), text, given);
}

Quantity read_quantity(const CsvTable& table, const CsvColumns& columns, const OpenOptions& options) {
  const auto key = table.keys.find("quantity");
  if (key != table.keys.end())
    return located(table.file, "# quantity", [&] { return parse_quantity(key->second, options.quantity); });
  if (options.quantity) return *options.quantity;
  const StatedUnit unit = first_unit(table, columns);
  if (const auto quantity = quantity_of_unit(unit.label)) return *quantity;
  if (!states_no_unit(unit.label))
    fail(table, unit.place, unknown_unit(unit.label), "correct it, or give the unit of the numbers: --unit g/N, in a scene unit");
  fail(table, {}, "does not state which quantity it holds",
       "begin it with e.g. # quantity = accelerance, or give it: --quantity accelerance, in a scene quantity");
}

/// Factor to SI of a label; what is wrong with it can be put right by the user, too.
template <class Factor>
double factor_of(const CsvTable& table, const std::string& place, const Factor& factor) {
  try {
    return located(table.file, place, factor);
  } catch (const InputError& error) {
    fail(table, place, error.parts().problem, error.parts().remedy + "; or give the unit of the numbers: --unit, in a scene unit");
  }
}

/// By the key `unit`, by the unit of its columns, or 1. Throws where both are there and differ.
double si_factor_of(const CsvTable& table, const CsvColumns& columns, const CsvColumns::Pairs::value_type& frf, const FrfHeader& header) {
  const auto [r, c] = frf.first;
  const CsvColumns::OfPair& pair = frf.second;
  const auto key = table.keys.find("unit");
  const bool by_key = key != table.keys.end() && !states_no_unit(key->second);
  std::size_t column = 0;
  const std::string& own = columns.unit(pair, column);
  const double of_file = by_key ? factor_of(table, "# unit", [&] { return si_factor(key->second, header); }) : 1.0;
  if (column == 0) return of_file;
  const std::string place = table.place(table.units_line, column);
  const double of_column = factor_of(table, place, [&, r = r, c = c] { return si_factor(own, header, r, c); });
  if (by_key && std::abs(of_file - of_column) > 1e-9 * of_file) {
    table.fail(table.units_line, column,
               "the unit '" + shown_label(own) + "' is not that of # unit, '" + shown_label(key->second) + "'",
               "remove the wrong one");
  }
  return of_column;
}

double read_averages(const CsvTable& table) {
  const auto key = table.keys.find("averages");
  if (key == table.keys.end()) return 0.0;
  const std::string& text = key->second;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && value >= 1.0) return value;
  fail(table, "# averages", "'" + text + "' is not a number of averages", "write e.g. # averages = 10, or leave it out");
}

void read_noise_kind(const CsvTable& table, const CsvColumns& columns, FrfHeader& header) {
  if (columns.has(coherence) && columns.has(var_re)) {
    fail(table, {}, "has both variances and coherences", "keep the one that was measured");
  }
  if (columns.has(var_re)) header.noise = NoiseRecord::variance;
  if (columns.has(coherence)) {
    header.noise = NoiseRecord::coherence;
    header.averages = read_averages(table);
  }
}

/// NaN in either half makes the whole value not measured.
Complex whole(double a, double b) { return std::isnan(a) || std::isnan(b) ? Complex{not_measured, not_measured} : Complex{a, b}; }

Complex stored_value(const CsvTable& table, std::size_t row, const CsvColumns::OfPair& columns) {
  if (columns.has(re)) return whole(table.cell(row, columns[re]), table.cell(row, columns[im]));
  const double angle = columns.has(phase_rad) ? table.cell(row, columns[phase_rad])
                                              : table.cell(row, columns[phase_deg]) * std::numbers::pi / 180.0;
  const double magnitude = table.cell(row, columns[mag]);
  if (magnitude < 0.0) {
    table.fail(table.lines[row], columns[mag], fmt::format("the magnitude {:g} is below 0", magnitude),
               "give magnitudes, not decibels or parts, and turn the phase by 180 degrees where the sign is meant");
  }
  return whole(magnitude * std::cos(angle), magnitude * std::sin(angle));
}

void fill(const CsvTable& table, const CsvColumns& columns, FrfSet& set) {
  const FrfHeader& header = set.header;
  const std::size_t size = header.lines() * header.entries();
  set.values.assign(size, {not_measured, not_measured});
  if (header.noise == NoiseRecord::variance) set.variance.assign(size, {not_measured, not_measured});
  if (header.noise == NoiseRecord::coherence) set.coherence.assign(size, not_measured);
  std::vector<double> si;  // of each pair
  for (const auto& frf : columns.pairs()) si.push_back(si_factor_of(table, columns, frf, header));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::size_t k = 0;
    for (const auto& [pair, of_pair] : columns.pairs()) {
      const LineScale scale = LineScale::to_receptance(header.quantity, si[k++], header.frequency_hz[row]);
      const std::size_t at = set.index(row, pair.first, pair.second);
      set.values[at] = scale.value(stored_value(table, row, of_pair));
      if (of_pair.has(var_re)) {
        set.variance[at] = scale.variance(whole(table.cell(row, of_pair[var_re]), table.cell(row, of_pair[var_im])));
      }
      if (of_pair.has(coherence)) set.coherence[at] = table.cell(row, of_pair[coherence]);
    }
  }
}

/// Largest phase of the columns phase_deg, as it stands there; 0 where there are few.
double largest_phase(const CsvTable& table, const CsvColumns& columns) {
  double largest = 0.0;
  std::size_t count = 0;
  for (const auto& [pair, of_pair] : columns.pairs()) {
    for (std::size_t row = 0; of_pair.has(phase_deg) && row < table.rows(); ++row) {
      const double phase = std::abs(table.cell(row, of_pair[phase_deg]));
      if (std::isnan(phase)) continue;
      largest = std::max(largest, phase);
      ++count;
    }
  }
  return count < fewest_phases ? 0.0 : largest;
}

/// Radians that are called degrees fill ±π; real degrees reach beyond it where a mode or an antiresonance is near.
void doubt_degrees(const CsvTable& table, const CsvColumns& columns, FrfHeader& header) {
  const double largest = largest_phase(table, columns);
  if (largest > std::numbers::pi * (1.0 + 1e-6) || largest < surely_degrees) return;
  const std::string told = fmt::format("no phase of the columns phase_deg is beyond {:.4g}, as if they were radians", largest);
  if (largest >= surely_radians) fail(table, {}, told, "name the columns phase_rad, or export degrees");
  header.doubts.push_back(told + "; if they are, name the columns phase_rad");
}

/// Degrees that are called radians leap from line to line, or from −180 to 180, by more than a turn is in radians.
void require_radians(const CsvTable& table, const CsvColumns& columns) {
  constexpr double turn = 2.0 * std::numbers::pi * (1.0 + 1e-6);
  for (const auto& [pair, of_pair] : columns.pairs()) {
    for (std::size_t row = 1; of_pair.has(phase_rad) && row < table.rows(); ++row) {
      const double before = table.cell(row - 1, of_pair[phase_rad]), phase = table.cell(row, of_pair[phase_rad]);
      if (!(std::abs(phase - before) > turn)) continue;
      table.fail(table.lines[row], of_pair[phase_rad],
                 fmt::format("the phase goes from {:g} to {:g} in one line, more than a turn in radians: is it in degrees?", before, phase),
                 "name the unit of the phases as it is: phase_deg, [deg]");
    }
  }
}

/// Columns of real and imaginary parts that hold magnitudes and phases.
void require_parts(const CsvTable& table, const CsvColumns& columns, FrfHeader& header) {
  PolarSearch search(header.quantity);
  std::vector<Complex> values(table.rows());
  std::size_t first = 0;
  for (const auto& [pair, of_pair] : columns.pairs()) {
    if (!of_pair.has(re) || !search.may_be()) continue;
    if (first == 0) first = of_pair[re];
    for (std::size_t row = 0; row < values.size(); ++row) values[row] = {table.cell(row, of_pair[re]), table.cell(row, of_pair[im])};
    search.add(values);
  }
  if (const auto finding = search.finding())
    table.fail(table.header_line, first, "the columns hold no real and imaginary parts but " + *finding,
               "name them by what they hold, e.g. 4:+Y/1:+Y mag and 4:+Y/1:+Y phase_deg (or phase_rad)");
  if (auto doubt = search.doubt()) header.doubts.push_back(*doubt + "; if they are, name the columns mag and phase_deg or phase_rad");
}

/// Magnitudes beside real and imaginary parts are theirs.
void require_same_magnitudes(const CsvTable& table, const CsvColumns& columns) {
  constexpr double most = 0.01;
  for (const auto& [pair, of_pair] : columns.pairs()) {
    for (std::size_t row = 0; of_pair.has(re) && of_pair.has(mag) && row < table.rows(); ++row) {
      const double magnitude = table.cell(row, of_pair[mag]);
      const double own = std::hypot(table.cell(row, of_pair[re]), table.cell(row, of_pair[im]));
      if (!(std::abs(magnitude - own) > most * own)) continue;
      table.fail(table.lines[row], of_pair[mag],
                 fmt::format("the magnitude {:g} is not that of the real and imaginary part, {:g}", magnitude, own),
                 "keep the columns that are right");
    }
  }
}

std::vector<double> read_frequency(const CsvTable& table) {
  std::vector<double> axis;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    axis.push_back(table.hz_per_unit * table.cell(row, 0));
    if (std::isnan(axis.back())) table.fail(table.lines[row], 0, "no frequency", "fill or remove the line");
  }
  return axis;
}

}  // namespace

bool looks_like_csv(std::span<const char> head) {
  std::string_view rest(head.data(), head.size());
  if (rest.starts_with("\xFF\xFE") || rest.starts_with("\xFE\xFF") || looks_like_lvm(rest)) return true;  // UTF-16, LabVIEW
  const std::string text = plain_text(std::string(rest));
  rest = text;
  const auto binary = [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\r' && c != '\n'; };
  if (rest.empty() || std::ranges::any_of(rest, binary)) return false;
  const std::string_view lines = rest.substr(0, rest.rfind('\n') + 1);
  if (find_csv_header(rest) || tabs_for_pipes(lines) || without_row_names(lines) || tabs_for_blanks(lines)) return true;
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    const std::size_t start = line.find_first_not_of(" \t\r");
    if (start == std::string_view::npos) continue;
    if (line[start] != '#' && line[start] != '%') return line.starts_with("sep=") || csv_separator(line.substr(start)) != '\0';
    if (rest.empty()) return true;  // nothing but comments as far as we see
  }
  return false;
}

bool names_frfs(std::span<const char> head) {
  const std::string_view text(head.data(), head.size());
  const std::string_view titles = text.substr(0, text.find('\n', std::min(text.find("requency"), text.size())));
  for (std::size_t at = titles.find(':'); at != std::string_view::npos; at = titles.find(':', at + 1)) {
    std::string_view rest = titles.substr(at + 1);
    rest.remove_prefix(std::min(rest.find_first_not_of("+-"), rest.size()));
    rest.remove_prefix(std::min(rest.find_first_not_of("RXYZ"), rest.size()));
    if (rest.starts_with('/') && rest.size() > 1 && rest[1] >= '0' && rest[1] <= '9') return true;
  }
  return false;
}

std::unique_ptr<FrfSource> open_csv(const std::filesystem::path& path, const OpenOptions& options) {
  CsvTable table = read_table(path, options);
  FrfSet set;
  set.header.file = table.file;
  set.header.nodes = read_csv_nodes(table);
  set.header.doubts = table.doubts;
  const CsvColumns columns(table, options, set.header);
  resolve_decibels(table, columns, !options.unit.empty());
  if (!options.unit.empty()) set_unit(table, columns, options.unit);
  set.header.quantity = read_quantity(table, columns, options);
  set.header.frequency_hz = read_frequency(table);
  read_noise_kind(table, columns, set.header);
  validate(set.header);
  doubt_degrees(table, columns, set.header);
  require_radians(table, columns);
  require_parts(table, columns, set.header);
  require_same_magnitudes(table, columns);
  fill(table, columns, set);
  return from_memory(std::move(set));
}

}  // namespace jointid::frf
