#include "frf/uff/uff_catalogue_builder.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/polar/polar_search.hpp"
#include "frf/uff/uff_coherence.hpp"
#include "frf/uff/uff_dofs.hpp"
#include "frf/uff/uff_geometry.hpp"

namespace jointid::frf::uff {
namespace {

/// "3 time response records, dataset 15" for the error of a file without FRFs.
std::string contents(const std::vector<Dataset>& datasets) {
  std::map<std::string, std::size_t> counts;
  for (const Dataset& dataset : datasets) {
    ++counts[dataset.function ? function_name(dataset.function->function_type) : "dataset " + dataset.name()];
  }
  if (counts.empty()) return "no datasets";
  return comma_list(counts, [](const auto& counted) { return std::to_string(counted.second) + " x " + counted.first; });
}

using Spectra = OpenOptions::Spectra;

template <class Wanted>
std::vector<std::size_t> records_of(const std::vector<Dataset>& datasets, int function_type, const Wanted& is_wanted) {
  std::vector<std::size_t> records;
  for (std::size_t i = 0; i < datasets.size(); ++i) {
    const auto& header = datasets[i].function;
    if (header && header->function_type == function_type && is_wanted(*header)) records.push_back(i);
  }
  return records;
}

/// Of motions over forces; where there are none, all, whose errors say what they are.
std::vector<std::size_t> frf_records(const std::vector<Dataset>& datasets) {
  auto records = records_of(datasets, function_frf, may_be_motion_over_force);
  return records.empty() ? records_of(datasets, function_frf, [](const Header58&) { return true; }) : records;
}

/// What is left out: "1 FRF is left out, as it is no motion over a force: 15:+Z/1:+Z (pressure / excitation force)".
void name_others(const std::vector<Dataset>& datasets, std::size_t read, std::vector<std::string>& doubts) {
  constexpr std::size_t shown = 3;
  const auto all = records_of(datasets, function_frf, [](const Header58&) { return true; });
  const auto others =
      records_of(datasets, function_frf, [](const Header58& header) { return !may_be_motion_over_force(header); });
  if (others.empty() || all.size() == read) return;
  std::string text = others.size() == 1
                         ? "1 FRF is left out, as it is no motion over a force: "
                         : std::to_string(others.size()) + " FRFs are left out, as they are no motions over forces: ";
  text += comma_list(std::span(others).first(std::min(shown, others.size())), [&](std::size_t record) {
    const Header58& header = *datasets[record].function;
    const std::string unit = shown_label(header.numerator.unit);
    return header.response.name() + "/" + header.reference.name() + " (" + quantity_in_words(header) +
           (unit.empty() ? "" : ", " + unit) + ")";
  });
  if (others.size() > shown) text += ", …";
  doubts.push_back(text);
}

/// Those of the wanted kind; where a record does not say its kind, it is taken for it.
std::vector<std::size_t> spectra_of(const std::vector<Dataset>& datasets, Spectra wanted) {
  const bool forces = wanted == Spectra::forces;
  return records_of(datasets, function_spectrum,
                    [forces](const Header58& header) { return spectrum_of_forces(header).value_or(forces) == forces; });
}

/// What records of other or unknown types are that look like FRFs: "dataset 58 number 1".
std::string unnamed_frf(const std::vector<Dataset>& datasets) {
  constexpr int general = 0, last_of_format = 28;
  const auto alike = [&](const Dataset& dataset) {
    const auto& header = dataset.function;
    return header && (header->function_type == general || header->function_type > last_of_format) && header->is_complex() &&
           header->abscissa.data_type == type_frequency && may_be_motion_over_force(*header);
  };
  const auto found = std::ranges::find_if(datasets, alike);
  return found == datasets.end() ? std::string() : found->place.dataset;
}

[[noreturn]] void nothing_in(const std::vector<Dataset>& datasets, const std::string& file, Spectra wanted) {
  const bool spectra = wanted != Spectra::none;
  const std::string kind = wanted == Spectra::forces ? "forces" : "motions";
  if (const std::string alike = unnamed_frf(datasets); !alike.empty() && !spectra)
    throw InputError({.kind = ErrorKind::data,
                      .file = file,
                      .place = alike + ", record 6",
                      .problem = "no frequency response functions; the file holds " + contents(datasets),
                      .remedy =
                          "its values are complex, of a motion over a force and over frequencies. If they are FRFs, write 4 "
                          "in columns 1 to 5 of record 6 of each, or export them as function type 4"});
  throw InputError(
      {.kind = ErrorKind::data,
       .file = file,
       .place = {},
       .problem = "no frequency response functions" + (spectra ? " nor spectra of " + kind : "") + "; the file holds " +
                  contents(datasets),
       .remedy = spectra ? "export the spectra of " + kind + " as dataset 58 with function type 12"
                         : "export the FRFs as dataset 58 with function type 4; of time records `jointid frf` makes them"});
}

void require_phases(const Dataset& dataset, bool spectrum) {
  if (dataset.function->is_complex()) return;
  const std::string type = " is real (ordinate type " + std::to_string(dataset.function->ordinate_type) + "): it has no phases";
  dataset.place.fail("record 7", (spectrum ? "the spectrum" : "the FRF") + type,
                     spectrum ? "export complex spectra, of the same trigger for all channels and the force"
                              : "export complex FRFs, real and imaginary part; magnitudes and decibels are not enough");
}

class CatalogueBuilder {
 public:
  CatalogueBuilder(ByteFile& file, const OpenOptions& options) : file_(file), options_(options) {
    header_.file = file.name();
    datasets_ = scan(file);
    if (options.frequency_unit.empty()) return;
    for (Dataset& dataset : datasets_) {
      if (dataset.function) give_axis_unit(*dataset.function);
    }
  }

  Catalogue build() {
    auto records = frf_records(datasets_);
    spectra_ = records.empty() && options_.spectra != Spectra::none;
    if (spectra_) records = spectra_of(datasets_, options_.spectra);
    if (records.empty()) nothing_in(datasets_, file_.name(), options_.spectra);
    if (!spectra_) name_others(datasets_, records.size(), header_.doubts);
    give_dofs(datasets_, records, options_, !spectra_, file_.name());
    catalogue_.first_record = records.front();
    set_axis(datasets_[records.front()]);
    for (const std::size_t record : records) check(record);
    const UnitTable units(file_, datasets_);
    for (const std::size_t record : records) place(record, units.at(datasets_[record]));
    const Ordinate first = interpret(records.front(), units.at(datasets_[records.front()]));
    header_.quantity = first.quantity;
    if (first.stated && *first.stated != first.quantity) header_.changes.push_back(taken_for(first.quantity, *first.stated));
    header_.nodes = read_nodes(file_, datasets_, units);
    const std::string contradiction = units.at(datasets_[records.front()]).contradiction;
    if (!contradiction.empty() && !header_.nodes.empty())
      header_.doubts.push_back(contradiction + ": positions of nodes are read by the factors");
    add_doubts_of_headers();
    if (!spectra_) attach_coherences(file_, catalogue_);
    validate(header_);
    if (!spectra_) require_parts();
    forget_id_lines();
    return std::move(catalogue_);
  }

 private:
  /// What headers state against their numbers, each phrase once with its first record.
  void add_doubts_of_headers() {
    constexpr std::size_t most = 3;
    std::set<std::string_view> known;
    for (const auto& [entry, record] : catalogue_.grid) {
      const Dataset& dataset = datasets_[record.dataset];
      const std::string& doubt = dataset.function->doubt;
      if (doubt.empty() || known.size() == most || !known.insert(doubt).second) continue;
      header_.doubts.push_back(dataset.place.dataset + ": " + doubt);
    }
  }

  /// Of tens of thousands of records that nobody asks for any more they take more memory than all else that is kept of these.
  void forget_id_lines() {
    for (Dataset& dataset : datasets_) {
      if (dataset.function) dataset.function->id = {};
    }
    datasets_.shrink_to_fit();
  }

  /// What the user says stands in place of the label.
  void give_axis_unit(Header58& header) const {
    header.abscissa.unit = options_.frequency_unit;
    if (header.abscissa.data_type == type_rpm) header.abscissa.data_type = type_frequency;
  }

  /// Written with the numbers of the header's axis: nothing is to be compared line by line.
  bool is_axis_of_first(const Header58& header) const {
    const Header58& first = *datasets_[catalogue_.first_record].function;
    return first.even && header.abscissa_first == first.abscissa_first && header.abscissa_step == first.abscissa_step &&
           header.abscissa.data_type == first.abscissa.data_type && header.abscissa.unit == first.abscissa.unit;
  }

  void set_axis(const Dataset& first) {
    require_readable(first);
    require_plausible_size(file_, first);
    const double to_hz = abscissa_to_hz(*first.function, first.place);
    header_.frequency_hz = first.function->even ? even_abscissa(*first.function) : read_points(file_, first).abscissa;
    for (double& line : header_.frequency_hz) line *= to_hz;
  }

  /// Everything about a record that needs no other record's DOFs; collects its DOFs.
  void check(std::size_t index) {
    const Dataset& dataset = datasets_[index];
    const Header58& header = *dataset.function;
    require_readable(dataset);
    require_dofs(dataset, !spectra_);
    require_phases(dataset, spectra_);
    if (header.points != header_.lines()) {
      dataset.place.fail("record 7",
                         std::to_string(header.points) + " points but " + datasets_[catalogue_.first_record].place.dataset +
                             " has " + std::to_string(header_.lines()),
                         "put FRFs with different axes into different files");
    }
    if (header.even && !is_axis_of_first(header)) require_axis(catalogue_, dataset, even_abscissa(header));
    header_.precision = std::max(header_.precision, precision(dataset));
    require_plausible_size(file_, dataset);
    add(header_.response, header.response.dof());
    add(header_.reference, reference_of(header));
  }

  /// Text has the formats E13.5 and E20.12.
  static double precision(const Dataset& dataset) {
    if (dataset.binary) return dataset.function->is_double() ? 0x1p-53 : 0x1p-24;
    return dataset.function->is_double() ? 5e-13 : 5e-6;
  }

  Dof reference_of(const Header58& header) const { return spectra_ ? Dof{} : header.reference.dof(); }

  static void add(std::vector<Dof>& dofs, const Dof& dof) {
    if (!has(dofs, dof)) dofs.push_back(dof);
  }

  Ordinate interpret(std::size_t index, const UnitFactors& factors) const {
    const Dataset& dataset = datasets_[index];
    const auto interpret = spectra_ ? interpret_spectrum : interpret_ordinate;
    return interpret(*dataset.function, factors, {options_.quantity, options_.unit}, dataset.place);
  }

  void place(std::size_t index, const UnitFactors& factors) {
    const Dataset& dataset = datasets_[index];
    const Dof response = dataset.function->response.dof();
    const Dof reference = reference_of(*dataset.function);
    const std::size_t r = find_coordinate(header_.response, response);
    const std::size_t c = find_coordinate(header_.reference, reference);
    const auto [at, is_first] = catalogue_.grid.try_emplace(r * header_.reference.size() + c);
    if (!is_first) {
      dataset.place.fail(
          "record 6",
          (spectra_ ? "the spectrum of " + response.name()
                    : "the FRF of response " + response.name() + " and reference " + reference.name()) +
              " is already in " + datasets_[at->second.dataset].place.dataset,
          spectra_ ? "keep one of the two records; write each force level to a file of its own" : "keep one of the two records");
    }
    const Ordinate ordinate = interpret(index, factors);
    const int sign = response.sign * header_.response[r].sign * reference.sign * header_.reference[c].sign;
    at->second = {.dataset = index, .quantity = ordinate.quantity, .factor = sign * ordinate.to_si, .coherence = npos};
  }

  /// Records are looked at until one has first numbers of both signs, as FRFs have on their first lines, or cannot be read.
  void look_at_parts(PolarSearch& search) {
    constexpr std::uint64_t most_points = std::uint64_t{1} << 18, few = 64;
    std::uint64_t points = 0;
    for (const auto& [entry, record] : catalogue_.grid) {
      const Dataset& dataset = datasets_[record.dataset];
      const std::uint64_t own = dataset.function->points;
      if (!search.may_be() || (points += own) > most_points) return;
      PolarSearch first(header_.quantity);  // asked for signs alone
      if (dataset.binary) first.add(read_points(file_, dataset, 0, std::min(few, own)).values);
      if (!first.may_be()) return;
      search.add(read_points(file_, dataset).values);
    }
  }

  /// A label may be of a plot, but where no first number is below 0.
  void require_no_polar_label(const PolarSearch& search) const {
    if (!search.may_be_magnitudes()) return;
    for (const auto& [entry, record] : catalogue_.grid) {
      const Dataset& dataset = datasets_[record.dataset];
      const std::string& label = dataset.function->polar;
      if (label.empty()) continue;
      dataset.place.fail("header",
                         "'" + shown_label(label) + "' names magnitudes and phases, and no first number of a line is below 0",
                         "export complex FRFs as real and imaginary part; if they are, correct the label");
    }
  }

  void require_parts() {
    PolarSearch search(header_.quantity);
    try {
      look_at_parts(search);
    } catch (const InputError&) {
      return;  // where it is read, if it is
    }
    if (const auto finding = search.finding()) {
      datasets_[catalogue_.first_record].place.fail(
          "data", "the two numbers of a line are no real and imaginary part but " + *finding,
          "export complex FRFs as real and imaginary part, magnitude \u00b7 cos(phase) and magnitude \u00b7 sin(phase)");
    }
    require_no_polar_label(search);
    if (auto doubt = search.doubt()) header_.doubts.push_back(*doubt + "; if they are, export real and imaginary parts");
  }

  ByteFile& file_;
  const OpenOptions& options_;
  bool spectra_ = false;
  Catalogue catalogue_;
  FrfHeader& header_ = catalogue_.header;
  std::vector<Dataset>& datasets_ = catalogue_.datasets;
};

}  // namespace

Catalogue build_catalogue(ByteFile& file, const OpenOptions& options) { return CatalogueBuilder(file, options).build(); }

}  // namespace jointid::frf::uff
