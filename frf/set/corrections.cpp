#include "frf/set/corrections.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/complex.hpp"
#include "frf/set/dof_lookup.hpp"
#include "frf/set/scaled_source.hpp"
#include "frf/set/unloaded_source.hpp"

namespace jointid::frf {
namespace {

/// Multiplies the factors of the DOFs that the numbers belong to.
void multiply(std::vector<double>& factors, const FrfHeader& header, const std::vector<Dof>& dofs, const std::vector<DofNumber>& numbers,
              const char* key) {
  for (const DofNumber& number : numbers) factors[index_of_dof(header, dofs, number.dof, key)] *= number.value;
}

std::vector<DofNumber> minus_one(const std::vector<Dof>& dofs) {
  std::vector<DofNumber> numbers;
  for (const Dof& dof : dofs) numbers.push_back({dof, -1.0});
  return numbers;
}

std::vector<Dof> renamed(const FrfHeader& header, const std::vector<Dof>& dofs, const std::vector<DofRename>& names, const char* key) {
  std::vector<Dof> out = dofs;
  for (const DofRename& name : names) {
    const std::size_t at = index_of_dof(header, dofs, name.from, key);
    out[at] = name.to;
    out[at].sign = dofs[at].sign * name.from.sign * name.to.sign;
  }
  return out;
}

bool scales(const Corrections& c) {
  return c.frequency_scale != 1.0 || !c.rename.empty() || !c.rename_reference.empty() || c.conjugate || c.delay != 0.0 || c.gain != 1.0 ||
         !c.response_gain.empty() || !c.reference_gain.empty() || !c.flip.empty() || !c.flip_reference.empty();
}

/// The header after frequency_scale and rename.
FrfHeader relabelled(const FrfHeader& header, const Corrections& c) {
  FrfHeader out = header;
  for (double& frequency : out.frequency_hz) frequency *= c.frequency_scale;
  out.response = renamed(header, header.response, c.rename, "rename");
  out.reference = renamed(header, header.reference, c.rename_reference, "rename_reference");
  validate(out);
  return out;
}

/// Receptance = stored FRF / (iω)^n with n = 0, 1, 2: on an axis `scale` times as long it is scale^−n as large, and the
/// conjugate of a mobility changes the sign of the receptance that it makes, too.
double line_gain(const Corrections& c, Quantity quantity) {
  const int order = static_cast<int>(quantity);
  const double of_conjugate = c.conjugate && order == 1 ? -1.0 : 1.0;
  return c.gain * of_conjugate * std::pow(c.frequency_scale, -order);
}

EntryScale entry_scale(const FrfHeader& header, const Corrections& c) {
  EntryScale scale{.conjugate = c.conjugate, .line = {}, .response = {}, .reference = {}};
  const double gain = line_gain(c, header.quantity);
  for (const double frequency : header.frequency_hz) {
    const Complex phase = c.delay == 0.0 ? Complex(1.0) : std::polar(1.0, angular(frequency) * c.delay);
    scale.line.push_back(gain * phase);
  }
  scale.response.assign(header.response.size(), 1.0);
  scale.reference.assign(header.reference.size(), 1.0);
  multiply(scale.response, header, header.response, c.response_gain, "gain");
  multiply(scale.reference, header, header.reference, c.reference_gain, "gain_reference");
  multiply(scale.response, header, header.response, minus_one(c.flip), "flip");
  multiply(scale.reference, header, header.reference, minus_one(c.flip_reference), "flip_reference");
  return scale;
}

/// "flip 1:+Y 2:+Y"
template <class Item, class Text>
void describe(std::vector<std::string>& out, const char* key, const std::vector<Item>& items, Text text) {
  if (items.empty()) return;
  std::string phrase = key;
  for (const Item& item : items) phrase += " " + text(item);
  out.push_back(std::move(phrase));
}

void describe(std::vector<std::string>& out, const Corrections& c) {
  const auto label = [](const Dof& dof) { return dof.name(); };
  const auto number = [](const DofNumber& n) { return fmt::format("{} {:g}", n.dof.name(), n.value); };
  const auto rename = [](const DofRename& n) { return n.from.name() + " to " + n.to.name(); };
  if (c.frequency_scale != 1.0) out.push_back(fmt::format("frequencies times {:.9g}", c.frequency_scale));
  describe(out, "rename", c.rename, rename);
  describe(out, "rename_reference", c.rename_reference, rename);
  if (c.conjugate) out.push_back("conjugate");
  if (c.delay != 0.0) out.push_back(fmt::format("delay {:g} s", c.delay));
  if (c.gain != 1.0) out.push_back(fmt::format("gain {:g}", c.gain));
  describe(out, "gain", c.response_gain, number);
  describe(out, "gain_reference", c.reference_gain, number);
  describe(out, "flip", c.flip, label);
  describe(out, "flip_reference", c.flip_reference, label);
  constexpr std::array sensors = {"sensor_mass", "sensor_mass of triaxial sensors", "sensor_mass of fixed sensors"};
  describe(out, sensors[static_cast<std::size_t>(c.sensors)], c.sensor_mass, number);
}

}  // namespace

bool Corrections::any() const { return scales(*this) || !sensor_mass.empty(); }

std::unique_ptr<FrfSource> corrected(std::unique_ptr<FrfSource> source, const Corrections& corrections) {
  if (!corrections.any()) return source;
  FrfHeader header = relabelled(source->header(), corrections);
  describe(header.changes, corrections);
  EntryScale scale = entry_scale(header, corrections);
  source = scaled_source(std::move(source), std::move(header), std::move(scale));
  if (!corrections.sensor_mass.empty()) source = unloaded_source(std::move(source), corrections.sensor_mass, corrections.sensors);
  return source;
}

std::unique_ptr<FrfSource> reinterpreted(std::unique_ptr<FrfSource> source, Quantity quantity) {
  FrfHeader header = source->header();
  const Quantity stated = header.quantity;
  if (stated == quantity) return source;
  header.quantity = quantity;
  header.changes.push_back(taken_for(quantity, stated));
  EntryScale scale{.conjugate = false,
                   .line = {},
                   .response = std::vector<double>(header.response.size(), 1.0),
                   .reference = std::vector<double>(header.reference.size(), 1.0)};
  for (const double frequency : header.frequency_hz) {
    scale.line.push_back(to_receptance(quantity, frequency) * from_receptance(stated, frequency));
  }
  return scaled_source(std::move(source), std::move(header), std::move(scale));
}

}  // namespace jointid::frf
