#include "frf/mat/mat_lookup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/text/direction_names.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/located.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

using Names = std::span<const std::string_view>;

/// In this order; x (pyuff) only of a struct.
constexpr std::array<std::string_view, 17> axis_names = {"frequency_hz",
                                                         "frequency",
                                                         "freq",
                                                         "f",
                                                         "freq_hz",
                                                         "frequencies",
                                                         "freq_domain",
                                                         "w",
                                                         "omega",
                                                         "freqs",
                                                         "frequency_axis",
                                                         "freq_axis",
                                                         "freq_vector",
                                                         "frequency_vector",
                                                         "x_values.values",
                                                         "abscissa",
                                                         "x"};
constexpr std::array<std::string_view, 16> axis_unit_names = {
    "frequency_unit",          "freq_unit", "frequency_units", "freq_units",    "x_values.quantity.label",
    "abscissa_axis_units_lab", "freqUnit",  "freqUnits",       "frequencyUnit", "frequencyUnits",
    "x_unit",                  "xunit",     "x_units",         "xunits",        "abscissa_unit",
    "abscissa_units"};
constexpr double from_rad_per_s = 0.5 / std::numbers::pi;
constexpr double longest_axis = 1e8;

/// Names that jointid writes, then those of others.
constexpr std::array<std::string_view, 10> response_names = {"response_dof", "resp_dof", "response_dofs", "rsp_dof", "output_dof",
                                                             "resp",         "response", "responses",     "dofs",    "dof"};
constexpr std::array<std::string_view, 10> reference_names = {
    "reference_dof", "ref_dof", "reference_dofs", "input_dof", "ref", "reference", "references", "excitation", "dofs", "dof"};

constexpr std::array<std::string_view, 5> response_nodes = {"rsp_node", "respNode", "resp_node", "rspNode", "response_node"};
constexpr std::array<std::string_view, 5> response_directions = {"rsp_dir", "respDir", "resp_dir", "rspDir", "response_dir"};
constexpr std::array<std::string_view, 4> reference_nodes = {"ref_node", "refNode", "reference_node", "input_node"};
constexpr std::array<std::string_view, 4> reference_directions = {"ref_dir", "refDir", "reference_dir", "input_dir"};

bool is_vector(const MatInfo& info) {
  return info.kind == MatKind::real && std::ranges::count_if(info.dims, [](std::size_t n) { return n != 1; }) <= 1;
}

char lower_letter(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// "fHz", "freq_khz", "FreqVec", "Frequenz", "omega_rad_s": words for an axis that axis_names do not list.
bool says_frequencies(std::string_view name) {
  constexpr std::array<std::string_view, 9> stems = {"frequencies", "frequency", "frequenzen", "frequenz", "frecuencia",
                                                     "frequence",   "frequenza", "freqs",      "freq"};
  constexpr std::array<std::string_view, 14> endings = {"",     "hz",   "khz",  "vec",   "vector", "axis",  "rads",
                                                        "rad",  "rpm",  "inhz", "inkhz", "values", "data",  "list"};
  constexpr std::array<std::string_view, 4> angular = {"rads", "rad", "radps", "radpers"};
  std::string plain = lower_case(name);
  std::erase(plain, '_');
  const auto is = [](std::string_view word, const auto& words) { return std::ranges::find(words, word) != words.end(); };
  for (const std::string_view stem : stems) {
    if (plain.starts_with(stem)) return is(std::string_view(plain).substr(stem.size()), endings);
  }
  for (const std::string_view stem : {"omega", "w"}) {
    if (plain.starts_with(stem)) return is(std::string_view(plain).substr(stem.size()), angular);
  }
  const bool force = name.starts_with('F') && !plain.ends_with("hz");
  return plain.size() > 1 && plain.front() == 'f' && !force && is(std::string_view(plain).substr(1), endings);
}

/// Of "freq_khz", "w_rad", "rpm"; 1 where a name says no unit.
double hz_of_name(std::string_view name) {
  const std::string plain = lower_case(name);
  for (const char* word : {"rad", "ang", "circ", "pulsat", "kreis"}) {
    if (plain.find(word) != std::string::npos) return from_rad_per_s;
  }
  if (name.ends_with("mHz")) return 1e-3;
  if (plain.ends_with("khz")) return 1000.0;
  return plain.ends_with("rpm") || plain.ends_with("cpm") ? 1.0 / 60.0 : 1.0;
}

/// Whether a label is a unit of frequencies of other than so many hertz.
bool is_other(std::string_view label, double hertz) {
  if (!parse_unit(label)) return false;
  try {
    return std::abs(hertz_per(label).value_or(hertz) - hertz) > 1e-9 * hertz;
  } catch (const InputError&) {
    return false;
  }
}

std::string trimmed_end(std::string text) {
  text.resize(text.find_last_not_of(" \t\r\n") + 1);  // rows of characters are padded with blanks
  return text;
}

/// "+X" of 1, "-RZ" of −6, the codes of UFF 58.
std::string direction_text(double code) {
  const double size = std::abs(code);
  if (size != std::floor(size) || size < 1.0 || size > 6.0) return fmt::format("{:g}", code);
  return (code < 0.0 ? "-" : "+") + std::string(direction_names[static_cast<std::size_t>(size) - 1]);
}

}  // namespace

std::string place_of(std::string_view name) { return "variable " + std::string(name); }

std::string shape(const MatInfo& info) {
  std::string text;
  for (const std::size_t extent : info.dims) text += (text.empty() ? "" : "x") + std::to_string(extent);
  return text;
}

std::size_t size(const MatInfo& info) {
  return std::accumulate(info.dims.begin(), info.dims.end(), std::size_t{1}, std::multiplies<>());
}

bool same_name(std::string_view a, std::string_view b) {
  if (a.size() == 1) return a == b;
  return std::ranges::equal(a, b, {}, lower_letter, lower_letter);
}

std::string scope_of(const MatInfo& info) {
  const std::size_t dot = info.name.rfind('.');
  return dot == std::string::npos ? std::string() : info.name.substr(0, dot + 1);
}

std::string listed(const MatFile& file, const std::vector<const MatInfo*>& infos) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, infos.size()); ++i) {
    MatInfo shown = *infos[i];
    if (file.last_index_fastest()) std::ranges::reverse(shown.dims);
    text += (text.empty() ? "" : ", ") + shown.name + " [" + shape(shown) + "]";
  }
  if (infos.size() > most) text += fmt::format(" and {} more", infos.size() - most);
  return text.empty() ? "none" : text;
}

MatLookup::MatLookup(MatFile& file, const std::string& scope) : file_(file) {
  for (std::string rest = scope; !rest.empty();) {
    scopes_.push_back(rest);
    const std::size_t dot = rest.size() < 2 ? std::string::npos : rest.rfind('.', rest.size() - 2);
    rest.resize(dot == std::string::npos ? 0 : dot + 1);
  }
  scopes_.emplace_back();
}

const MatInfo* MatLookup::of_scope(const std::string& scope, std::string_view name) const {
  const auto [begin, end] = file_.by_lower_name().equal_range(lower_case(scope + std::string(name)));
  const auto found = std::find_if(begin, end, [&](const auto& each) {
    const std::string& own = each.second->name;
    return own.starts_with(scope) && same_name(std::string_view(own).substr(scope.size()), name);
  });
  return found == end ? nullptr : found->second;
}

const MatInfo* MatLookup::find(Names names) const {
  for (const std::string& scope : scopes_) {
    for (const std::string_view name : names) {
      if (const MatInfo* found = of_scope(scope, name)) return found;
    }
  }
  return nullptr;
}

std::vector<double> MatLookup::numbers(const MatInfo& info) const {
  std::vector<double> values;
  for (const Complex& value : file_.read(info).values) values.push_back(value.real());
  return values;
}

const MatInfo* MatLookup::axis_by_name() const {
  for (const std::string& scope : scopes_) {
    for (const std::string_view name : axis_names) {
      const MatInfo* found = scope.empty() && name == "x" ? nullptr : of_scope(scope, name);
      if (found != nullptr && is_vector(*found)) return found;
    }
  }
  return axis_by_words();
}

/// The only one of the innermost struct that has one.
const MatInfo* MatLookup::axis_by_words() const {
  for (const std::string& scope : scopes_) {
    std::vector<const MatInfo*> found;
    for (const MatInfo& info : file_.variables()) {
      if (scope_of(info) == scope && is_vector(info) && size(info) > 1 && says_frequencies(info.name.substr(scope.size())))
        found.push_back(&info);
    }
    if (!found.empty()) return found.size() == 1 ? found.front() : nullptr;
  }
  return nullptr;
}

bool MatLookup::is_axis(const std::string& variable) const {
  const MatInfo* info = variable.empty() ? nullptr : find(variable);
  if (info == nullptr || !is_vector(*info)) return false;
  const std::string_view own = std::string_view(info->name).substr(scope_of(*info).size());
  const bool known = std::ranges::any_of(axis_names, [&](std::string_view name) { return name != "x" && same_name(own, name); });
  if (known || says_frequencies(own)) return true;
  const std::string unit = file_.note(info, "unit"), units = file_.note(info, "units");
  const std::string& label = unit.empty() ? units : unit;
  return !states_no_unit(label) && is_other(label, 0.0);
}

const MatInfo& MatLookup::named_axis(const std::string& variable) const {
  const MatInfo* info = find(variable);
  if (info == nullptr) fail({}, "has no variable " + variable + " for the frequencies", "name a real vector of the file");
  if (!is_vector(*info))
    fail(place_of(variable), "is no real vector of frequencies", "name the variable that holds the frequencies");
  return *info;
}

/// By a text beside it, else by its name.
double MatLookup::hz_per_unit(const MatInfo& axis) const {
  std::string label = file_.note(&axis, "unit");
  if (label.empty()) label = file_.note(&axis, "units");
  if (label.empty()) label = text(axis_unit_names);
  const std::string_view own = std::string_view(axis.name).substr(scope_of(axis).size());
  const bool omega = own == "w" || own == "W" || same_name(own, "om") || same_name(own, "omega");
  if (label.empty()) {
    const double by_name = omega ? from_rad_per_s : hz_of_name(own);
    require_no_other_label(axis, by_name);
    return by_name;
  }
  const double factor = located(file_.file(), place_of(axis.name), [&] { return hertz_per(label).value_or(1.0); });
  if (omega && factor == 1.0) {
    fail(place_of(axis.name), "is an angular frequency by its name and in '" + label + "' by its unit",
         "rename it, or state its unit as rad/s");
  }
  return factor;
}

/// A text that may be meant as the unit of the axis, under another name: "frequnit", and a label of a plot, xlabel = "f [kHz]",
/// where it states another unit than the name of the axis does.
void MatLookup::require_no_other_label(const MatInfo& axis, double by_name) const {
  constexpr std::size_t longest = 64;
  for (const auto& [name, note] : file_.notes(axis)) {
    const std::vector<std::string_view> labels = labels_in(note);
    const bool other =
        note.size() <= longest && std::ranges::any_of(labels, [&](std::string_view each) { return is_other(each, by_name); });
    if (other && name.starts_with(axis.name + "@"))
      fail(place_of(name), "is '" + shown_label(note) + "' and is not read",
           "did you mean the attribute unit? Or give --frequency-unit, in a scene frequency_unit");
  }
  for (const MatInfo& info : file_.variables()) {
    if (info.kind != MatKind::text || !info.name.starts_with(scope_of(axis)) || size(info) > longest) continue;
    const std::string name = lower_case(std::string_view(info.name).substr(scope_of(info).size()));
    const bool of_axis = name.find("freq") != std::string::npos || name.find("abscissa") != std::string::npos;
    const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
    const bool label = (of_axis || name.starts_with('x')) && (has("label") || has("axis") || has("title"));
    const bool unit = of_axis && name.find("unit") != std::string::npos;
    if (!label && !unit) continue;
    for (const std::string& text : texts(info)) {
      const bool other = unit && !states_no_unit(text) && lower_case(text) != "hz";
      const bool states =
          label && std::ranges::any_of(labels_in(text), [&](std::string_view each) { return is_other(each, by_name); });
      if (other || states)
        fail(place_of(info.name), "is '" + shown_label(text) + "' and is not read",
             "did you mean frequency_unit? Rename it, or give --frequency-unit, in a scene frequency_unit");
    }
  }
}

/// Of a struct x_values, as Testlab exports it; nothing where there is none.
std::vector<double> MatLookup::stepped_axis(const std::string& unit) const {
  const double start = number("x_values.start_value"), step = number("x_values.increment"),
               count = number("x_values.number_of_values");
  if (std::isnan(step) || std::isnan(count)) return {};
  if (!(count >= 1.0) || count > longest_axis || count != std::floor(count))
    fail(place_of("x_values.number_of_values"), fmt::format("{:g} is no number of lines", count), "export the FRFs again");
  const std::string label = unit.empty() ? text(axis_unit_names) : unit;
  const double hz =
      label.empty() ? 1.0
                    : located(file_.file(), place_of("x_values.quantity.label"), [&] { return hertz_per(label).value_or(1.0); });
  std::vector<double> axis(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < axis.size(); ++i)
    axis[i] = hz * ((std::isnan(start) ? 0.0 : start) + static_cast<double>(i) * step);
  return axis;
}

void MatLookup::fail_axis(const MatInfo& frf) const {
  std::vector<const MatInfo*> fitting, all;
  for (const MatInfo& info : file_.variables()) {
    all.push_back(&info);
    if (is_vector(info) && std::ranges::find(frf.dims, size(info)) != frf.dims.end() && size(info) > 1) fitting.push_back(&info);
  }
  if (!fitting.empty()) {
    fail({},
         "has no vector of frequencies by a name that is known; as long as an axis of " + frf.name + " are " +
             listed(file_, fitting),
         "name it: --frequency-variable " + fitting.front()->name + ", in a scene frequency_variable");
  }
  fail({}, "has no vector of frequencies; its variables are " + listed(file_, all),
       "add one named frequency (Hz) or omega (rad/s), or name it: --frequency-variable, in a scene frequency_variable");
}

std::vector<double> MatLookup::axis(const std::string& variable, const std::string& unit, const MatInfo& frf) const {
  const MatInfo* info = variable.empty() ? axis_by_name() : &named_axis(variable);
  if (info == nullptr) {
    std::vector<double> stepped = stepped_axis(unit);
    if (stepped.empty()) fail_axis(frf);
    return stepped;
  }
  for (const char* word : {"log", "norm", "ratio", "rel"}) {
    const bool other = lower_case(std::string_view(info->name).substr(scope_of(*info).size())).find(word) != std::string::npos;
    if (other && unit.empty())
      fail(place_of(info->name), "holds no frequencies by its name",
           "store frequencies; if it does, state their unit: --frequency-unit Hz, in a scene frequency_unit");
  }
  std::vector<double> values = numbers(*info);
  const double hz = unit.empty() ? hz_per_unit(*info) : hertz_per(unit).value_or(1.0);
  for (double& value : values) value *= hz;
  return values;
}

std::size_t MatLookup::axis_length(const std::string& variable) const {
  const MatInfo* info = variable.empty() ? axis_by_name() : find(variable);
  if (info != nullptr) return size(*info);
  const double count = variable.empty() ? number("x_values.number_of_values") : 0.0;
  return count >= 1.0 && count <= longest_axis ? static_cast<std::size_t>(count) : 0;
}

std::string MatLookup::text(Names names) const {
  const MatInfo* info = find(names);
  if (info == nullptr || info->kind == MatKind::other) return {};  // other: a struct with fields of its own
  if (info->kind != MatKind::text) fail(place_of(info->name), "is not text", "write a text, or remove it");
  const std::vector<std::string> found = texts(*info);
  const std::string first = found.empty() ? std::string() : found.front();
  const auto other = std::ranges::find_if(found, [&](const std::string& each) { return each != first; });
  if (other != found.end())
    fail(place_of(info->name), "states '" + shown_label(first) + "' and '" + shown_label(*other) + "', and one text is for all FRFs",
         "store all FRFs alike, with one text");
  return first == "-" || first == "NONE" || first == "none" ? std::string() : first;
}

std::string MatLookup::joined_text(Names names) const {
  const MatInfo* info = find(names);
  if (info == nullptr || info->kind != MatKind::text) return {};
  std::string joined;
  for (const std::string& text : texts(*info)) joined += (joined.empty() ? "" : ",") + text;
  return joined;
}

double MatLookup::number(std::string_view name) const {
  const MatInfo* info = find(name);
  if (info == nullptr || info->kind != MatKind::real || size(*info) != 1) return std::numeric_limits<double>::quiet_NaN();
  return numbers(*info).front();
}

std::vector<std::string> MatLookup::texts(const MatInfo& info) const {
  std::vector<std::string> out;
  for (const std::string& text : file_.read(info).texts) out.push_back(trimmed_end(text));
  return out;
}

/// "12:+X" of a node and a direction, each a number or a text; nothing where there are no such variables.
std::vector<std::string> MatLookup::nodes_and_directions(bool response) const {
  const MatInfo* node = find(response ? Names(response_nodes) : Names(reference_nodes));
  const MatInfo* direction = find(response ? Names(response_directions) : Names(reference_directions));
  if (node == nullptr || direction == nullptr || node->kind != MatKind::real) return {};
  std::vector<std::string> directions;
  if (direction->kind == MatKind::text) directions = texts(*direction);
  if (direction->kind == MatKind::real) {
    for (const double code : numbers(*direction)) directions.push_back(direction_text(code));
  }
  const std::vector<double> nodes = numbers(*node);
  if (directions.size() != nodes.size()) {
    fail(place_of(direction->name), fmt::format("has {} directions and {} {} nodes", directions.size(), node->name, nodes.size()),
         "give a direction for each");
  }
  std::vector<std::string> out;
  for (std::size_t i = 0; i < nodes.size(); ++i) out.push_back(fmt::format("{:.10g}:{}", nodes[i], directions[i]));
  return out;
}

std::vector<Dof> MatLookup::dofs(bool response, const std::vector<Dof>& given, const std::string& scale) const {
  const Names names = response ? Names(response_names) : Names(reference_names);
  const MatInfo* info = find(names.first(1));
  if (info != nullptr && info->kind != MatKind::text)
    fail(place_of(info->name), "is not text", "write a cell array such as {'4:+Y'; '5:+Y'}");
  const bool ours = info != nullptr;
  if (!ours) info = find(names);
  if (info == nullptr && !scale.empty()) info = find(scale);
  const bool text = info != nullptr && info->kind == MatKind::text;
  const std::vector<std::string> words = text ? texts(*info) : nodes_and_directions(response);
  std::vector<Dof> dofs;
  const std::string place = text ? place_of(info->name) : response ? "response nodes" : "reference nodes";
  try {
    for (const std::string& word : words) dofs.push_back(located(file_.file(), place, [&] { return Dof::parse(word); }));
  } catch (const InputError&) {
    if (ours || given.empty()) throw;
    return given;  // a text of another program under a name that only may mean DOFs
  }
  if (dofs.empty() || given.empty() || given == dofs) return dofs.empty() ? given : dofs;
  fail(place, "names the DOFs " + comma_list(frf::names(dofs)) + ", others are given",
       "leave out the DOFs that are given (--response, --reference, in a scene dofs), or change the file");
}

void MatLookup::fail(std::string place, std::string problem, std::string remedy) const {
  throw InputError({.kind = ErrorKind::data,
                    .file = file_.file(),
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

}  // namespace jointid::frf
