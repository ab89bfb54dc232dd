#include "frf/mat/mat_beside.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "frf/mat/mat_lookup.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/remarks.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

constexpr std::size_t most_texts_beside = 200, longest_text_beside = 256, longest_label_beside = 64, most_numbers_beside = 4096;

class Beside {
 public:
  Beside(MatFile& file, const MatInfo& frf) : file_(file), frf_(frf), scope_(scope_of(frf)) {}

  void require_nothing_unread() const {
    std::size_t texts = 0;
    for (const MatInfo& info : file_.variables()) {
      if (!is_near(info)) continue;
      if (info.kind == MatKind::real) require_neutral(info);
      if (info.kind == MatKind::text && size(info) <= longest_text_beside && ++texts <= most_texts_beside) {
        for (const std::string& text : texts_of(info)) require_plain(info.name, own_name(info), text);
      }
    }
    for (const auto& [name, text] : file_.notes(frf_)) require_plain(name, name.substr(name.rfind('@') + 1), text);
  }

  std::string numbers_not_applied(const FrfHeader& header, const std::string& axis) const {
    constexpr std::size_t most = 4;
    std::vector<std::string> found;
    const std::vector<std::size_t> sizes = {1, header.response.size(), header.reference.size(), header.entries()};
    for (const MatInfo& info : file_.variables()) {
      const bool fits = info.kind == MatKind::real && is_near(info) && std::ranges::find(sizes, size(info)) != sizes.end();
      if (!fits || info.name == axis || &info == &frf_ || info.dims == frf_.dims || is_read(own_name(info))) continue;
      const std::vector<Complex> values = file_.read(info).values;
      const bool positive =
          std::ranges::all_of(values, [](Complex value) { return value.real() > 0.0 && std::isfinite(value.real()); });
      if (!positive || std::ranges::all_of(values, [](Complex value) { return value.real() == 1.0; })) continue;
      if (values.size() > 1 && may_be_channel_factor(own_name(info)))
        fail(info.name,
             fmt::format("holds {} numbers that are not applied to the FRFs, {:g} first", values.size(), values[0].real()),
             remedy(own_name(info)));
      const bool whole = std::ranges::all_of(values, [](Complex value) { return value.real() == std::floor(value.real()); });
      if (values.size() > 1 && whole) continue;  // labels
      found.push_back(fmt::format("{} {} {:g}", info.name, values.size() > 1 ? "begins with" : "is", values[0].real()));
    }
    for (const auto& [name, text] : file_.notes(frf_)) {
      double value = 0.0;
      const bool number = may_be_channel_factor(name.substr(name.rfind('@') + 1)) && parse_cell(trimmed(text), false, value);
      if (number && value > 0.0 && value != 1.0) found.push_back(fmt::format("{} is {:g}", name, value));
    }
    if (found.empty()) return {};
    const std::size_t more = found.size() > most ? found.size() - most : 0;
    found.resize(found.size() - more);
    return "numbers beside the FRFs are not applied to them: " + fmt::format("{}", fmt::join(found, ", ")) +
           (more > 0 ? fmt::format(" and {} more", more) : "");
  }

  void require_no_other_unit() const {
    for (const MatInfo& info : file_.variables()) {
      if (info.kind != MatKind::text || !info.name.starts_with(scope_)) continue;
      const std::string name = lower_case(info.name);
      if ((name.find("unit") == std::string::npos && lower_case(own_name(info)) != "eu") ||
          name.find("_axis_units_lab") != std::string::npos)
        continue;
      if (scope_of(info) != scope_ && !is_motion_or_force(info)) continue;
      const auto is_of = [&](const char* word) { return name.find(word) != std::string::npos; };
      if (is_of("freq") || is_of("time") || is_of("phase") || is_of("angle") || name.ends_with("ref_unit")) continue;
      fail(info.name, "is not read", rename);
    }
    require_no_unit_in_text();
  }

 private:
  static constexpr const char* rename = "did you mean unit? Rename it, or remove it where it is of something else";

  [[noreturn]] void fail(const std::string& name, std::string problem, std::string remedy) const {
    throw InputError({.kind = ErrorKind::data,
                      .file = file_.file(),
                      .place = place_of(name),
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  }

  /// By other parts of the reader, or of something else by its name.
  static bool is_read(const std::string& name) {
    for (const char* part : {"spec_data_type", "unit_transformation", "x_values", "y_values"}) {
      if (lower_case(name).find(part) != std::string::npos) return true;
    }
    return is_harmless_number(name);
  }

  /// None of a cell array that holds something else.
  std::vector<std::string> texts_of(const MatInfo& info) const {
    try {
      return file_.read(info).texts;
    } catch (const InputError&) {
      return {};
    }
  }

  /// In the struct of the FRFs, inside of it or around it.
  bool is_near(const MatInfo& info) const { return info.name.starts_with(scope_) || scope_.starts_with(scope_of(info)); }

  /// "info.scale" of S.info.scale beside S.H.
  std::string own_name(const MatInfo& info) const {
    return info.name.starts_with(scope_) ? info.name.substr(scope_.size()) : info.name.substr(scope_of(info).size());
  }

  void require_neutral(const MatInfo& info) const {
    const std::string name = own_name(info);
    if (use_of_number(name) == NumberUse::none || name.find("unit_transformation") != std::string::npos) return;
    if (&info == &frf_ || info.dims == frf_.dims) return;
    if (size(info) > most_numbers_beside) fail(info.name, "holds numbers that are not applied to the FRFs", remedy(name));
    for (const Complex& value : file_.read(info).values) require_neutral(info.name, name, value.real());
  }

  /// A factor of 0 or NaN stands for none.
  void require_neutral(const std::string& place, const std::string& name, double value) const {
    const bool added = use_of_number(name) == NumberUse::is_added;
    if (std::isnan(value) || value == 0.0 || (!added && value == 1.0)) return;
    fail(place, fmt::format("is {:g} and is not applied to the FRFs", value), remedy(name));
  }

  static std::string remedy(const std::string& name) {
    const bool added = use_of_number(name) == NumberUse::is_added;
    return std::string("store the FRFs ") + (added ? "with it" : "multiplied by it") + " and remove " + name +
           "; if that is done already, remove or rename it";
  }

  void require_plain(const std::string& place, const std::string& name, std::string_view text) const {
    double value = 0.0;
    if (use_of_number(name) != NumberUse::none && !text.empty() && parse_cell(trimmed(text), false, value))
      require_neutral(place, name, value);
    if (const auto factor = stated_factor(text); factor && *factor != 1.0)
      fail(place, fmt::format("states the factor {:g}, which is not applied to the FRFs", *factor),
           "store the FRFs multiplied by it, and remove the text");
    if (states_conjugates(text))
      fail(place, "states '" + shown_label(text) + "', conjugates of FRFs of exp(+iωt)",
           "store the FRFs for exp(+iωt), and remove the text");
  }

  /// Not in SI, and no length or time.
  bool is_motion_or_force(const MatInfo& info) const {
    const std::vector<std::string> texts =
        size(info) <= longest_label_beside ? texts_of(info) : std::vector<std::string>();
    return std::ranges::any_of(texts, [](const std::string& text) { return is_motion_or_force(text); });
  }

  static bool is_motion_or_force(const std::string& text) {
    const auto unit = text.size() <= longest_label_beside ? parse_unit(text) : std::nullopt;
    return unit && unit->si != 1.0 && (unit->force != 0 || (unit->length == 1 && unit->time < 0));
  }

  /// A text that is the unit of an FRF, under a name that nothing reads: a label of a plot, "Accelerance [g/N]".
  void require_no_unit_in_text() const {
    std::size_t count = 0;
    for (const MatInfo& info : file_.variables()) {
      const bool label = info.kind == MatKind::text && info.name.starts_with(scope_) && size(info) <= longest_text_beside;
      if (!label || ++count > most_texts_beside) continue;
      for (const std::string& text : texts_of(info)) require_no_unit(info.name, text);
    }
    for (const auto& [name, text] : file_.notes(frf_)) {
      require_no_unit(name, text);
      const std::string own = lower_case(name.substr(name.rfind('@') + 1));
      const bool unit = own.find("unit") != std::string::npos || own == "eu" || own == "uom";
      if (unit && own.find("freq") == std::string::npos && is_motion_or_force(text)) fail(name, "is not read", rename);
    }
  }

  void require_no_unit(const std::string& name, std::string_view text) const {
    for (const std::string_view label : labels_in(text)) {
      if (label.size() <= longest_label_beside && quantity_of_unit(label))
        fail(name, "states the unit '" + shown_label(label) + "' and is not read", rename);
    }
    for (const std::string_view label : ratios_in(text)) {
      const auto unit = quantity_of_unit(label) ? parse_unit(label) : std::nullopt;
      if (unit && unit->si != 1.0) fail(name, "states the unit '" + shown_label(label) + "' and is not read", rename);
    }
  }

  MatFile& file_;
  const MatInfo& frf_;
  std::string scope_;
};

}  // namespace

void require_nothing_unread(MatFile& file, const MatInfo& frf) { Beside(file, frf).require_nothing_unread(); }

std::string numbers_not_applied(MatFile& file, const MatInfo& frf, const FrfHeader& header, const std::string& axis) {
  return Beside(file, frf).numbers_not_applied(header, axis);
}

void require_no_other_unit(MatFile& file, const MatInfo& frf) { Beside(file, frf).require_no_other_unit(); }

}  // namespace jointid::frf
