#include <algorithm>
#include <array>

#include "ident/scene/scene_sections.hpp"

namespace jointid::ident {
namespace {

const std::array<std::string, 3> sharing_words = {"files", "none", "all"};
const std::array<std::string, 2> role_words = {"response", "reference"};

Sharing read_sharing(const scene::Table& table) {
  const auto item = table.find("shared");
  if (!item) return Sharing::files;
  return static_cast<Sharing>(std::ranges::find(sharing_words, item->word(sharing_words)) - sharing_words.begin());
}

ErrorFiles all_of(const std::vector<PlacedFile>& files) {
  ErrorFiles out;
  for (const PlacedFile& file : files) {
    std::vector<std::size_t>& of = file.of_assembly ? out.assembly : out.substructures;
    if (of.empty() || of.back() != file.number) of.push_back(file.number);
  }
  return out;
}

ErrorFiles read_error_files(const scene::Item& list, const std::vector<PlacedFile>& files) {
  std::vector<std::string> names;
  for (const PlacedFile& file : files) names.push_back(file.name);
  ErrorFiles out;
  for (const scene::Item& item : list.list_not_empty()) {
    const auto place = static_cast<std::size_t>(std::ranges::find(names, item.word(names)) - names.begin());
    const PlacedFile& file = files[place];
    std::vector<std::size_t>& of = file.of_assembly ? out.assembly : out.substructures;
    if (std::ranges::find(of, file.number) != of.end())
      item.fail("the file is named twice", "name each file, or one of its runs, once");
    of.push_back(file.number);
  }
  return out;
}

GainPrior read_gain_prior(const scene::Item& item, const std::vector<PlacedFile>& files) {
  const scene::Table table = item.table({"dofs", "files", "role", "gain", "delay", "angle", "shared"});
  GainPrior prior;
  if (const auto dofs = table.find("dofs")) prior.dofs = dofs->dofs();
  const auto named = table.find("files");
  prior.files = named ? read_error_files(*named, files) : all_of(files);
  if (const auto role = table.find("role")) prior.of_reference = role->word(role_words) == role_words[1];
  if (const auto gain = table.find("gain")) prior.gain = gain->not_negative();
  if (const auto delay = table.find("delay")) prior.delay = delay->positive();
  if (const auto angle = table.find("angle")) prior.angle = angle->positive();
  if (!table.find("gain") && prior.delay == 0.0 && prior.angle == 0.0) {
    item.fail("neither gain nor delay nor angle is given",
              "write gain = 0.01 for gains of 1 ± 0.01, gain = 0 for exact ones, delay = 1e-6 for delays of 0 ± 1e-6 s, angle = "
              "0.02 for angles of 0 ± 0.02 rad");
  }
  prior.shared = read_sharing(table);
  return prior;
}

MassPrior read_mass_prior(const scene::Item& item, const std::vector<PlacedFile>& files) {
  const scene::Table table = item.table({"dofs", "files", "mass", "deviation", "shared"});
  MassPrior prior;
  prior.dofs = table.require("dofs").dofs();
  prior.files = read_error_files(table.require("files"), files);
  prior.mass = table.require("mass").not_negative();
  if (const auto deviation = table.find("deviation")) prior.deviation = deviation->not_negative();
  if (prior.mass == 0.0 && prior.deviation == 0.0)
    item.fail("neither mass nor deviation is above 0", "give the mass in kg, 3e-3");
  prior.shared = read_sharing(table);
  return prior;
}

/// The mass itself is removed as sensor_mass of the file does.
void remove_mass(const scene::Item& item, const MassPrior& prior, DataFile& file) {
  if (prior.mass == 0.0) return;
  for (const frf::Dof& dof : prior.dofs) {
    const bool there =
        std::ranges::any_of(file.corrections.sensor_mass, [&](const auto& of) { return of.dof.same_coordinate(dof); });
    if (there) {
      item.fail("the sensor at " + dof.name() + " in " + file.path.filename().string() + " has a mass already",
                "give each mass once, here or as sensor_mass of the file");
    }
    file.corrections.sensor_mass.push_back({dof, prior.mass});
  }
}

void remove_mass_of_all_runs(const scene::Item& item, const MassPrior& prior, DataFile& file) {
  remove_mass(item, prior, file);
  for (DataFile& run : file.repeats) remove_mass(item, prior, run);
}

}  // namespace

void read_systematic_errors(const scene::Table& table, const std::vector<PlacedFile>& files, DataSection& data) {
  if (const auto gains = table.find("gains")) {
    for (const scene::Item& item : gains->list_not_empty()) data.gains.push_back(read_gain_prior(item, files));
  }
  const auto masses = table.find("masses");
  if (!masses) return;
  for (const scene::Item& item : masses->list_not_empty()) {
    const MassPrior prior = read_mass_prior(item, files);
    for (const std::size_t i : prior.files.substructures) remove_mass_of_all_runs(item, prior, data.substructures[i]);
    for (const std::size_t i : prior.files.assembly) remove_mass_of_all_runs(item, prior, data.assembly[i]);
    if (prior.deviation > 0.0) data.masses.push_back(prior);
  }
}

}  // namespace jointid::ident
