#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/text.hpp"
#include "frf/set/virtual_node.hpp"
#include "ident/scene/scene_sections.hpp"
#include "scene/reader.hpp"

namespace jointid::ident {
namespace {

const std::vector<std::string> planes = {"XY", "YZ", "XZ"};

virtualpoint::Vector read_vector(const scene::Item& item) {
  const std::vector<scene::Item> numbers = item.list();
  if (numbers.size() != 3) item.fail("a vector has three numbers, found " + std::to_string(numbers.size()), "write [x, y, z]");
  return {numbers[0].number(), numbers[1].number(), numbers[2].number()};
}

virtualpoint::Vector read_direction(const scene::Item& item) {
  constexpr double rounding = 1e-3;
  virtualpoint::Vector direction = read_vector(item);
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  if (!(std::abs(length - 1.0) <= rounding)) {
    const std::string unit = comma_list(direction, [&](double number) { return scene::number_text(number / length); });
    item.fail("the direction has the length " + scene::number_text(length) + ", not 1",
              length > 0.0 ? "write [" + unit + "], and gains under [data.files.\"NAME\"]"
                           : "write a unit vector, e.g. [0.6, 0.8, 0.0]");
  }
  for (double& number : direction) number /= length;
  return direction;
}

std::int64_t read_number(const scene::Item& item) {
  const std::string name = item.text_not_empty();
  std::int64_t number = 0;
  const char* end = name.data() + name.size();
  if (name.starts_with("VP")) {
    const auto [last, error] = std::from_chars(name.data() + 2, end, number);
    if (error == std::errc() && last == end && number >= 1 && number <= frf::largest_virtual_point) return number;
  }
  item.fail("'" + name + "' is no name of a virtual point", "write VP and a number from 1 on: \"VP1\"");
}

std::vector<virtualpoint::InterfaceMode> read_modes(const scene::Table& table) {
  std::vector<virtualpoint::InterfaceMode> modes = virtualpoint::rigid_modes();
  if (const auto plane = table.find("plane")) modes = virtualpoint::plane_modes(plane->word(planes));
  const auto flexible = table.find("flexible");
  if (!flexible) return modes;
  const std::vector<std::string>& all = virtualpoint::mode_names();
  const std::vector<std::string> words(all.begin() + 6, all.end());
  for (const scene::Item& item : flexible->list_not_empty()) {
    const std::string word = item.word(words);
    const auto mode = static_cast<virtualpoint::InterfaceMode>(std::ranges::find(all, word) - all.begin());
    if (std::ranges::find(modes, mode) != modes.end()) item.fail("'" + word + "' is there twice", "name each mode once");
    modes.push_back(mode);
  }
  return modes;
}

/// The channel that a key of a table names, and the sign of the key beside that of the channel.
std::pair<virtualpoint::Channel*, double> channel_of(std::vector<virtualpoint::Channel>& channels, const std::string& key,
                                                     const scene::Item& value, const char* list) {
  const frf::Dof dof = value.here([&] { return frf::Dof::parse(key); });
  const auto found =
      std::ranges::find_if(channels, [&](const virtualpoint::Channel& channel) { return channel.dof.same_coordinate(dof); });
  if (found == channels.end())
    value.fail(dof.name() + " is not among the " + list, std::string("name it there, or remove the key"));
  return {&*found, found->dof.sign * dof.sign};
}

/// The channels of `list` with their directions and weights.
std::vector<virtualpoint::Channel> read_channels(const scene::Table& table, const char* list, const char* directions,
                                                 const char* weights) {
  std::vector<virtualpoint::Channel> channels;
  const auto item = table.find(list);
  if (item) {
    for (const frf::Dof& dof : item->dofs()) channels.push_back({.dof = dof});
  }
  if (const auto given = table.find(directions)) {
    const scene::Table keys = given->open_table();
    for (const auto& [key, value] : keys.members()) {
      const auto [channel, sign] = channel_of(channels, key, value, list);
      virtualpoint::Vector direction = read_direction(value);
      for (double& number : direction) number *= sign;
      channel->direction = direction;
    }
  }
  if (const auto given = table.find(weights)) {
    const scene::Table keys = given->open_table();
    for (const auto& [key, value] : keys.members()) channel_of(channels, key, value, list).first->weight = value.positive();
  }
  return channels;
}

virtualpoint::VirtualPoint read_point(const scene::Table& table, const std::map<std::int64_t, virtualpoint::Vector>& positions) {
  virtualpoint::VirtualPoint point;
  point.number = read_number(table.require("name"));
  point.position = read_vector(table.require("position"));
  point.modes = read_modes(table);
  point.sensors = read_channels(table, "sensors", "directions", "weights");
  point.impacts = read_channels(table, "impacts", "impact_directions", "impact_weights");
  point.positions = positions;
  if (point.sensors.empty() && point.impacts.empty()) {
    table.itself().fail("the virtual point has neither sensors nor impacts", "name those around its interface");
  }
  for (const auto& [channels, word] : {std::pair(&point.sensors, "sensors"), std::pair(&point.impacts, "impacts")}) {
    if (channels->empty() || channels->size() >= point.modes.size()) continue;
    table.itself().fail(
        std::to_string(channels->size()) + " " + word + " cannot determine " + std::to_string(point.modes.size()) + " motions",
        std::string("name more ") + word + ", or a plane of three motions");
  }
  return point;
}

/// Throws where a channel is in two points that one file has.
void require_apart(const virtualpoint::VirtualPoint& point, const DataFile& file, const scene::Item& item) {
  for (const virtualpoint::VirtualPoint& other : file.virtual_points) {
    if (other.number == point.number)
      item.fail(virtualpoint::name(point) + " is here twice", "give it another name, or other files");
    for (const auto& [mine, theirs] : {std::pair(&point.sensors, &other.sensors), std::pair(&point.impacts, &other.impacts)}) {
      for (const virtualpoint::Channel& channel : *mine) {
        const auto same = [&](const virtualpoint::Channel& c) { return c.dof.same_coordinate(channel.dof); };
        if (std::ranges::none_of(*theirs, same)) continue;
        item.fail(channel.dof.name() + " is also in " + virtualpoint::name(other),
                  "a sensor or impact belongs to one virtual point");
      }
    }
  }
}

std::vector<DataFile*> chosen_files(const scene::Table& table, const Path& folder, const std::vector<DataFile*>& files) {
  const auto names = table.find("files");
  if (!names) return files;
  std::vector<DataFile*> chosen;
  for (const scene::Item& item : names->list_not_empty()) {
    const Path path = folder / item.text_not_empty();
    const auto found = std::ranges::find_if(files, [&](const DataFile* file) { return file->path == path; });
    if (found == files.end()) item.fail("'" + item.text() + "' is no file of [data]", "name a file as it is there");
    chosen.push_back(*found);
  }
  return chosen;
}

}  // namespace

void read_virtual_points(const scene::Table& scene, const Path& folder, const std::vector<DataFile*>& files) {
  const auto list = scene.find("virtual_points");
  if (!list) return;
  const auto nodes = scene.find("nodes");
  const std::map<std::int64_t, virtualpoint::Vector> positions =
      nodes ? read_nodes(*nodes) : std::map<std::int64_t, virtualpoint::Vector>();
  for (const scene::Item& item : list->list_not_empty()) {
    const scene::Table table = item.table({"name", "position", "plane", "flexible", "sensors", "impacts", "directions",
                                           "impact_directions", "weights", "impact_weights", "files"});
    const virtualpoint::VirtualPoint point = read_point(table, positions);
    for (DataFile* file : chosen_files(table, folder, files)) {
      require_apart(point, *file, item);
      file->virtual_points.push_back(point);
    }
  }
}

void set_virtual_noise(const std::optional<NoiseSection>& noise, const std::vector<DataFile*>& files) {
  if (!noise || noise->model == "modal") return;
  for (DataFile* file : files) {
    if (!file->virtual_points.empty()) file->virtual_noise = noise->frf_model;
  }
}

}  // namespace jointid::ident
