#include "ident/scene/drawn_lines.hpp"

#include <limits>

#include "scene/if_readable.hpp"
#include "scene/text.hpp"

namespace jointid::ident {
namespace {

frf::NodeLine read_line(const scene::Item& item) {
  const std::vector<scene::Item> nodes = item.list();
  const std::string form = "write [4, 5], the numbers of two nodes";
  if (nodes.size() != 2) item.fail("a line has two nodes, found " + std::to_string(nodes.size()), form);
  frf::NodeLine line{};
  for (std::size_t i = 0; i < 2; ++i) line[i] = nodes[i].whole(0, std::numeric_limits<int>::max());
  if (line[0] == line[1]) item.fail("a line from node " + std::to_string(line[0]) + " to itself", form);
  return line;
}

}  // namespace

std::vector<frf::NodeLine> read_drawn_lines(const scene::Table& scene) {
  std::vector<frf::NodeLine> lines;
  const auto geometry = scene.find("geometry");
  if (!geometry) return lines;
  const auto list = geometry->table({"lines"}).find("lines");
  if (!list) return lines;
  for (const scene::Item& item : list->list()) lines.push_back(read_line(item));
  return lines;
}

std::vector<frf::NodeLine> readable_lines(const std::string& text) {
  std::vector<frf::NodeLine> lines;
  scene::if_readable([&] {
    const scene::Value value = scene::parse_toml(text, {});
    const std::string name;
    const scene::Table table = scene::Item(value, name, {}, {}).open_table();
    lines = read_drawn_lines(table);
  });
  return lines;
}

}  // namespace jointid::ident
