#include <cmath>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "frf/uff/uff55.hpp"
#include "frf/uff/uff_scan.hpp"
#include "frf/uff/uff_text.hpp"
#include "frf/uff/uff_unit_table.hpp"

namespace jointid::frf {
namespace {

using uff::Dataset;
constexpr std::size_t real_width = 13;
constexpr std::size_t integer_width = 10;

/// The lines of one dataset, one after the other.
class Lines {
 public:
  Lines(uff::ByteFile& file, const Dataset& dataset) : file_(file), dataset_(dataset) { file_.seek(dataset.payload_begin); }

  bool at_end() {
    while (file_.position() < dataset_.payload_end) {
      const std::uint64_t here = file_.position();
      std::string_view line;
      if (!file_.next_line(line)) return true;
      if (uff::trim(line).empty()) continue;
      file_.seek(here);
      return false;
    }
    return true;
  }

  const std::string& next(const char* record) {
    std::string_view line;
    if (file_.position() >= dataset_.payload_end || !file_.next_line(line)) {
      dataset_.place.fail(record, "the dataset ends before it", "the file is damaged or cut off; export it again");
    }
    line_ = uff::one_byte_per_column(line);
    return line_;
  }

  std::int64_t integer(std::size_t index, const char* record) const {
    const auto text = uff::column(line_, index * integer_width, integer_width);
    const auto value = uff::parse_integer(text);
    if (!value) dataset_.place.fail(record, "'" + uff::to_utf8(text) + "' is not a whole number", "correct it, or export the file again");
    return *value;
  }

  /// `count` numbers from as many lines of six as they take.
  std::vector<double> reals(std::size_t count, const char* record) {
    std::vector<double> values;
    while (values.size() < count) {
      next(record);
      for (std::size_t i = 0; i < 6 && values.size() < count; ++i) values.push_back(real(i, record));
    }
    return values;
  }

 private:
  double real(std::size_t index, const char* record) const {
    const auto text = uff::column(line_, index * real_width, real_width);
    const auto value = uff::parse_real(text);
    if (!value || !std::isfinite(*value)) {
      dataset_.place.fail(record, "'" + uff::to_utf8(text) + "' is not a number", "correct it, or export the file again");
    }
    return *value;
  }

  uff::ByteFile& file_;
  const Dataset& dataset_;
  std::string line_;
};

/// Record 6.
struct Kind {
  std::int64_t analysis = 0, characteristic = 0, specific = 0, data_type = 0, values = 0;

  bool is_complex() const { return analysis == 3 || analysis == 7; }
  bool is_mode() const { return (analysis == 2 || is_complex()) && (data_type == 2 || data_type == 5); }
  /// Strains, stresses and reactions of a mode are no shape.
  bool is_motion() const { return specific <= 1 || specific == 8 || specific == 11 || specific == 12; }
  bool is_vector() const { return (characteristic == 2 && values == 3) || (characteristic == 3 && values == 6); }
};

void take_constants(const std::vector<double>& reals, Uff55Mode& mode) {
  const auto at = [&](std::size_t i) { return i < reals.size() ? reals[i] : 0.0; };
  if (!mode.is_complex) {
    mode.frequency_hz = at(0);
    mode.modal_mass = at(1);
    mode.viscous_damping = at(2);
    mode.hysteretic_damping = at(3);
    return;
  }
  mode.eigenvalue = {at(0), at(1)};
  mode.modal_a = {at(2), at(3)};
  mode.modal_b = {at(4), at(5)};
  mode.frequency_hz = hertz(std::abs(mode.eigenvalue));
  if (mode.frequency_hz > 0.0) mode.viscous_damping = -mode.eigenvalue.real() / std::abs(mode.eigenvalue);
}

void take_node(Lines& lines, const Kind& kind, Uff55Mode& mode) {
  lines.next("record 9");
  const std::int64_t node = lines.integer(0, "record 9");
  const auto components = static_cast<std::size_t>(kind.values);
  const std::size_t parts = kind.data_type == 5 ? 2 : 1;
  const std::vector<double> values = lines.reals(components * parts, "record 10");
  for (std::size_t i = 0; i < components; ++i) {
    mode.dofs.push_back({node, static_cast<Direction>(i + 1), 1});
    mode.shape.push_back(parts == 2 ? Complex(values[2 * i], values[2 * i + 1]) : Complex(values[i]));
  }
}

/// Of specific data types 11 and 12; others are displacements, also those that are not stated.
Quantity quantity_of(const Kind& kind) {
  return kind.specific == 11 ? Quantity::mobility : kind.specific == 12 ? Quantity::accelerance : Quantity::receptance;
}

/// False for a dataset 55 that is no mode shape.
bool read_mode(uff::ByteFile& file, const Dataset& dataset, Uff55Mode& mode, std::vector<std::string>* not_read) {
  Lines lines(file, dataset);
  for (std::string& id : mode.id) id = uff::to_utf8(uff::trim(lines.next("ID lines")));
  lines.next("record 6");
  const auto field = [&](std::size_t index) { return lines.integer(index, "record 6"); };
  const Kind kind{field(1), field(2), field(3), field(4), field(5)};
  if (!kind.is_mode() || !kind.is_motion()) return false;
  if (!kind.is_vector()) {
    if (not_read != nullptr)
      not_read->push_back("a mode shape of " + std::to_string(kind.values) + " values per node, data characteristic " +
                          std::to_string(kind.characteristic));
    return false;
  }
  mode.is_complex = kind.is_complex();
  mode.quantity = quantity_of(kind);
  lines.next("record 7");
  const std::int64_t reals = lines.integer(1, "record 7");
  if (reals < 0 || reals > 100)
    dataset.place.fail("record 7", std::to_string(reals) + " real values are announced", "export the file again");
  mode.number = static_cast<int>(lines.integer(3, "record 7"));
  take_constants(lines.reals(static_cast<std::size_t>(reals), "record 8"), mode);
  while (!lines.at_end()) take_node(lines, kind, mode);
  return true;
}

/// The modal masses of a file in mm and N are in tonnes. Shapes are pure numbers, but rotations beside translations.
void scale_to_si(Uff55Mode& mode, const uff::UnitFactors& factors) {
  const double mass = factors.length / factors.force;
  mode.modal_mass *= mass;
  mode.modal_a *= mass;
  mode.modal_b *= mass;
  for (std::size_t i = 0; i < mode.dofs.size(); ++i) {
    if (mode.dofs[i].is_rotation()) mode.shape[i] *= factors.length;
  }
}

}  // namespace

std::vector<Uff55Mode> read_uff55(const std::filesystem::path& path, std::vector<std::string>* not_read) {
  uff::ByteFile file(path);
  const std::vector<Dataset> datasets = uff::scan(file);
  const uff::UnitTable units(file, datasets);
  std::vector<Uff55Mode> modes;
  for (const Dataset& dataset : datasets) {
    if (dataset.number != 55 || dataset.binary) continue;
    Uff55Mode mode;
    if (!read_mode(file, dataset, mode, not_read)) continue;
    const uff::UnitFactors factors = units.at(dataset);
    if (!factors.contradiction.empty())
      dataset.place.fail("modal masses", factors.contradiction, "correct dataset 164, which their unit is taken from");
    scale_to_si(mode, factors);
    modes.push_back(std::move(mode));
  }
  if (modes.empty()) {
    throw InputError({.kind = ErrorKind::data,
                      .file = path.string(),
                      .place = {},
                      .problem = "it holds no mode shapes (dataset 55)",
                      .remedy = "export the modes, or name another file"});
  }
  return modes;
}

}  // namespace jointid::frf
