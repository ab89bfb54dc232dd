#include "frf/csv/csv_columns.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "frf/csv/csv_functions.hpp"
#include "frf/csv/csv_numbered.hpp"
#include "frf/polar/phase_unit.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/located.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/proposed_dof.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

using enum CsvPart;

/// The FRF and its part of a title: "4:+Y/1:+Y re", "Real H1" or "Re(H1)".
struct Title {
  std::string_view label, part;
};

Title title_of(std::string_view name) {
  const std::size_t last = name.rfind(' '), first = name.find(' '), open = name.find('(');
  if (last == std::string_view::npos && open != std::string_view::npos && name.ends_with(')'))
    return {name.substr(open + 1, name.size() - open - 2), name.substr(0, open)};
  if (last == std::string_view::npos) return {{}, name};
  const bool leads = !is_csv_part(name.substr(last + 1)) && is_csv_part(name.substr(0, first));
  return leads ? Title{trimmed(name.substr(first)), name.substr(0, first)} : Title{name.substr(0, last), name.substr(last + 1)};
}

/// "H1", "AI 1/AI 2": a name of another program, of which the options say what it is; "2X/1X" is a slip of the pen. "1Z:1Z" where
/// they say that of one FRF.
bool is_foreign(std::string_view label, bool one) {
  const bool pair = label.find('/') != std::string_view::npos && !label.empty() && label.front() >= '0' && label.front() <= '9';
  const bool open = one || label.find('/') == std::string_view::npos;
  return (label.find(':') == std::string_view::npos || (open && !says_direction(label))) && !pair;
}

/// "1X+/2X+", "FRF plate:1:+X/plate:2:+X": DOFs as others write them.
bool is_misspelt(std::string_view label) {
  const std::size_t slash = label.find('/');
  if (slash == std::string_view::npos) return false;
  const auto is_dof = [](std::string_view text) {
    try {
      Dof::parse(text);
    } catch (const InputError&) {
      return false;
    }
    return true;
  };
  return !is_dof(label.substr(0, slash)) || !is_dof(label.substr(slash + 1));
}

constexpr std::size_t most_csv_columns = 100'000;

/// Places of DOFs in a list that grows, by coordinate and sign.
using Places = std::map<std::pair<std::int64_t, int>, std::size_t>;

std::size_t index_of(std::vector<Dof>& dofs, const Dof& dof, Places& places) {
  const auto [found, is_new] = places.try_emplace({coordinate_key(dof), dof.sign}, dofs.size());
  if (is_new) dofs.push_back(dof);
  return found->second;
}

/// Reads the header row column by column.
class HeaderRow {
 public:
  HeaderRow(const CsvTable& table, const OpenOptions& options, FrfHeader& header)
      : table_(table), options_(options), header_(header) {}

  CsvColumns::Pairs read() {
    if (table_.columns.empty()) fail(0, "no header row", "begin it with frequency_hz");
    if (table_.columns.size() == 1) fail(0, "no column but the frequency", "add columns of FRFs");
    if (table_.columns.size() > most_csv_columns) {
      fail(most_csv_columns,
           std::to_string(table_.columns.size()) + " columns are more than the " + std::to_string(most_csv_columns) +
               " that are read",
           "write the FRFs to several files, or as HDF5; are rows and columns exchanged?");
    }
    for (std::size_t column = 1; column < table_.columns.size(); ++column) add(column);
    if (header_.entries() > 4 * table_.columns.size() + 10'000) {
      fail(0,
           std::to_string(table_.columns.size()) + " columns name " + std::to_string(header_.response.size()) +
               " responses and " + std::to_string(header_.reference.size()) + " references, whose FRFs are mostly not there",
           "write the FRFs of each group of references to a file of its own");
    }
    for (const auto& [pair, columns] : pairs_) require_complete(pair, columns);
    if (!named_) place_by_labels();
    if (named_) require_given(options_.response, header_.response), require_given(options_.reference, header_.reference);
    return std::move(pairs_);
  }

 private:
  using Pair = std::pair<std::size_t, std::size_t>;

  [[noreturn]] void fail(std::size_t column, std::string problem, std::string remedy) const {
    table_.fail(table_.header_line, column, std::move(problem), std::move(remedy));
  }

  void add(std::size_t column) {
    const std::string& name = table_.columns[column];
    const auto [own, word] = title_of(name);
    const std::string dofs = dofs_in(own);
    const std::string_view label = dofs.empty() ? own : dofs;
    const bool one = options_.response.size() == 1 && options_.reference.size() < 2;
    const bool named = !label.empty() && (options_.response.empty() || (!is_foreign(label, one) && !is_misspelt(label)));
    require_frf_itself(column, own);
    const CsvPart part = parse_part(column, word);
    if (column > 1 && named != named_) fail(column, "columns with and without DOFs", "name all of them or none");
    named_ = named;
    if (!named) labels_[part].emplace_back(label);
    const Pair pair = named ? named_pair(column, label) : unnamed_pair(column, part);
    if (!named) require_order(column, label, pair);
    if (pairs_[pair].has(part)) fail(column, "'" + name + "' is there twice", "remove one");
    pairs_[pair][part] = column;
  }

  /// Not its conjugate or inverse, "Im(conj(H11))".
  void require_frf_itself(std::size_t column, std::string_view label) const {
    const std::string_view other = other_function(label);
    const std::string_view quantity = other_quantity(label);
    if (!quantity.empty())
      fail(column,
           "'" + table_.columns[column] + "' is " + std::string(quantity) + " by its title, and no FRF of motion over force",
           "export motion over force; if it is, rename the column");
    if (!other.empty())
      fail(column, "'" + table_.columns[column] + "' is of " + std::string(other) + " of an FRF",
           "export the FRF itself, motion over force");
  }

  CsvPart parse_part(std::size_t column, std::string_view word) const {
    const std::string& unit = table_.units[column];
    std::optional<CsvPart> part = csv_part(word);
    if (lower_case(word) == "phase") part = phase_part(column, unit);
    if (!part) {
      fail(column, "'" + table_.columns[column] + "' is not a column of an FRF",
           "write response/reference and re, im, mag, phase_deg, phase_rad, var_re, var_im or coherence, e.g. 4:+Y/1:+Y "
           "re");
    }
    require_unit_of(column, *part, unit);
    return *part;
  }

  /// Grad are gon in other languages.
  bool is_german_degree(std::string_view plain) const { return plain == "grad" && lower_case(table_.columns[0]) == "frequenz"; }

  CsvPart phase_part(std::size_t column, const std::string& unit) const {
    const std::string plain = lower_case(plain_label(unit));
    if (is_degrees(plain) || is_degrees(unit) || is_german_degree(plain)) return phase_deg;
    if (is_radians(plain)) return phase_rad;
    if (!states_no_unit(unit))
      fail(column,
           "the unit '" + shown_label(unit) + "' of '" + table_.columns[column] + "' is not read" +
               (plain == "grad" ? ": it may be degrees or gon" : ""),
           "export degrees [deg] or radians [rad]");
    const AngleUnit by_numbers = unit_by_numbers();
    if (by_numbers != AngleUnit::unstated) return by_numbers == AngleUnit::degrees ? phase_deg : phase_rad;
    fail(column,
         "'" + table_.columns[column] + "' does not state whether it is in degrees or radians, and its numbers may be either",
         "name it phase_deg or phase_rad");
  }

  /// Of all phases without a unit.
  AngleUnit unit_by_numbers() const {
    PhaseUnit numbers;
    std::vector<double> phases(table_.rows());
    for (std::size_t column = 1; column < table_.columns.size(); ++column) {
      if (lower_case(title_of(table_.columns[column]).part) != "phase" || !states_no_unit(table_.units[column])) continue;
      for (std::size_t row = 0; row < phases.size(); ++row) phases[row] = table_.cell(row, column);
      numbers.add(phases);
    }
    return numbers.unit();
  }

  /// What the SI factor of the FRF does not look at.
  void require_unit_of(std::size_t column, CsvPart part, const std::string& unit) const {
    const std::string plain = lower_case(plain_label(unit));
    const bool right = part == phase_deg   ? is_degrees(plain) || is_german_degree(plain)
                       : part == phase_rad ? is_radians(plain)
                                           : plain == "1";
    const bool scaled = part == re || part == im || part == mag;
    if (scaled || right || states_no_unit(unit) || unit == "-") return;
    const bool variance = part == var_re || part == var_im;
    table_.fail(table_.units_line, column,
                "a column " + std::string(csv_part_names[static_cast<std::size_t>(part)]) + " in '" + shown_label(unit) +
                    "' is not understood",
                variance ? "leave the unit out: variances are in that of the FRFs, squared"
                         : "leave the unit out, or export it in that of its name");
  }

  void require_given(const std::vector<Dof>& given, const std::vector<Dof>& own) const {
    if (given.empty() || given == own) return;
    fail(0, "the columns name their DOFs, " + comma_list(names(own)) + ", and others are given",
         "leave out the DOFs that are given (--response, --reference, in a scene dofs), or the DOFs of the columns");
  }

  static Dof parse_own(std::string_view text) {
    try {
      return Dof::parse(text);
    } catch (const InputError& error) {
      InputError::Parts parts = error.parts();
      parts.remedy += ", or give the DOFs of the columns: --response 4:+Y --reference 1:+Y, in a scene dofs and reference_dofs";
      throw InputError(std::move(parts));
    }
  }

  Pair named_pair(std::size_t column, std::string_view label) {
    const std::size_t slash = label.find('/');
    if (slash == std::string_view::npos) {
      fail(column, "'" + std::string(label) + "' is not response/reference",
           "write e.g. 4:+Y/1:+Y re, or give the DOFs: --response 4:+Y --reference 1:+Y, in a scene dofs and reference_dofs");
    }
    const auto parse = [&](std::string_view text) {
      return located(table_.file, table_.place(table_.header_line, column), [&] { return parse_own(text); });
    };
    const Dof response = parse(label.substr(0, slash));
    const Dof reference = parse(label.substr(slash + 1));
    return {index_of(header_.response, response, responses_), index_of(header_.reference, reference, references_)};
  }

  /// The n-th column of a part belongs to the n-th pair of the options' DOFs.
  Pair unnamed_pair(std::size_t column, CsvPart part) {
    const std::size_t pair = unnamed_[part]++;
    if (header_.response.empty()) {
      header_.response = options_.response;
      header_.reference = options_.reference.empty() ? options_.response : options_.reference;
    }
    if (pair >= header_.entries()) {
      fail(column,
           "'" + table_.columns[column] + "' has no DOFs, and " + std::to_string(header_.response.size()) + " responses and " +
               std::to_string(header_.reference.size()) + " references were given",
           "write e.g. 4:+Y/1:+Y re, or give the DOFs: --response 4:+Y --reference 1:+Y, in a scene dofs and reference_dofs");
    }
    return {pair / header_.reference.size(), pair % header_.reference.size()};
  }

  /// A label that names DOFs as others write them names those that are given at its place.
  void require_order(std::size_t column, std::string_view label, const Pair& pair) const {
    const std::size_t slash = label.find('/') != std::string_view::npos ? label.find('/') : label.rfind(' ');
    if (slash == std::string_view::npos) return;
    const bool blank = label[slash] == ' ';  // "FRF 2Z 1Z"
    if (blank && (proposed_dof(label.substr(0, slash)).empty() || proposed_dof(label.substr(slash + 1)).empty())) return;
    const auto require = [&](const std::vector<Dof>& given, std::size_t at, std::string_view text) {
      const std::string meant = proposed_dof(text);
      if (meant.empty() || given[at].name() == meant) return;
      fail(column,
           "'" + table_.columns[column] + "' is of " + meant + " by its title, and " + given[at].name() + " was given for it",
           has_name(given, meant) ? "give the DOFs in the order of the columns" : "give " + meant + ", which a scene may rename");
    };
    require(header_.response, pair.first, label.substr(0, slash));
    require(header_.reference, pair.second, label.substr(slash + 1));
  }

  static bool has_name(const std::vector<Dof>& dofs, const std::string& name) {
    return std::ranges::any_of(dofs, [&](const Dof& dof) { return dof.name() == name; });
  }

  /// "Re(H21)", "Re(H12)" are of the FRFs that their numbers say.
  void place_by_labels() {
    require_same_order(re, im);
    require_same_order(mag, labels_[phase_deg].empty() ? phase_rad : phase_deg);
    const std::vector<std::string>& labels = labels_[re].empty() ? labels_[mag] : labels_[re];
    const auto places = places_of_labels(labels, header_.response, header_.reference);
    if (places.size() != labels.size()) return require_all_given();
    CsvColumns::Pairs placed;
    for (const auto& [pair, columns] : pairs_) {
      const std::size_t k = pair.first * header_.reference.size() + pair.second;
      if (k >= places.size() || !places[k])
        fail(columns.has(re) ? columns[re] : columns[mag],
             "the titles " + labels.front() + " … " + labels.back() +
                 " do not state which FRF is of which of the DOFs that are given",
             "name the columns by DOFs, e.g. 2:+Z/1:+Z re, or write them response by response");
      placed[*places[k]] = columns;
    }
    pairs_ = std::move(placed);
  }

  /// Columns in the order of the DOFs are as many as these.
  void require_all_given() const {
    if (pairs_.size() >= header_.entries()) return;
    fail(0,
         "the columns hold " + std::to_string(pairs_.size()) + " FRFs, and " + std::to_string(header_.response.size()) +
             " responses and " + std::to_string(header_.reference.size()) + " references " +
             (options_.reference.empty() ? "(the responses) " : "") + "were given, which are " +
             std::to_string(header_.entries()),
         "give as many: --response 4:+Y --reference 1:+Y, in a scene dofs and reference_dofs, or name the columns, e.g. "
         "4:+Y/1:+Y re");
  }

  /// Two parts of one FRF stand at the same place of both.
  void require_same_order(CsvPart first, CsvPart second) {
    const std::vector<std::string>&a = labels_[first], &b = labels_[second];
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
      if (a[k] == b[k] || std::ranges::find(b, a[k]) == b.end()) continue;
      fail(0, "the parts of " + a[k] + " and " + b[k] + " are in different orders",
           "write the columns of both parts in one order");
    }
  }

  void require_complete(const Pair& pair, const CsvColumns::OfPair& columns) const {
    const auto both = [&](CsvPart a, CsvPart b) { return columns.has(a) && columns.has(b); };
    const auto half = [&](CsvPart a, CsvPart b) { return columns.has(a) != columns.has(b); };
    const bool phase = columns.has(phase_deg) != columns.has(phase_rad);
    const bool two_phases = both(phase_deg, phase_rad);
    const bool polar = columns.has(mag) && phase, half_polar = columns.has(mag) != (phase || two_phases);
    if ((both(re, im) || polar) && !half(re, im) && !half_polar && !two_phases && !half(var_re, var_im)) return;
    const std::string name = header_.response[pair.first].name() + "/" + header_.reference[pair.second].name();
    fail(0, "the columns of " + name + " are no complete FRF",
         "give re and im, or mag and phase_deg (or phase_rad), and var_re with var_im");
  }

  const CsvTable& table_;
  const OpenOptions& options_;
  FrfHeader& header_;
  CsvColumns::Pairs pairs_;
  Places responses_, references_;
  std::map<CsvPart, std::vector<std::string>> labels_;  ///< of columns without DOFs
  CsvColumns::OfPair unnamed_;                          ///< columns without DOFs seen so far, by part
  bool named_ = false;
};

}  // namespace

CsvColumns::CsvColumns(const CsvTable& table, const OpenOptions& options, FrfHeader& header)
    : table_(table), pairs_(HeaderRow(table, options, header).read()) {}

bool CsvColumns::has(CsvPart part) const {
  return std::ranges::any_of(pairs_, [&](const auto& pair) { return pair.second.has(part); });
}

const std::string& CsvColumns::unit(const OfPair& pair, std::size_t& column) const {
  static const std::string none;
  column = 0;
  for (const CsvPart part : {re, im, mag}) {
    const std::size_t own = pair[part];
    if (own == 0 || states_no_unit(table_.units[own])) continue;
    if (column != 0 && table_.units[own] != table_.units[column])
      table_.fail(table_.units_line, own,
                  "the parts of one FRF have different units, '" + shown_label(table_.units[column]) + "' and '" +
                      shown_label(table_.units[own]) + "'",
                  "export them alike");
    if (column == 0) column = own;
  }
  return column == 0 ? none : table_.units[column];
}

}  // namespace jointid::frf
