#include "frf/npy/npy_records.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "frf/npy/npy_array.hpp"
#include "frf/polar/polar_search.hpp"
#include "frf/set/line_scale.hpp"
#include "frf/set/unit_label.hpp"

namespace jointid::frf {
namespace {

const NpyField* field_named(const NpyHeader& header, std::string_view name) {
  const auto found = std::ranges::find(header.fields, name, &NpyField::name);
  return found == header.fields.end() ? nullptr : &*found;
}

class FunctionRecords {
 public:
  FunctionRecords(const NpyHeader& header, std::string_view elements, const std::string& file, const OpenOptions& options)
      : header_(header), elements_(elements), options_(options) {
    set_.header.file = file;
  }

  FrfSet read() {
    FrfHeader& header = set_.header;
    if (!options_.variable.empty() || !options_.frequency_variable.empty())
      fail({}, "a variable is named, and the file holds functions of SDynPy", "leave out --variable and --frequency-variable");
    if (field("ordinate").kind != 'c')
      fail("ordinate", "holds no complex numbers, and an FRF without a phase is none", "save frequency response functions");
    if (field("coordinate.node").count != 2)
      fail("coordinate", "has no reference beside the response", "save frequency response functions");
    if (!options_.quantity)
      fail({}, "does not state which quantity it holds", "give it: --quantity accelerance, in a scene quantity; FRFs in SI units");
    header.quantity = *options_.quantity;
    count_ = header_.width == 0 ? 0 : elements_.size() / header_.width;
    if (count_ == 0) fail({}, "holds no functions", "save it again");
    read_axis();
    for (std::size_t k = 0; k < count_; ++k) read_dofs(k);
    validate(header);
    fill();
    header.doubts.emplace_back("functions of SDynPy state no unit: FRFs are taken in SI units");
    return std::move(set_);
  }

 private:
  [[noreturn]] void fail(std::string place, std::string problem, std::string remedy) const {
    throw InputError({.kind = ErrorKind::data,
                      .file = set_.header.file,
                      .place = std::move(place),
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  }
  static std::string place(std::size_t k) { return "function " + std::to_string(k + 1); }

  const NpyField& field(std::string_view name) const { return *field_named(header_, name); }
  std::vector<Complex> numbers(std::size_t k, std::string_view name) const {
    return npy_numbers(field(name), elements_.substr(k * header_.width, header_.width));
  }

  void read_axis() {
    const double hz = hertz_per(options_.frequency_unit).value_or(1.0);
    const std::vector<Complex> first = numbers(0, "abscissa");
    if (first.size() != field("ordinate").count)
      fail("abscissa", std::to_string(first.size()) + " frequencies and " + std::to_string(field("ordinate").count) + " values",
           "save frequency response functions");
    for (const Complex& line : first) set_.header.frequency_hz.push_back(hz * line.real());
    for (std::size_t k = 1; k < count_; ++k) {
      if (numbers(k, "abscissa") != first)
        fail(place(k), "has other frequencies than function 1", "save functions of the same lines in one file");
    }
  }

  Dof dof(std::size_t k, std::size_t side) const {
    const double node = numbers(k, "coordinate.node")[side].real(), code = numbers(k, "coordinate.direction")[side].real();
    if (code == 0.0 || std::abs(code) > 6.0 || node > 9e15)
      fail(place(k), "its " + std::string(side == 0 ? "response" : "reference") + " has no direction, code " +
                         std::to_string(static_cast<int>(code)),
           "give each coordinate a direction: 1, 2, 3 are +X, +Y, +Z, 4, 5, 6 rotations, negative ones the other way");
    return {.node = static_cast<std::int64_t>(node),
            .direction = static_cast<Direction>(static_cast<int>(std::abs(code))),
            .sign = code < 0.0 ? -1 : 1};
  }

  std::size_t place_in(std::vector<Dof>& dofs, const Dof& dof, std::map<std::int64_t, std::size_t>& places, int& sign) const {
    const auto [found, is_new] = places.try_emplace(coordinate_key(dof), dofs.size());
    if (is_new) dofs.push_back(dof);
    sign *= dof.sign * dofs[found->second].sign;
    return found->second;
  }

  void read_dofs(std::size_t k) {
    Entry entry;
    entry.row = place_in(set_.header.response, dof(k, 0), rows_, entry.sign);
    entry.column = place_in(set_.header.reference, dof(k, 1), columns_, entry.sign);
    const auto [known, is_new] = known_.try_emplace({entry.row, entry.column}, k);
    if (!is_new)
      fail(place(k), "is between the same DOFs as function " + std::to_string(known->second + 1), "keep one of the two");
    entries_.push_back(entry);
  }

  void fill() {
    const FrfHeader& header = set_.header;
    const double none = std::numeric_limits<double>::quiet_NaN();
    set_.values.assign(header.lines() * header.entries(), {none, none});
    PolarSearch search(header.quantity);
    for (std::size_t k = 0; k < count_; ++k) {
      const std::vector<Complex> values = numbers(k, "ordinate");
      if (search.may_be()) search.add(values);
      const Entry& entry = entries_[k];
      for (std::size_t line = 0; line < values.size(); ++line) {
        const LineScale scale = LineScale::to_receptance(header.quantity, entry.sign, header.frequency_hz[line]);
        set_.values[set_.index(line, entry.row, entry.column)] = scale.value(values[line]);
      }
    }
    if (const auto finding = search.finding())
      fail("ordinate", "holds no real and imaginary parts but " + *finding, "save complex numbers, magnitude \u00b7 exp(i \u00b7 phase)");
  }

  struct Entry {
    std::size_t row = 0, column = 0;
    int sign = 1;
  };

  const NpyHeader& header_;
  std::string_view elements_;
  const OpenOptions& options_;
  FrfSet set_;
  std::size_t count_ = 0;
  std::map<std::int64_t, std::size_t> rows_, columns_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> known_;
  std::vector<Entry> entries_;
};

}  // namespace

bool are_functions(const NpyHeader& header) {
  constexpr std::array<std::string_view, 4> names = {"abscissa", "ordinate", "coordinate.node", "coordinate.direction"};
  return std::ranges::all_of(names, [&](std::string_view name) {
    const NpyField* field = field_named(header, name);
    return field != nullptr && (field->kind == 'f' || field->kind == 'c' || field->kind == 'i' || field->kind == 'u');
  });
}

FrfSet read_functions(const NpyHeader& header, std::string_view elements, const std::string& file, const OpenOptions& options) {
  return FunctionRecords(header, elements, file, options).read();
}

void fail_records(const std::string& file) {
  fail_npy(file, "holds records with named fields",
           "save each field as an array of its own, numpy.savez(FILE, frf=\u2026, frequency=\u2026), or export a universal file");
}

}  // namespace jointid::frf
