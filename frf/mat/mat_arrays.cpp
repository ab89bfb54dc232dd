#include "frf/mat/mat_arrays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "frf/mat/mat_lookup.hpp"
#include "frf/mat/mat_polar.hpp"
#include "frf/mat/several_variables.hpp"
#include "frf/text/remarks.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

using Arrays = std::vector<ComplexArray>;

/// Endings of the real and of the imaginary part, and what both may begin with.
constexpr std::array<std::array<std::string_view, 2>, 7> part_endings = {
    {{"_real", "_imag"}, {"_re", "_im"}, {".real", ".imag"}, {".re", ".im"}, {"Real", "Imag"}, {"Re", "Im"}, {"_r", "_i"}}};
constexpr std::array<std::array<std::string_view, 2>, 4> part_beginnings = {
    {{"real_", "imag_"}, {"re_", "im_"}, {"Real", "Imag"}, {"Re", "Im"}}};
constexpr std::array<std::string_view, 3> no_frfs = {"variance", "coherence", "covariance"};

/// "run.H" of run(3).H.
std::string without_numbers(const std::string& name) {
  std::string out;
  bool inside = false;
  for (const char c : name) {
    inside = inside || c == '(';
    if (!inside) out += c;
    inside = inside && c != ')';
  }
  return out;
}

std::string_view last_part(const MatInfo& info) { return std::string_view(info.name).substr(scope_of(info).size()); }

bool is_field(const ComplexArray& array) { return array.values->name.find('.') != std::string::npos; }

class FrfFinder {
 public:
  FrfFinder(MatFile& file, const std::string& axis) : file_(file), lookup_(file, {}), axis_(axis) {
    for (const MatInfo& info : file_.variables()) {
      const bool other = std::ranges::any_of(no_frfs, [&](std::string_view name) { return same_name(last_part(info), name); });
      if (info.kind == MatKind::complex && !other) arrays_.push_back({info.name, &info, nullptr, nullptr});
      if (info.kind == MatKind::real) add_parts(info);
    }
    pair_magnitudes();
  }

  Arrays named(const std::string& name) const {
    const MatInfo* exact = lookup_.find(name);
    const Arrays of_name = those([&](const ComplexArray& array) { return same_name(array.name, name); });
    if (!of_name.empty()) return of_name;
    const Arrays of_polar = polar([&](const ComplexArray& array) {
      return same_name(array.name, name) || same_name(array.values->name, name) || same_name(without_numbers(array.name), name);
    });
    if (!of_polar.empty()) return of_polar;
    if (exact != nullptr && exact->kind == MatKind::real) fail_real(*exact);
    const Arrays of_elements = those([&](const ComplexArray& array) { return same_name(without_numbers(array.name), name); });
    if (!of_elements.empty()) return of_elements;
    const Arrays inside =
        those([&](const ComplexArray& array) { return begins(array.name, name) || begins(without_numbers(array.name), name); });
    if (!inside.empty()) return only(fitting(inside), name);
    if (exact == nullptr) lookup_.fail({}, "has no variable " + name + "; there are " + listed(file_, all()), "name one of them");
    lookup_.fail(place_of(name), "is no array of complex numbers",
                 arrays_.empty() ? "store one, [lines, responses, references], or a cell of them for each FRF; cells in cells are not read"
                                 : "name one of " + listed(file_, infos(arrays_)));
  }

  Arrays by_itself() const {
    if (const MatInfo* frf = lookup_.find("frf"); frf != nullptr && (frf->kind == MatKind::complex || frf->kind == MatKind::real))
      return named("frf");
    const Arrays variables = fitting(those([](const ComplexArray& array) { return !is_field(array); }));
    if (!variables.empty()) return motion_over_force(only(variables, {}));
    const Arrays fields = fitting(those(is_field));
    const Arrays frfs = frfs_of(fields);
    if (!fields.empty()) return motion_over_force(only(frfs.empty() ? fields : frfs, {}));
    const Arrays apart = frfs_of(fitting(polar([](const ComplexArray&) { return true; })));
    if (!apart.empty()) return motion_over_force(only(apart, {}));
    fail_none();
  }

  /// By the function type of UFF 58 that pyuff and others store beside the numbers.
  void require_frf(const ComplexArray& array) const {
    constexpr double frf = 4.0;
    const MatLookup beside(file_, scope_of(*array.values));
    for (const char* name : {"func_type", "function_type"}) {
      const double type = beside.number(name);
      if (!std::isnan(type) && type != frf)
        lookup_.fail(place_of(scope_of(*array.values) + name), fmt::format("is {:g}, and an FRF is of type 4", type),
                     "export frequency response functions; auto and cross spectra, coherences and transmissibilities are none");
    }
  }

  /// Analysers store integers with a scale that stands elsewhere.
  void require_fractions(const ComplexArray& array) const {
    const MatInfo* other = array.imaginary != nullptr ? array.imaginary : array.phase;
    const bool integers = array.values->integers || (other != nullptr && other->integers);
    if (!integers) return;
    lookup_.fail(place_of(array.name), "holds integers, and their scale is not known",
                 "store the FRFs as floating-point numbers in their unit");
  }

 private:
  /// Those that no function type beside them says to be something else.
  Arrays frfs_of(const Arrays& arrays) const {
    Arrays out;
    for (const ComplexArray& array : arrays) {
      const MatLookup beside(file_, scope_of(*array.values));
      const double pyuff = beside.number("func_type"), other = beside.number("function_type");
      if ((std::isnan(pyuff) || pyuff == 4.0) && (std::isnan(other) || other == 4.0)) out.push_back(array);
    }
    return out;
  }

  /// What nobody named must not be of something else by its own name: a stiffness, a logarithm, a transpose, an error.
  Arrays motion_over_force(const Arrays& arrays) const {
    if (is_of_something_else(last_part(*arrays.front().values)))
      lookup_.fail(place_of(arrays.front().name), "is no FRF of motion over force by its name",
                   "export motion over force; if it is, name it: --variable " + arrays.front().name + ", in a scene variable");
    return arrays;
  }

  /// `info` as the real part of an array whose imaginary part is there, too: "H_real", "ReH", "Hr".
  void add_parts(const MatInfo& info) {
    const std::string scope = scope_of(info);
    const std::string_view own = last_part(info);
    if (add_parts_at_end(info)) return;
    for (const auto& [re, im] : part_beginnings) {
      if (own.size() <= re.size() || !same_name(own.substr(0, re.size()), re)) continue;
      const std::string base(own.substr(re.size()));
      if (add_pair(info, scope + base, scope + std::string(im) + base)) return;
    }
    const std::string base(own.substr(0, own.size() - 1));
    if (own.ends_with('r') && (base.size() == 1 || lower_case(base) == "frf")) add_pair(info, scope + base, scope + base + "i");
  }

  bool add_pair(const MatInfo& real, const std::string& name, const std::string& partner) {
    const auto [begin, end] = file_.by_lower_name().equal_range(lower_case(partner));
    const auto found = std::find_if(begin, end, [&](const auto& other) { return same_name(other.second->name, partner); });
    if (found == end || found->second->kind != MatKind::real || found->second->dims != real.dims) return false;
    arrays_.push_back({name, &real, found->second, nullptr});
    return true;
  }

  bool add_parts_at_end(const MatInfo& info) {
    for (const auto& [re, im] : part_endings) {
      const std::string& name = info.name;
      const bool whole = same_name(name, re.substr(re.find_first_not_of("_.")));
      if (!whole && (name.size() <= re.size() || !same_name(std::string_view(name).substr(name.size() - re.size()), re)))
        continue;
      const std::string base = whole ? std::string() : name.substr(0, name.size() - re.size());
      const std::string partner = base + std::string(whole ? im.substr(im.find_first_not_of("_.")) : im);
      if (add_pair(info, base.empty() ? name : base, partner)) return true;
    }
    return false;
  }

  /// Magnitudes and phases of one name, beside each other.
  void pair_magnitudes() {
    using Key = std::pair<std::string, std::string>;  // scope and base
    std::map<Key, const MatInfo*> phases;
    std::vector<std::pair<Key, const MatInfo*>> magnitudes;
    for (const MatInfo& info : file_.variables()) {
      const auto name = info.kind == MatKind::real && size(info) > 1 ? polar_name(last_part(info)) : std::nullopt;
      if (!name) continue;
      const Key key{scope_of(info), name->base.size() == 1 ? name->base : lower_case(name->base)};
      if (!name->phase)
        magnitudes.emplace_back(key, &info);
      else if (name->unit == AngleUnit::radians)
        phases[key] = &info;  // rather than the same in degrees
      else
        phases.emplace(key, &info);
    }
    for (const auto& [key, info] : magnitudes) {
      const auto phase = phases.find(key);
      if (phase == phases.end() || phase->second->dims != info->dims) continue;
      const std::string base = polar_name(last_part(*info))->base, &scope = key.first;
      const std::string name = !base.empty() ? scope + base : scope.empty() ? info->name : scope.substr(0, scope.size() - 1);
      polar_.push_back({.name = name, .values = info, .imaginary = nullptr, .phase = phase->second});
    }
  }

  template <class Keep>
  Arrays polar(const Keep& keep) const {
    Arrays out;
    std::ranges::copy_if(polar_, std::back_inserter(out), keep);
    return out;
  }

  static bool begins(const std::string& name, const std::string& structure) {
    return name.size() > structure.size() && name[structure.size()] == '.' &&
           same_name(std::string_view(name).substr(0, structure.size()), structure);
  }

  template <class Keep>
  Arrays those(const Keep& keep) const {
    Arrays out;
    std::ranges::copy_if(arrays_, std::back_inserter(out), keep);
    return out;
  }

  /// Those with an axis as long as their frequencies; where none is said to be, those whose frequencies are not known.
  Arrays fitting(const Arrays& arrays) const {
    Arrays fit, unknown;
    for (const ComplexArray& array : arrays) {
      const std::size_t lines = MatLookup(file_, scope_of(*array.values)).axis_length(axis_);
      if (lines == 0) unknown.push_back(array);
      if (lines > 0 && std::ranges::find(array.values->dims, lines) != array.values->dims.end()) fit.push_back(array);
    }
    return fit.empty() ? unknown : fit;
  }

  /// One array, or one field of all elements of an array of structs.
  Arrays only(const Arrays& arrays, const std::string& structure) const {
    const auto field = [](const ComplexArray& array) { return without_numbers(array.name); };
    const bool one =
        std::ranges::all_of(arrays, [&](const ComplexArray& array) { return field(array) == field(arrays.front()); });
    if (one) return arrays;
    try {
      lookup_.fail(structure.empty() ? std::string() : place_of(structure),
                   "several variables may be the FRFs: " + listed(file_, infos(arrays)),
                   "name one of them, --variable, in a scene variable");
    } catch (const InputError& error) {
      throw SeveralVariables(error.parts(), names_of(arrays));
    }
  }

  static std::vector<std::string> names_of(const Arrays& arrays) {
    std::vector<std::string> out;
    for (const ComplexArray& array : arrays) {
      std::string name = without_numbers(array.name);
      if (std::ranges::find(out, name) == out.end()) out.push_back(std::move(name));
    }
    return out;
  }

  static std::vector<const MatInfo*> infos(const Arrays& arrays) {
    std::vector<const MatInfo*> out;
    for (const ComplexArray& array : arrays) out.push_back(array.values);
    return out;
  }

  std::vector<const MatInfo*> all() const {
    std::vector<const MatInfo*> out;
    for (const MatInfo& info : file_.variables()) out.push_back(&info);
    return out;
  }

  [[noreturn]] void fail_real(const MatInfo& info) const {
    std::string others = arrays_.empty() ? std::string() : "; complex are " + listed(file_, infos(arrays_));
    lookup_.fail(place_of(info.name), "is real, and an FRF without a phase is none" + others,
                 "export complex FRFs, or real and imaginary parts as " + info.name + "_real and " + info.name + "_imag");
  }

  [[noreturn]] void fail_none() const {
    const std::size_t lines = lookup_.axis_length(axis_);
    if (lines == 0) {
      lookup_.fail({}, "has no vector of frequencies; its variables are " + listed(file_, all()),
                   "add one named frequency (Hz) or omega (rad/s)");
    }
    const auto real = std::ranges::find_if(file_.variables(), [&](const MatInfo& info) {
      return info.kind == MatKind::real && size(info) > lines && std::ranges::find(info.dims, lines) != info.dims.end();
    });
    if (real != file_.variables().end() && file_.variables().size() <= 4) fail_real(*real);
    const bool phases = std::ranges::any_of(file_.variables(), [&](const MatInfo& info) {
      const std::string own = lower_case(last_part(info));
      const bool phase = own.find("phase") != std::string::npos || own.find("angle") != std::string::npos;
      return phase && info.kind == MatKind::real && std::ranges::find(info.dims, lines) != info.dims.end();
    });
    lookup_.fail(
        {}, "has no complex array with an axis of " + std::to_string(lines) + " lines; its variables are " + listed(file_, all()),
        phases ? "store magnitudes and phases as complex numbers, magnitude · exp(i · phase), the phase in rad, under the name frf"
               : "add one named frf");
  }

  MatFile& file_;
  MatLookup lookup_;
  const std::string& axis_;
  Arrays arrays_;
  Arrays polar_;  ///< magnitudes and phases, where nothing else is FRFs
};

}  // namespace

std::vector<ComplexArray> find_frfs(MatFile& file, const std::string& variable, const std::string& axis) {
  const FrfFinder finder(file, axis);
  std::vector<ComplexArray> found = variable.empty() ? finder.by_itself() : finder.named(variable);
  for (const ComplexArray& array : found) {
    finder.require_frf(array);
    finder.require_fractions(array);
  }
  return found;
}

}  // namespace jointid::frf
