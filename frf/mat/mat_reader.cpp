#include "frf/mat/mat_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/mat/mat_arrays.hpp"
#include "frf/mat/mat_axes.hpp"
#include "frf/mat/mat_beside.hpp"
#include "frf/mat/mat_lookup.hpp"
#include "frf/mat/mat_polar.hpp"
#include "frf/polar/phase_unit.hpp"
#include "frf/polar/polar_search.hpp"
#include "frf/set/line_scale.hpp"
#include "frf/set/merged_set.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "frf/text/located.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 9> unit_names_of_frfs = {
    "unit", "units", "y_values.quantity.label", "y_unit", "yunit", "y_units", "yunits", "ordinate_unit", "ordinate_units"};
constexpr std::array<std::string_view, 4> coherence_names = {"coherence", "coh", "gamma2", "coherences"};
constexpr std::array<std::string_view, 5> averages_names = {"averages", "navg", "n_avg", "num_averages", "number_of_averages"};
constexpr std::string_view factor_name = "y_values.quantity.unit_transformation.factor";

/// One array of FRFs with what stands beside it.
class Reader {
 public:
  /// `element` of `elements` in an array of structs.
  Reader(MatFile& file, const OpenOptions& options, const ComplexArray& frf, std::size_t element, std::size_t elements)
      : file_(file), lookup_(file, scope_of(*frf.values)), options_(options), frf_(frf), element_(element), elements_(elements) {}

  FrfSet read() {
    FrfHeader& header = set_.header;
    header.file = file_.file();
    header.frequency_hz = lookup_.axis(axis_name(), options_.frequency_unit, *frf_.values);
    read_dofs();
    header.quantity = read_quantity();
    if (header.response.empty()) {
      lookup_.fail({}, "does not state at which DOFs " + frf_.name + " was measured",
                   "give the DOFs: --response 4:+Y --reference 1:+Y, in a scene dofs and reference_dofs, or add cell arrays "
                   "response_dof and reference_dof");
    }
    validate(header);
    require_nothing_unread(file_, *frf_.values);
    doubt_numbers_and_axes();
    set_.values = ordered(*frf_.values);
    if (frf_.imaginary != nullptr) add_imaginary(ordered(*frf_.imaginary));
    frf_.phase != nullptr ? turn_magnitudes() : require_parts();
    read_noise();
    to_receptance();
    return std::move(set_);
  }

 private:
  /// The labels of the axes, as the program that wrote the array shows them, else the names of their scales; empty where it states
  /// neither.
  std::vector<std::string> names_of_axes() const {
    std::vector<std::string> names(dims(*frf_.values).size());
    for (const auto& [name, labels] : file_.notes(*frf_.values)) {
      if (name != frf_.values->name + "@DIMENSION_LABELS") continue;
      std::string_view rest = labels;
      for (std::string& each : names) each = take_until(rest, ',');
    }
    const std::vector<std::string> scales = file_.scales(*frf_.values);
    for (std::size_t k = 0; k < std::min(names.size(), scales.size()); ++k) {
      if (names[k].empty()) names[k] = scales[k];
    }
    return names;
  }

  /// The variable along the axis of lines (F), responses (R) or references (C); empty where the file states none.
  std::string scale_of(char axis) const {
    const std::vector<std::string> scales = file_.scales(*frf_.values);
    if (scales.empty()) return {};
    const auto order = order_of_axes(names_of_axes());
    const std::size_t k = order ? order->find(axis) : scales.size();
    return k < scales.size() ? scales[k] : std::string();
  }

  /// Given, or along the axis of lines, where its name or its unit says frequencies; empty where names have to find it.
  std::string axis_name() const {
    if (!options_.frequency_variable.empty()) return options_.frequency_variable;
    std::string scale = scale_of('F');
    for (const std::string& each : file_.scales(*frf_.values)) {
      if (scale.empty() && lookup_.is_axis(each)) scale = each;
    }
    return lookup_.is_axis(scale) ? scale : std::string();
  }

  /// Of one element, or one each of all elements; or elements are a table of responses by references, columns first.
  std::vector<Dof> given(const std::vector<Dof>& dofs, std::size_t needed) const {
    if (elements_ > 1 && dofs.size() == elements_ && needed != dofs.size()) return {dofs[element_]};
    const std::size_t rows = options_.response.size(), columns = options_.reference.size();
    if (elements_ == 1 || rows < 2 || columns < 2 || rows * columns != elements_ || needed != 1) return dofs;
    require_table(rows, columns);
    return {&dofs == &options_.response ? dofs[element_ % rows] : dofs[element_ / rows]};
  }

  void require_table(std::size_t rows, std::size_t columns) const {
    const MatInfo* const all = lookup_.find(frf_.name.substr(0, frf_.name.find('(')));
    if (all == nullptr || all->dims.size() != 2 || all->dims[0] == 1 || all->dims[1] == 1 || all->dims[0] == rows) return;
    lookup_.fail(place_of(all->name),
                 "has " + std::to_string(all->dims[0]) + " rows and " + std::to_string(all->dims[1]) + " columns, and " +
                     std::to_string(rows) + " responses and " + std::to_string(columns) + " references were given",
                 "give one response for each row and one reference for each column");
  }

  void read_dofs() {
    FrfHeader& header = set_.header;
    const std::size_t columns = size(*frf_.values) / std::max<std::size_t>(1, header.lines());
    header.reference = lookup_.dofs(false, given(options_.reference, columns), scale_of('C'));
    const std::size_t references = std::max<std::size_t>(1, header.reference.size());
    header.response = lookup_.dofs(true, given(options_.response, columns / references), scale_of('R'));
    if (header.reference.empty()) header.reference = header.response;
  }

  std::string unit_label() const {
    for (const MatInfo* beside : {frf_.values, static_cast<const MatInfo*>(nullptr)}) {
      for (const std::string_view name : unit_names_of_frfs) {
        if (std::string text = file_.note(beside, name); !text.empty()) return text;
      }
    }
    for (const auto& [name, text] : file_.notes(*frf_.values)) {
      const std::string plain = lower_case(std::string_view(name).substr(name.rfind('@') + 1));
      if (plain == "unit" || plain == "units") return text;
    }
    if (std::string text = lookup_.text(unit_names_of_frfs); !text.empty()) return text;
    return pyuff_unit();
  }

  /// Of the labels that pyuff names as UFF 58 does; the motion and the force have a unit each, SI where only one is stated.
  std::string pyuff_unit() const {
    const std::string motion = text_of("ordinate_axis_units_lab"), force = text_of("orddenom_axis_units_lab");
    if ((motion.empty() && force.empty()) || quantity_of_unit(motion)) return motion;
    const auto quantity = options_.quantity ? options_.quantity : pyuff_quantity();
    if (motion.empty() && !quantity) return "(?)/(" + force + ")";
    constexpr std::array<const char*, 3> si = {"m", "m/s", "m/s^2"};
    return "(" + (motion.empty() ? si[static_cast<std::size_t>(*quantity)] : motion) + ")/(" + (force.empty() ? "N" : force) +
           ")";
  }

  /// By the data types of records 9 and 10.
  std::optional<Quantity> pyuff_quantity() const {
    const double above = lookup_.number("ordinate_spec_data_type"), below = lookup_.number("orddenom_spec_data_type");
    if (below != 13.0 && below != 9.0) return std::nullopt;
    if (above == 8.0) return Quantity::receptance;
    if (above == 11.0) return Quantity::mobility;
    return above == 12.0 ? std::optional(Quantity::accelerance) : std::nullopt;
  }

  /// Of an array named receptance, "Y_mobility" or "accelerance.H".
  std::optional<Quantity> quantity_of_name() const {
    const std::string plain = lower_case(frf_.name);
    std::optional<Quantity> found;
    for (const auto& [word, quantity] : {std::pair{"receptance", Quantity::receptance}, {"mobility", Quantity::mobility},
                                         {"accelerance", Quantity::accelerance}, {"inertance", Quantity::accelerance}}) {
      if (plain.find(word) == std::string::npos) continue;
      if (found && *found != quantity) return std::nullopt;
      found = quantity;
    }
    return found;
  }

  std::string text_of(std::string_view name) const { return lookup_.text(std::span(&name, 1)); }

  Quantity read_quantity() {
    std::string text = file_.note(frf_.values, "quantity");
    if (text.empty()) text = file_.note(nullptr, "quantity");
    if (text.empty()) text = lookup_.text(std::array<std::string_view, 1>{"quantity"});
    if (!text.empty())
      return located(file_.file(), place_of("quantity"), [&] { return parse_quantity(text, options_.quantity); });
    if (options_.quantity) return *options_.quantity;
    if (const auto quantity = quantity_of_unit(unit_label())) return *quantity;
    if (const auto quantity = pyuff_quantity()) return *quantity;
    if (const auto quantity = quantity_of_name()) return *quantity;
    const std::string label = unit_label();
    if (!states_no_unit(label)) {
      const std::string hint = unit_hint(label);
      lookup_.fail(place_of("unit"),
                   "'" + shown_label(label) + "' is no unit of motion over force that is known" + (hint.empty() ? "" : " (" + hint + ")"),
                   "store FRFs of motion over force, with a unit such as 'm/(s^2*N)', 'g/N' or 'mm/N'");
    }
    lookup_.fail({}, "does not state which quantity it holds",
                 "give it: --quantity accelerance, in a scene quantity, or add a text quantity = 'accelerance'");
  }

  /// As the program that wrote the array shows them.
  std::vector<std::size_t> dims(const MatInfo& info) const {
    std::vector<std::size_t> dims = info.dims;
    if (file_.last_index_fastest()) std::ranges::reverse(dims);
    while (dims.size() > 3 && dims.back() == 1) dims.pop_back();
    return dims;
  }

  std::array<std::size_t, 3> extents() const {
    return {set_.header.lines(), set_.header.response.size(), set_.header.reference.size()};
  }

  /// Whether the axes are as long as an order says; columns of responses and references may be one axis.
  bool fits(const MatInfo& info, std::string_view order) const {
    const std::vector<std::size_t> own = dims(info);
    std::array<std::size_t, 3> d = {1, 1, 1};
    if (own.size() > 3) return false;
    std::ranges::copy(own, d.begin());
    const auto [lines, rows, columns] = extents();
    std::array<std::size_t, 3> wanted{};
    for (std::size_t k = 0; k < 3; ++k) wanted[k] = order[k] == 'F' ? lines : order[k] == 'R' ? rows : columns;
    const bool flat = (order == "FRC" && d == std::array{lines, rows * columns, std::size_t{1}}) ||
                      (order == "RCF" && d == std::array{rows * columns, lines, std::size_t{1}});
    return d == wanted || flat;
  }

  /// Of a variable or an attribute; empty where the file states none.
  std::optional<std::string> stated_order() const {
    constexpr std::array<std::string_view, 6> names = {"axes", "dims", "dimensions", "dim_order", "axis_order", "dimord"};
    std::string text = lookup_.joined_text(names);
    for (std::size_t k = 0; k < names.size() && text.empty(); ++k) text = file_.note(frf_.values, names[k]);
    if (text.empty()) return order_of_axes(names_of_axes());
    const auto order = order_of_axes(text);
    if (!order && dims(*frf_.values).size() > 2)
      lookup_.fail(place_of("axes"), "the order of the axes '" + shown_label(text) + "' is not understood",
                   "write axes = 'FRC' (lines, responses, references), or these letters in the order of the array");
    return order;
  }

  /// The order of the axes, as the program that wrote the array shows them.
  std::string order_of(const MatInfo& info) const {
    const FrfHeader& header = set_.header;
    const std::string shown = shape({.name = {}, .dims = dims(info)});
    const std::optional<std::string> stated = stated_order();
    const bool first = fits(info, "FRC"), last = fits(info, "RCF"), known = stated && fits(info, *stated);
    const bool against = stated && !known && dims(info).size() > 2;
    if (against || (!first && !last && !known)) {
      lookup_.fail(place_of(info.name),
                   "is [" + shown + "] where " + std::to_string(header.lines()) + " lines, " +
                       std::to_string(header.response.size()) + " responses and " + std::to_string(header.reference.size()) +
                       " references are expected" + (against ? ", with axes " + *stated : ""),
                   "shape it [F,R,C], [R,C,F] or [F,R*C], add a text such as axes = 'FCR', or give other DOFs");
    }
    const bool columns_open = header.response.size() > 1 && header.reference.size() > 1 && dims(info).size() < 3;
    if (columns_open && file_.last_index_fastest()) {
      lookup_.fail(place_of(info.name), "[" + shown + "] leaves open which column is of which response and reference",
                   "shape it [F,R,C]");
    }
    if (known) return *stated;
    require_known_labels(info, stated);
    require_order_of_name(info);
    if (first && last && header.lines() > 1 && header.entries() > 1) {
      lookup_.fail(place_of(info.name), "[" + shown + "] may be [F,R,C] or [R,C,F]", "add a text axes = 'FRC' or 'RCF'");
    }
    return last ? "RCF" : "FRC";
  }

  /// Labels of axes say which is which, and nobody understood them, where responses and references are as many.
  void require_known_labels(const MatInfo& info, const std::optional<std::string>& stated) const {
    const FrfHeader& header = set_.header;
    const std::vector<std::string> names = names_of_axes();
    const bool labelled = std::ranges::any_of(names, [](const std::string& name) { return !name.empty(); });
    if (stated || !labelled || names.size() != 3 || header.response.size() != header.reference.size() || header.response.size() < 2)
      return;
    lookup_.fail(place_of(info.name),
                 "has axes named " + comma_list(names) + ", which do not state where responses and references are",
                 "name them frequency, response and reference, or add a text axes = 'FRC', in the order of the array");
  }

  /// "H_in_out" of as many responses as references, without a word on its axes.
  void require_order_of_name(const MatInfo& info) const {
    if (set_.header.response.size() != set_.header.reference.size() || set_.header.response.size() < 2) return;
    if (order_of_axes("f_" + info.name.substr(std::min(info.name.find('_') + 1, info.name.size()))) == "FCR")
      lookup_.fail(place_of(info.name), "names references before responses, and the file does not state the order of its axes",
                   "add a text axes = 'FCR' or 'FRC', in the order of the array");
  }

  /// The values of an array in the order [line, response, reference].
  std::vector<Complex> ordered(const MatInfo& info) const {
    const std::array<std::size_t, 3> apart = strides(order_of(info), extents(), file_.last_index_fastest());
    const std::vector<Complex> values = file_.read(info).values;
    const auto [lines, rows, columns] = extents();
    std::vector<Complex> out(values.size());
    for (std::size_t line = 0; line < lines; ++line) {
      for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t c = 0; c < columns; ++c)
          out[set_.index(line, r, c)] = values[apart[0] * line + apart[1] * r + apart[2] * c];
      }
    }
    return out;
  }

  void doubt_numbers_and_axes() {
    FrfHeader& header = set_.header;
    const std::string numbers = numbers_not_applied(file_, *frf_.values, header, options_.frequency_variable);
    if (!numbers.empty()) header.doubts.push_back(numbers);
    const bool square = header.response.size() == header.reference.size() && header.response.size() > 1;
    if (square && header.response != header.reference && dims(*frf_.values).size() > 2 && !stated_order())
      header.doubts.push_back(frf_.name +
                              " does not state whether responses or references come first: responses are taken; a text axes = '" +
                              order_of(*frf_.values) + "' states it");
  }

  void require_parts() {
    PolarSearch search(set_.header.quantity);
    search.add(set_.values, set_.header.entries());
    if (const auto finding = search.finding()) {
      lookup_.fail(place_of(frf_.name), "holds no real and imaginary parts but " + *finding,
                   "store complex numbers, magnitude \u00b7 exp(i \u00b7 phase), or two real arrays " + frf_.name + "_mag and " +
                       frf_.name + "_phase_deg");
    }
    if (auto doubt = search.doubt()) set_.header.doubts.push_back(*doubt + ", in " + frf_.name + "; if they are, store complex numbers");
  }

  /// By the name of the array, or a text beside it; unstated where the file says none.
  AngleUnit stated_phase_unit() const {
    const MatInfo& info = *frf_.phase;
    const std::string own = info.name.substr(scope_of(info).size());
    if (const AngleUnit unit = polar_name(own)->unit; unit != AngleUnit::unstated) return unit;
    std::string label = file_.note(&info, "unit");
    if (label.empty()) label = file_.note(&info, "units");
    const std::array<std::string, 2> names = {own + "_unit", own + "_units"};
    const std::array<std::string_view, 6> texts = {names[0], names[1], "phase_unit", "phase_units", "angle_unit", "angle_units"};
    if (label.empty()) label = lookup_.text(texts);
    if (states_no_unit(label)) return AngleUnit::unstated;
    const AngleUnit unit = angle_unit(label);
    if (unit == AngleUnit::unstated)
      lookup_.fail(place_of(info.name), "the unit '" + shown_label(label) + "' of the phases is not understood", "write deg or rad");
    return unit;
  }

  /// Radians in one unit of the phases.
  double radians_per(const std::vector<Complex>& phases) const {
    PhaseUnit numbers;
    for (std::size_t k = 0; k < set_.header.entries(); ++k) {
      std::vector<double> one;
      for (std::size_t at = k; at < phases.size(); at += set_.header.entries()) one.push_back(phases[at].real());
      numbers.add(one);
    }
    const AngleUnit stated = stated_phase_unit(), found = numbers.unit(), unit = stated == AngleUnit::unstated ? found : stated;
    const std::string& name = frf_.phase->name;
    if (unit == AngleUnit::unstated) {
      lookup_.fail(place_of(name), "does not state whether the phases are in degrees or radians",
                   "name it " + name + "_deg or " + name + "_rad, or add a text phase_unit = 'deg' or 'rad'");
    }
    if (found != AngleUnit::unstated && found != unit) {
      lookup_.fail(place_of(name), std::string("holds phases in ") + (found == AngleUnit::degrees ? "degrees" : "radians") +
                       " by their numbers and in " + (unit == AngleUnit::degrees ? "degrees" : "radians") + " by what is stated",
                   "correct the name or the unit");
    }
    return unit == AngleUnit::degrees ? std::numbers::pi / 180.0 : 1.0;
  }

  void turn_magnitudes() {
    const std::vector<Complex> phases = ordered(*frf_.phase);
    const double radians = radians_per(phases);
    for (std::size_t i = 0; i < set_.values.size(); ++i) {
      const double magnitude = set_.values[i].real(), phase = radians * phases[i].real();
      if (magnitude < 0.0)
        lookup_.fail(place_of(frf_.values->name), fmt::format("the magnitude {:g} is below 0", magnitude),
                     "store magnitudes, not decibels, and turn the phase by 180 degrees where the sign is meant");
      set_.values[i] = magnitude * Complex(std::cos(phase), std::sin(phase));
    }
  }

  void add_imaginary(const std::vector<Complex>& imaginary) {
    for (std::size_t i = 0; i < imaginary.size(); ++i) set_.values[i] = {set_.values[i].real(), imaginary[i].real()};
  }

  void read_noise() {
    const MatInfo& frf = *frf_.values;
    const MatInfo* variance = lookup_.find("variance");
    const MatInfo* coherence = lookup_.find(scope_of(frf).empty() ? Names(coherence_names).first(1) : Names(coherence_names));
    for (const MatInfo* noise : {variance, coherence}) {
      if (noise != nullptr && noise->dims != frf.dims) {
        lookup_.fail(place_of(noise->name), "is [" + shape(*noise) + "] and " + frf.name + " [" + shape(frf) + "]",
                     "shape them alike");
      }
    }
    if (variance != nullptr && coherence != nullptr) {
      lookup_.fail({}, "has both variance and coherence", "keep the one that was measured");
    }
    if (variance != nullptr) read_variance(*variance);
    if (coherence != nullptr) read_coherence(*coherence);
  }

  void read_variance(const MatInfo& info) {
    if (info.kind != MatKind::complex) {
      lookup_.fail(place_of(info.name), "is not complex", "give the variances of real and imaginary part as a complex array");
    }
    set_.header.noise = NoiseRecord::variance;
    set_.variance = ordered(info);
  }

  void read_coherence(const MatInfo& info) {
    if (info.kind != MatKind::real) lookup_.fail(place_of(info.name), "is not real", "give coherences between 0 and 1");
    if (const MatInfo* averages = lookup_.find(averages_names)) set_.header.averages = read_averages(*averages);
    set_.header.noise = NoiseRecord::coherence;
    for (const Complex& value : ordered(info)) set_.coherence.push_back(value.real());
  }

  double read_averages(const MatInfo& info) {
    const bool scalar = info.kind == MatKind::real && size(info) == 1;
    const double value = scalar ? file_.read(info).values.front().real() : 0.0;
    if (!(value >= 1.0)) {
      lookup_.fail(place_of(info.name), "is not a number of averages", "give how many the coherences come from");
    }
    return value;
  }

  /// Units under two names that differ, or hold what is no text and no struct.
  void require_one_unit() const {
    std::string first;
    for (const std::string_view name : unit_names_of_frfs) {
      const MatInfo* info = lookup_.find(name);
      if (info == nullptr) continue;
      const std::string inside = info->name + ".";
      const bool fields =
          std::ranges::any_of(file_.variables(), [&](const MatInfo& each) { return each.name.starts_with(inside); });
      if (info->kind == MatKind::other && !fields && size(*info) > 0)
        lookup_.fail(place_of(info->name), "is no text that can be read", "store the unit as a text");
      const std::string text = lookup_.text(std::span(&name, 1));
      if (!first.empty() && !text.empty() && text != first)
        lookup_.fail(place_of(info->name), "is '" + shown_label(text) + "', and another unit is '" + shown_label(first) + "'",
                     "keep the right one");
      if (!text.empty()) first = text;
    }
  }

  double si_of_file() const {
    const FrfHeader& header = set_.header;
    require_one_unit();
    const std::string label = unit_label();
    if (states_no_unit(label)) {
      require_no_other_unit(file_, *frf_.values);
      return 1.0;
    }
    const double si = located(header.file, place_of("unit"), [&] { return si_factor(label, header); });
    const double stated = lookup_.number(factor_name);
    if (!std::isnan(stated) && std::abs(stated - si) > 1e-3 * std::abs(si)) {
      lookup_.fail(place_of(factor_name),
                   fmt::format("{:g} is not the factor of the unit '{}', which is {:g}", stated, label, si),
                   "export the FRFs in SI units");
    }
    return si;
  }

  void to_receptance() {
    const FrfHeader& header = set_.header;
    const double si = si_of_file();
    for (std::size_t i = 0; i < set_.values.size(); ++i) {
      const LineScale scale = LineScale::to_receptance(header.quantity, si, header.frequency_hz[i / header.entries()]);
      set_.values[i] = scale.value(set_.values[i]);
      if (!set_.variance.empty()) set_.variance[i] = scale.variance(set_.variance[i]);
    }
  }

  MatFile& file_;
  MatLookup lookup_;
  const OpenOptions& options_;
  const ComplexArray& frf_;
  std::size_t element_, elements_;
  FrfSet set_;
};

/// Sets that all have coherences of as many averages, which merged() would make variances of.
bool keep_coherences(const std::vector<FrfSet>& sets) {
  return std::ranges::all_of(sets, [&](const FrfSet& set) {
    return set.header.noise == NoiseRecord::coherence && set.header.averages == sets.front().header.averages;
  });
}

void add_coherences(const std::vector<FrfSet>& sets, FrfSet& out) {
  out.header.noise = NoiseRecord::coherence;
  out.header.averages = sets.front().header.averages;
  out.variance.clear();
  out.coherence.assign(out.values.size(), std::nan(""));
  for (const FrfSet& set : sets) {
    for (std::size_t i = 0; i < set.coherence.size(); ++i) {
      const std::size_t columns = set.header.reference.size(), entry = i % set.header.entries();
      const std::size_t r = find_coordinate(out.header.response, set.header.response[entry / columns]);
      const std::size_t c = find_coordinate(out.header.reference, set.header.reference[entry % columns]);
      out.coherence[out.index(i / set.header.entries(), r, c)] = set.coherence[i];
    }
  }
}

}  // namespace

FrfSet read_mat_frfs(MatFile& file, const OpenOptions& options) {
  const std::vector<ComplexArray> frfs = find_frfs(file, options.variable, options.frequency_variable);
  std::vector<FrfSet> sets;
  for (std::size_t i = 0; i < frfs.size(); ++i) sets.push_back(Reader(file, options, frfs[i], i, frfs.size()).read());
  if (sets.size() == 1) return std::move(sets.front());
  if (!keep_coherences(sets)) return merged(std::move(sets));
  FrfSet out = merged(sets);
  add_coherences(sets, out);
  return out;
}

}  // namespace jointid::frf
