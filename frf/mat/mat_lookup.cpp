#include "frf/mat/mat_lookup.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "frf/text/located.hpp"

namespace jointid::frf {
namespace {

struct AxisName {
  std::string_view name;
  double to_hz;
};
constexpr double from_rad_per_s = 0.5 / std::numbers::pi;
constexpr std::array<AxisName, 9> axis_names = {{{"frequency_hz", 1.0},
                                                 {"frequency", 1.0},
                                                 {"freq", 1.0},
                                                 {"f", 1.0},
                                                 {"freq_hz", 1.0},
                                                 {"frequencies", 1.0},
                                                 {"freq_domain", 1.0},
                                                 {"w", from_rad_per_s},
                                                 {"omega", from_rad_per_s}}};

/// One letter must match in case too: f is a frequency and F may be a force.
bool same_name(std::string_view a, std::string_view b) {
  if (a.size() == 1) return a == b;
  return std::ranges::equal(
      a, b, {}, [](unsigned char c) { return std::tolower(c); },
      [](unsigned char c) { return std::tolower(c); });
}

bool is_vector(const MatInfo& info) {
  return info.kind == MatKind::real &&
         std::ranges::count_if(info.dims, [](std::size_t n) { return n != 1; }) <= 1;
}

std::string listed(const MatFile& file, const std::function<bool(const MatInfo&)>& keep) {
  std::string text;
  for (const MatInfo& info : file.variables()) {
    if (keep(info)) text += (text.empty() ? "" : ", ") + info.name + " [" + shape(info) + "]";
  }
  return text.empty() ? "none" : text;
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

const MatInfo* MatLookup::find(std::string_view name) const {
  const auto& all = file_.variables();
  const auto found =
      std::ranges::find_if(all, [&](const MatInfo& info) { return same_name(info.name, name); });
  return found == all.end() ? nullptr : &*found;
}

std::vector<double> MatLookup::axis() const {
  for (const AxisName& axis : axis_names) {
    const MatInfo* info = find(axis.name);
    if (info == nullptr || !is_vector(*info)) continue;
    std::vector<double> values;
    for (const Complex& value : file_.read(*info).values) values.push_back(axis.to_hz * value.real());
    return values;
  }
  fail({}, "has no vector of frequencies; its variables are " + all(),
       "add one named frequency (Hz) or omega (rad/s)");
}

const MatInfo& MatLookup::frf(const std::string& variable, std::size_t lines) const {
  if (!variable.empty()) return named_frf(variable);
  if (find("frf") != nullptr) return named_frf("frf");
  const auto candidate = [&](const MatInfo& info) {
    const bool field = info.name.find('.') != std::string::npos;  // of a struct: only by name
    return info.kind == MatKind::complex && !field && !same_name(info.name, "variance") &&
           !same_name(info.name, "coherence") && std::ranges::find(info.dims, lines) != info.dims.end();
  };
  const auto& variables = file_.variables();
  const auto count = std::ranges::count_if(variables, candidate);
  if (count == 1) return *std::ranges::find_if(variables, candidate);
  if (count > 1)
    fail({}, "several variables may be the FRFs: " + listed(file_, candidate), "name one of them");
  fail({},
       "has no complex array with an axis of " + std::to_string(lines) + " lines; its variables are " + all(),
       "add one named frf");
}

std::string MatLookup::all() const {
  return listed(file_, [](const MatInfo&) { return true; });
}

const MatInfo& MatLookup::named_frf(const std::string& name) const {
  const MatInfo* info = find(name);
  if (info == nullptr) {
    fail({}, "has no variable " + name + "; there are " + all(), "name one of them");
  }
  if (info->kind != MatKind::complex && info->kind != MatKind::real) {
    fail(place_of(name), "is no array of numbers",
         "name one of " + listed(file_, [](const MatInfo& other) { return other.kind == MatKind::complex; }));
  }
  return *info;
}

std::string MatLookup::text(const char* name) const {
  const MatInfo* info = find(name);
  if (info == nullptr || info->kind != MatKind::text) return {};
  const MatVariable variable = file_.read(*info);
  return variable.texts.empty() ? std::string() : variable.texts.front();
}

std::vector<Dof> MatLookup::dofs(const char* name, const std::vector<Dof>& otherwise) const {
  const MatInfo* info = find(name);
  if (info == nullptr) return otherwise;
  if (info->kind != MatKind::text)
    fail(place_of(name), "is not text", "write a cell array such as {'4:+Y'; '5:+Y'}");
  std::vector<Dof> dofs;
  for (std::string text : file_.read(*info).texts) {
    text.resize(text.find_last_not_of(' ') + 1);  // rows of characters are padded with blanks
    dofs.push_back(located(file_.file(), place_of(name), [&] { return Dof::parse(text); }));
  }
  return dofs;
}

void MatLookup::fail(std::string place, std::string problem, std::string remedy) const {
  throw InputError({.kind = ErrorKind::data,
                    .file = file_.file(),
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

}  // namespace jointid::frf
