#include <algorithm>
#include <array>

#include "laws/scene/sections.hpp"

namespace jointid::laws {
namespace {

/// A name or a list of names.
std::vector<scene::Item> one_or_several(const scene::Item& item) {
  return item.is_list() ? item.list_not_empty() : std::vector<scene::Item>{item};
}

/// A file for each harmonic; one alone holds them all.
std::vector<ident::DataFile> read_files(const scene::Item& item, const ident::Path& folder, std::size_t harmonics,
                                        std::vector<std::string>& names) {
  std::vector<ident::DataFile> files;
  for (const scene::Item& name : one_or_several(item)) {
    names.push_back(name.text_not_empty());
    files.push_back({folder / names.back(), {}});
  }
  if (files.size() == 1) {
    names.resize(names.size() + harmonics - 1, names.back());
    files.resize(harmonics, files.front());
  }
  if (files.size() != harmonics) {
    item.fail(
        std::to_string(files.size()) + " files for " + std::to_string(harmonics) + " harmonics",
        "give one file, or one for each number of harmonics in their order; lines are at n times the frequency of the force");
  }
  return files;
}

std::vector<int> read_harmonics(const scene::Table& table) {
  const auto item = table.find("harmonics");
  if (!item) return {1};
  std::vector<int> numbers;
  for (const scene::Item& number : item->list_not_empty()) {
    numbers.push_back(number.whole(1, 100));
    if (numbers.size() > 1 && numbers[numbers.size() - 2] >= numbers.back())
      number.fail("harmonics do not ascend", "give them in ascending order, none twice, with their files in the same order");
  }
  return numbers;
}

void read_force(const scene::Table& table, const ident::Path& folder, ForceLevel& level, std::vector<std::string>& names) {
  const scene::Item dofs = table.require("force_dofs");
  level.force_dofs = dofs.dofs();
  const auto files = table.find("forces"), amplitude = table.find("amplitude");
  if (files.has_value() == amplitude.has_value()) {
    table.itself().fail(files ? "there are both forces and amplitude" : "the force is not given",
                        "give forces (files of the measured phasors, N) or amplitude (N, phase 0)");
  }
  if (files) {
    const auto each = read_files(*files, folder, level.harmonics.size(), names);
    for (std::size_t i = 0; i < each.size(); ++i) level.harmonics[i].forces = each[i];
  } else {
    level.amplitude = amplitude->positive();
  }
  const auto per_force = table.find("per_force");
  level.per_force = per_force && per_force->boolean();
  if (level.force_dofs.size() == 1) return;
  if (amplitude) amplitude->fail("one amplitude for several force DOFs", "give files of their phasors as forces");
  if (level.per_force) per_force->fail("responses over which of several forces?", "give phasors of the responses themselves");
}

/// Keys that say something of time records.
const std::vector<std::string> of_records = {"channels", "rate", "time", "lines", "settle", "sweep", "periods"};

void read_lines(const scene::Item& item, LevelRecords& records) {
  for (const scene::Item& hz : item.list_not_empty()) records.lines_hz.push_back(hz.positive());
  if (records.sweep) item.fail("a sweep has no line of its own", "remove lines: its phasors are taken at those of the parts");
  if (records.lines_hz.size() != records.files.size()) {
    item.fail(std::to_string(records.lines_hz.size()) + " lines for " + std::to_string(records.files.size()) + " records",
              "give the frequency of the force of each record in Hz, in the order of the files, or none: it is found");
  }
}

void read_records(const scene::Table& table, const ident::Path& folder, ForceLevel& level) {
  for (const char* key : {"responses", "forces", "amplitude", "per_force", "amplitudes"}) {
    if (const auto both = table.find(key))
      both->fail("there are records, too", "remove one: phasors of responses and forces are taken of the records");
  }
  LevelRecords records;
  for (const scene::Item& file : one_or_several(table.require("records")))
    records.files.push_back(folder / file.text_not_empty());
  level.force_dofs = table.require("force_dofs").dofs();
  if (const auto channels = table.find("channels")) {
    for (const scene::Item& channel : channels->list_not_empty())
      records.options.channels.push_back(channel.here([&] { return records::parse_channel(channel.text_not_empty()); }));
  }
  if (const auto rate = table.find("rate")) records.options.rate_hz = rate->positive();
  if (const auto time = table.find("time")) records.options.time = time->text_not_empty();
  if (const auto settle = table.find("settle")) records.settle_s = settle->not_negative();
  if (const auto sweep = table.find("sweep")) records.sweep = sweep->boolean();
  if (const auto periods = table.find("periods")) {
    if (!records.sweep) periods->fail("steady records are one window each", "remove it, or write sweep = true");
    records.periods = periods->whole(8, 10000);
  }
  if (const auto lines = table.find("lines")) read_lines(*lines, records);
  level.records = std::move(records);
}

const std::array<std::string, 2> amplitude_words = {"peak", "rms"};

ForceLevel read_level(const scene::Item& item, const ident::Path& folder, std::size_t number, std::vector<std::string>& names) {
  const scene::Table table =
      item.table({"name", "harmonics", "responses", "forces", "amplitude", "force_dofs", "per_force", "amplitudes", "records",
                  "channels", "rate", "time", "lines", "settle", "sweep", "periods"});
  ForceLevel level;
  level.name = "level " + std::to_string(number);
  if (const auto name = table.find("name")) level.name = name->text_not_empty();
  for (const int harmonic : read_harmonics(table)) level.harmonics.push_back({harmonic, {}, {}});
  if (table.find("records")) {
    read_records(table, folder, level);
    return level;
  }
  for (const std::string& key : of_records) {
    if (const auto found = table.find(key))
      found->fail("there are no records that it could apply to", "name files of time records, or remove it");
  }
  const auto responses = table.find("responses");
  level.planned = !responses;
  if (responses) {
    const auto files = read_files(*responses, folder, level.harmonics.size(), names);
    for (std::size_t i = 0; i < files.size(); ++i) level.harmonics[i].responses = files[i];
  } else if (const auto forces = table.find("forces")) {
    forces->fail("there are no responses", "give responses, or for a level that is only planned an amplitude instead of forces");
  }
  read_force(table, folder, level, names);
  if (const auto amplitudes = table.find("amplitudes")) level.rms = amplitudes->word(amplitude_words) == "rms";
  if (level.amplitude) level.name += level.name.starts_with("level ") ? " (" + scene::number_text(*level.amplitude) + " N)" : "";
  if (level.per_force && level.harmonics.front().harmonic != 1) {
    table.require("per_force")
        .fail("responses over the force of harmonic 1, which is not there", "give the files of harmonic 1 too");
  }
  return level;
}

}  // namespace

void read_levels(const scene::Item& item, const ident::Path& folder, LawScene& scene, std::vector<std::string>& names) {
  for (const scene::Item& level : item.list_not_empty()) {
    scene.levels.push_back(read_level(level, folder, scene.levels.size() + 1, names));
  }
}

std::vector<ident::FurtherFile> level_files(LawScene& scene, const std::vector<std::string>& names) {
  std::vector<ident::FurtherFile> files;
  const auto add = [&](ident::DataFile& file) { files.push_back({names[files.size()], &file}); };
  for (ForceLevel& level : scene.levels) {
    if (level.planned || level.records) continue;
    for (HarmonicFiles& each : level.harmonics) add(each.responses);
    for (HarmonicFiles& each : level.harmonics) {
      if (each.forces) add(*each.forces);
    }
  }
  return files;
}

}  // namespace jointid::laws
