#include "frf/csv/analyser_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "frf/csv/csv_keys.hpp"
#include "frf/csv/csv_remarks.hpp"
#include "frf/csv/csv_titles.hpp"
#include "frf/polar/polar_search.hpp"
#include "frf/set/line_scale.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "frf/text/footer.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/located.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/plain_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

constexpr std::size_t most_label_lines = 60;

/// Without units and names of FRFs in the titles: those are read as CSV.
bool is_heading_row(std::string_view line) {
  const std::string text = lower_case(trimmed(line));
  if (text.find_first_of("[(<|:") != std::string::npos || !text.starts_with("frequency")) return false;
  const std::size_t second = text.find_first_not_of(" \t", text.find('\t'));
  return text.find('\t') != std::string::npos && second != std::string::npos &&
         std::string_view(text).substr(second).starts_with("real");
}

/// Bytes above 127 that begin no UTF-8 character are Latin-1.
std::string as_utf8(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool pair =
        byte >= 0xC2 && byte <= 0xDF && i + 1 < text.size() && (static_cast<unsigned char>(text[i + 1]) & 0xC0U) == 0x80U;
    if (byte < 0x80 || pair) {
      out += text[i];
      if (pair) out += text[++i];
    } else {
      out += static_cast<char>(0xC0U | (byte >> 6U));
      out += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return out;
}

/// "0-Z", "12+X", "12X" or "12:+X".
std::optional<Dof> channel_dof(std::string_view text) {
  std::string label(trimmed(text));
  const std::size_t digits = std::min(label.find_first_not_of("0123456789"), label.size());
  if (digits == 0 || digits == label.size()) return std::nullopt;
  if (label[digits] != ':') label.insert(digits, ":");
  try {
    return Dof::parse(label);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::size_t dof_place(std::vector<Dof>& dofs, const Dof& dof) {
  const auto found = std::ranges::find(dofs, dof);
  if (found != dofs.end()) return static_cast<std::size_t>(found - dofs.begin());
  dofs.push_back(dof);
  return dofs.size() - 1;
}

class AnalyserText {
 public:
  AnalyserText(const std::filesystem::path& path, const OpenOptions& options) : options_(options) {
    set_.header.file = path.string();
    hz_per_unit_ = hertz_per(options.frequency_unit).value_or(1.0);
  }

  FrfSet read(std::string_view rest) {
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    read_labels(rest);
    assign_dofs();
    read_rows(rest);
    read_stated();
    if (set_.header.frequency_hz.empty()) fail({}, "holds no lines of numbers", "export the FRF again");
    validate(set_.header);
    fill();
    require_parts();
    return std::move(set_);
  }

 private:
  using Pair = std::pair<std::size_t, std::size_t>;

  [[noreturn]] void fail(std::string place, std::string problem, std::string remedy) const {
    throw InputError({.kind = ErrorKind::data,
                      .file = set_.header.file,
                      .place = std::move(place),
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  }
  std::string here() const { return "line " + std::to_string(line_); }

  void read_labels(std::string_view& rest) {
    while (!rest.empty()) {
      const std::string_view line = take_until(rest, '\n');
      ++line_;
      if (is_heading_row(line)) return read_headings(line);
      const std::string label = lower_case(line.substr(0, std::min(line.find('\t'), line.size())));
      if (label.find("ref") == std::string::npos || label.find("resp") == std::string::npos) {
        take_label(line);
        continue;
      }
      response_first_ = label.find("resp") < label.find("ref");
      channels_ = split(line, '\t');
    }
    fail({}, "has no row of headings that begins with Frequency", "export frequency, real and imaginary part");
  }

  /// "Units: Ratio" is of any FRF.
  void take_label(std::string_view line) {
    CsvNote note = csv_note(line, line_, '\t');
    if (trimmed(line).empty() || lower_case(note.value) == "ratio") return;
    labels_.push_back(std::move(note));
    remarks_.push_back({line_, as_utf8(trimmed(line))});
  }

  void read_headings(std::string_view line) {
    const std::vector<std::string_view> cells = split(line, '\t');
    for (std::size_t i = 1; i < cells.size(); i += 2) {
      const bool pair =
          i + 1 < cells.size() && lower_case(cells[i]).starts_with("real") && lower_case(cells[i + 1]).starts_with("imag");
      if (!pair)
        fail(here(), "column " + std::to_string(i + 1) + " and the next are not Real and Imaginary",
             "export real and imaginary part");
    }
    frfs_ = cells.size() / 2;
    units_.resize(frfs_);
  }

  void assign_dofs() {
    FrfHeader& header = set_.header;
    if (!options_.response.empty()) {
      header.response = options_.response;
      header.reference = options_.reference.empty() ? options_.response : options_.reference;
      if (header.entries() != frfs_) {
        fail({},
             "holds " + std::to_string(frfs_) + " FRFs, and " + std::to_string(header.response.size()) + " responses and " +
                 std::to_string(header.reference.size()) + " references were given",
             "give a response and a reference for each");
      }
      for (std::size_t k = 0; k < frfs_; ++k) pairs_.emplace_back(k / header.reference.size(), k % header.reference.size());
      return;
    }
    for (std::size_t k = 0; k < frfs_; ++k) pairs_.push_back(channel_pair(k));
  }

  Pair channel_pair(std::size_t k) {
    const std::string_view text = k + 1 < channels_.size() ? channels_[k + 1] : std::string_view();
    const std::size_t colon = text.find(':', text.find_first_of("XYZ"));
    const auto first = channel_dof(text.substr(0, std::min(colon, text.size())));
    const auto second = colon < text.size() ? channel_dof(text.substr(colon + 1)) : std::nullopt;
    if (!first || !second) {
      fail({}, "does not state the DOFs of FRF " + std::to_string(k + 1) + " ('" + as_utf8(text.substr(0, 30)) + "')",
           "give them, e.g. --response 4:-X --reference 1:+X");
    }
    const Dof& response = response_first_ ? *first : *second;
    const Dof reference =
        options_.reference.size() == 1 && frfs_ == 1 ? options_.reference.front() : (response_first_ ? *second : *first);
    return {dof_place(set_.header.response, response), dof_place(set_.header.reference, reference)};
  }

  void read_rows(std::string_view rest) {
    while (!rest.empty()) {
      const std::string_view line = take_until(rest, '\n');
      ++line_;
      if (without_padding(line).empty()) continue;  // an end-of-file byte of DOS, too
      const std::vector<std::string_view> cells = split(line, '\t');
      if (set_.header.frequency_hz.empty() && are_types(cells)) continue;
      if (set_.header.frequency_hz.empty() && is_label(cells)) {
        read_units(cells);
      } else if (is_footer(cells, 2 * frfs_ + 1)) {
        footers_.push_back(csv_note(line, line_, '\t'));
      } else if (footers_.empty()) {
        read_row(cells);
      } else {
        fail("line " + std::to_string(footers_.front().line), "a line of words is between lines of numbers", "remove it");
      }
    }
    read_footers();
  }

  /// A unit below the rows counts as one above them.
  void read_footers() {
    CsvKeys keys;
    std::vector<std::string> units = units_;
    units.insert(units.begin(), "Hz");
    read_csv_notes(footers_, set_.header.file, units, !options_.unit.empty(), keys);
    const auto unit = keys.find("unit");
    if (unit == keys.end()) return;
    for (std::string& own : units_) {
      if (!own.empty() && own != unit->second)
        fail({}, "the unit is '" + own + "' above the numbers and '" + unit->second + "' below them",
             "give --unit, in a scene unit");
      own = unit->second;
    }
  }

  /// What the labels above the headings state of units and factors, where no row of units does.
  void read_stated() {
    CsvKeys keys;
    std::vector<std::string> units = units_;
    units.insert(units.begin(), axis_stated_ ? "Hz" : "");
    const bool given = !options_.unit.empty();
    read_csv_notes(labels_, set_.header.file, units, given, keys);
    const auto unit = keys.find("unit"), axis = keys.find("frequency_unit");
    if (unit != keys.end()) {
      for (std::string& own : units_) own = own.empty() ? unit->second : own;
    }
    if (axis != keys.end() && !axis_stated_ && options_.frequency_unit.empty()) {
      hz_per_unit_ = hertz_per(axis->second).value_or(1.0);
      for (double& line : set_.header.frequency_hz) line *= hz_per_unit_;
    }
    const std::string& stated = units_.front();
    if (stated.empty() && !given) require_no_unit_in_remarks(remarks_, set_.header.file);
    for (const CsvRemark& remark : remarks_) {
      add_doubt(factor_not_applied(remark));
      if (!given) add_doubt(stated.empty() ? sensitivity_stated(remark) : other_unit_stated(remark, stated, hz_per_unit_));
    }
  }

  void add_doubt(std::string doubt) {
    if (!doubt.empty()) set_.header.doubts.push_back(std::move(doubt));
  }

  static bool is_label(const std::vector<std::string_view>& cells) {
    double value = 0.0;
    return !parse_cell(cells[0], true, value) || cells[0].empty();
  }

  void read_units(const std::vector<std::string_view>& cells) {
    const std::string of_axis = lower_case(cells[0]);
    if (of_axis.empty() || of_axis.starts_with("units")) return;
    axis_stated_ = true;
    if (options_.frequency_unit.empty())
      hz_per_unit_ = located(set_.header.file, here(), [&] { return hertz_per(cells[0]).value_or(1.0); });
    for (std::size_t k = 0; k < frfs_ && 2 * k + 1 < cells.size(); ++k) units_[k] = as_ratio(as_utf8(cells[2 * k + 1]));
  }

  void read_row(const std::vector<std::string_view>& cells) {
    if (cells.size() < 2 * frfs_ + 1) {
      fail(here(), "has " + std::to_string(cells.size()) + " cells, the headings " + std::to_string(2 * frfs_ + 1),
           "export the FRF again");
    }
    for (std::size_t i = 0; i < 2 * frfs_ + 1; ++i) {
      double value = 0.0;
      if (!parse_cell(cells[i], true, value) || (i == 0 && std::isnan(value))) {
        fail(here() + ", column " + std::to_string(i + 1), "'" + as_utf8(cells[i].substr(0, 30)) + "' is not a number",
             "export the FRF again");
      }
      i == 0 ? set_.header.frequency_hz.push_back(hz_per_unit_ * value) : cells_.push_back(value);
    }
  }

  /// The quantity that the units are of, and their factors to SI.
  std::vector<double> si_factors() {
    if (!options_.unit.empty()) units_.assign(frfs_, options_.unit);
    if (std::ranges::all_of(units_, [](const std::string& unit) { return unit.empty(); })) {
      if (!options_.quantity) fail({}, "does not state which quantity it holds", "name it, e.g. --quantity accelerance");
      set_.header.quantity = *options_.quantity;
      return std::vector<double>(frfs_, 1.0);
    }
    set_.header.quantity = quantity_of_unit(units_.front()).value_or(Quantity::accelerance);
    std::vector<double> factors;
    for (std::size_t k = 0; k < units_.size(); ++k) {
      const bool given = !options_.unit.empty();
      factors.push_back(located(set_.header.file, "units", [&] {
        return given ? si_factor(units_[k], set_.header) : si_factor(units_[k], set_.header, pairs_[k].first, pairs_[k].second);
      }));
    }
    return factors;
  }

  void fill() {
    const std::vector<double> factors = si_factors();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    set_.values.assign(set_.header.lines() * set_.header.entries(), {nan, nan});
    for (std::size_t line = 0; line < set_.header.lines(); ++line) {
      for (std::size_t k = 0; k < frfs_; ++k) {
        const LineScale scale = LineScale::to_receptance(set_.header.quantity, factors[k], set_.header.frequency_hz[line]);
        const double* cell = cells_.data() + (line * frfs_ + k) * 2;
        const bool measured = !std::isnan(cell[0]) && !std::isnan(cell[1]);
        if (measured) set_.values[set_.index(line, pairs_[k].first, pairs_[k].second)] = scale.value({cell[0], cell[1]});
      }
    }
  }

  void require_parts() {
    PolarSearch search(set_.header.quantity);
    std::vector<Complex> values(cells_.size() / 2);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = {cells_[2 * i], cells_[2 * i + 1]};
    search.add(values, frfs_);
    if (const auto finding = search.finding())
      fail({}, "the columns Real and Imaginary hold " + *finding, "export real and imaginary part");
    if (auto doubt = search.doubt()) set_.header.doubts.push_back(*doubt + "; if they are, export real and imaginary part");
  }

  const OpenOptions& options_;
  FrfSet set_;
  std::size_t line_ = 0, frfs_ = 0;
  double hz_per_unit_ = 1.0;
  bool response_first_ = false, axis_stated_ = false;
  std::vector<std::string_view> channels_;
  std::vector<std::string> units_;
  std::vector<CsvNote> labels_, footers_;
  std::vector<CsvRemark> remarks_;
  std::vector<Pair> pairs_;
  std::vector<double> cells_;  ///< [line, FRF, 2]
};

}  // namespace

bool looks_like_analyser_text(std::span<const char> head) {
  const std::string text = plain_text(std::string(head.data(), head.size()));
  std::string_view rest = text;
  if (rest.find('\0') != std::string_view::npos) return false;
  for (std::size_t line = 0; line < most_label_lines && !rest.empty(); ++line) {
    if (is_heading_row(take_until(rest, '\n'))) return true;
  }
  return false;
}

std::unique_ptr<FrfSource> open_analyser_text(const std::filesystem::path& path, const OpenOptions& options) {
  const std::string text = read_plain_text(path);
  return from_memory(AnalyserText(path, options).read(text));
}

}  // namespace jointid::frf
