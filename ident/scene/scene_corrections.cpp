#include <algorithm>

#include "ident/scene/scene_sections.hpp"

namespace jointid::ident {
namespace {

constexpr double longest_delay = 1.0;  ///< s

/// A DOF that is a key of a table, in the place of its value.
frf::Dof dof_of_key(const std::string& key, const scene::Item& value) {
  return value.here([&] { return frf::Dof::parse(key); });
}

void require_new(const std::vector<frf::Dof>& dofs, const frf::Dof& dof, const scene::Item& item) {
  if (frf::has(dofs, dof))
    item.fail("the coordinate of " + dof.name() + " is here twice", "name each coordinate once");
}

/// A table of numbers > 0 by DOF.
std::vector<frf::DofNumber> read_numbers(const scene::Item& item) {
  std::vector<frf::DofNumber> numbers;
  std::vector<frf::Dof> seen;
  const scene::Table table = item.open_table();
  for (const auto& [key, value] : table.members()) {
    const frf::Dof dof = dof_of_key(key, value);
    require_new(seen, dof, value);
    seen.push_back(dof);
    numbers.push_back({dof, value.positive()});
  }
  if (numbers.empty()) item.fail("the table is empty", "write e.g. { \"4:+Y\" = 1.02 }");
  return numbers;
}

std::vector<frf::DofRename> read_renames(const scene::Item& item) {
  std::vector<frf::DofRename> renames;
  std::vector<frf::Dof> old_names, new_names;
  const scene::Table table = item.open_table();
  for (const auto& [key, value] : table.members()) {
    const frf::DofRename rename{dof_of_key(key, value), value.dof()};
    require_new(old_names, rename.from, value);
    require_new(new_names, rename.to, value);
    old_names.push_back(rename.from);
    new_names.push_back(rename.to);
    renames.push_back(rename);
  }
  if (renames.empty()) item.fail("the table is empty", "write e.g. { \"4:+Y\" = \"5:+Y\", \"5:+Y\" = \"4:+Y\" }");
  return renames;
}

double read_delay(const scene::Item& item) {
  const double delay = item.number();
  if (delay < -longest_delay || delay > longest_delay) {
    item.fail("a delay of " + scene::number_text(delay) + " s is longer than " + scene::number_text(longest_delay) + " s",
              "give it in seconds: 20e-6 is 20 microseconds");
  }
  return delay;
}

double read_frequency_scale(const scene::Item& item) {
  const double scale = item.number();
  if (!(scale >= 0.5 && scale <= 2.0)) {
    item.fail("frequency_scale = " + scene::number_text(scale) + " is not between 0.5 and 2",
              "give true frequency / frequency of the file, e.g. 0.99");
  }
  return scale;
}

void read_gain(const scene::Item& item, frf::Corrections& corrections) {
  if (item.is_table()) {
    corrections.response_gain = read_numbers(item);
  } else {
    corrections.gain = item.positive();
  }
}

void read_sensors(const scene::Table& table, frf::Corrections& corrections) {
  static const std::vector<std::string> words = {"roving", "triaxial", "fixed"};
  const auto mass = table.find("sensor_mass");
  if (mass) corrections.sensor_mass = read_numbers(*mass);
  const auto sensors = table.find("sensors");
  if (!sensors) return;
  const auto chosen = std::ranges::find(words, sensors->word(words)) - words.begin();
  corrections.sensors = static_cast<frf::SensorsOn>(chosen);
  if (!mass) sensors->fail("sensors is given without sensor_mass", "give their masses, too");
}

}  // namespace

std::vector<std::string> correction_keys() {
  return {"frequency_scale", "rename", "rename_reference", "conjugate", "delay", "gain", "gain_reference",
          "flip",            "flip_reference", "sensor_mass", "sensors"};
}

frf::Corrections read_corrections(const scene::Table& table) {
  frf::Corrections corrections;
  if (const auto item = table.find("frequency_scale")) corrections.frequency_scale = read_frequency_scale(*item);
  if (const auto item = table.find("rename")) corrections.rename = read_renames(*item);
  if (const auto item = table.find("rename_reference")) corrections.rename_reference = read_renames(*item);
  if (const auto item = table.find("conjugate")) corrections.conjugate = item->boolean();
  if (const auto item = table.find("delay")) corrections.delay = read_delay(*item);
  if (const auto item = table.find("gain")) read_gain(*item, corrections);
  if (const auto item = table.find("gain_reference")) corrections.reference_gain = read_numbers(*item);
  if (const auto item = table.find("flip")) corrections.flip = item->dofs();
  if (const auto item = table.find("flip_reference")) corrections.flip_reference = item->dofs();
  read_sensors(table, corrections);
  return corrections;
}

}  // namespace jointid::ident
