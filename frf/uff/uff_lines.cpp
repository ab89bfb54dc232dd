#include "frf/uff/uff_lines.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "frf/uff/uff_geometry.hpp"
#include "frf/uff/uff_scan.hpp"
#include "frf/uff/uff_text.hpp"

namespace jointid::frf {
namespace {

using uff::ByteFile;
using uff::Dataset;
using Nodes = std::vector<std::int64_t>;
using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

constexpr std::size_t width = 10, most_in_line = 8;

/// Records of integers, line by line.
class Records {
 public:
  Records(ByteFile& file, const Dataset& dataset) : file_(file), dataset_(dataset) { file_.seek(dataset.payload_begin); }

  bool skip() {
    std::string_view line;
    return file_.position() < dataset_.payload_end && file_.next_line(line);
  }

  /// Up to `count` numbers over as many lines as they take; fewer where the dataset ends.
  Nodes read(std::size_t count) {
    Nodes out;
    std::string_view line;
    while (out.size() < count && file_.position() < dataset_.payload_end && file_.next_line(line)) {
      for (std::size_t i = 0; i < most_in_line && out.size() < count; ++i) {
        const std::string_view cell = uff::column(line, i * width, width);
        if (cell.empty()) break;
        const auto number = uff::parse_integer(cell);
        if (!number) fail(line);
        out.push_back(*number);
      }
    }
    return out;
  }

  [[noreturn]] void fail(std::string_view line) const {
    dataset_.place.fail("lines",
                        "'" + uff::to_utf8(uff::one_byte_per_column(uff::trim(line))) + "' is no record of whole numbers",
                        "correct the line or leave the geometry out");
  }

 private:
  ByteFile& file_;
  const Dataset& dataset_;
};

/// Number and colour of the line and how many nodes it has, its name, its nodes with 0 where the pen is lifted.
void read_traces(Records& records, std::vector<NodeLine>& out) {
  for (Nodes head = records.read(3); head.size() > 1; head = records.read(3)) {
    if (!records.skip()) return;
    const Nodes nodes = records.read(static_cast<std::size_t>(std::max<std::int64_t>(0, head[1])));
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      if (nodes[i - 1] != 0 && nodes[i] != 0) out.push_back({nodes[i - 1], nodes[i]});
    }
  }
}

Edges ring(std::size_t nodes) {
  Edges edges;
  for (std::size_t i = 0; i < nodes; ++i) edges.emplace_back(i, (i + 1) % nodes);
  return edges;
}

/// Two rings of nodes one above the other.
Edges prism(std::size_t corners) {
  Edges edges;
  for (std::size_t i = 0; i < corners; ++i) {
    const std::size_t next = (i + 1) % corners;
    edges.insert(edges.end(), {{i, next}, {corners + i, corners + next}, {i, corners + i}});
  }
  return edges;
}

bool is_beam(std::int64_t descriptor) { return descriptor == 11 || (descriptor >= 21 && descriptor <= 24); }

/// By the descriptors of I-DEAS: 41 to 96 are plane, 111, 112 and 115 the linear solids.
Edges edges_of(std::int64_t descriptor, std::size_t nodes) {
  if (nodes == 2) return {{0, 1}};
  if (is_beam(descriptor) && nodes == 3) return {{0, 1}, {1, 2}};
  if (descriptor >= 41 && descriptor <= 96 && nodes >= 3) return ring(nodes);
  if (descriptor == 111 && nodes == 4) return {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  if (descriptor == 112 && nodes == 6) return prism(3);
  if (descriptor == 115 && nodes == 8) return prism(4);
  return {};
}

/// Label, descriptor, two properties, colour and how many nodes; beams have a line of their section before the nodes.
void read_elements(Records& records, std::vector<NodeLine>& out) {
  for (Nodes head = records.read(6); head.size() == 6; head = records.read(6)) {
    if (is_beam(head[1]) && !records.skip()) return;
    const Nodes nodes = records.read(static_cast<std::size_t>(std::max<std::int64_t>(0, head[5])));
    for (const auto& [from, to] : edges_of(head[1], nodes.size())) out.push_back({nodes[from], nodes[to]});
  }
}

std::vector<NodeLine> once(std::vector<NodeLine> lines) {
  std::set<NodeLine> known;
  std::erase_if(lines, [&](const NodeLine& line) {
    return line[0] == line[1] || !known.insert({std::min(line[0], line[1]), std::max(line[0], line[1])}).second;
  });
  return lines;
}

}  // namespace

std::vector<NodeLine> read_uff_lines(const std::filesystem::path& path) {
  ByteFile file(path);
  std::vector<NodeLine> lines;
  for (const Dataset& dataset : uff::scan(file)) {
    if (dataset.binary || (dataset.number != 82 && dataset.number != 2412)) continue;
    Records records(file, dataset);
    if (dataset.number == 82)
      read_traces(records, lines);
    else
      read_elements(records, lines);
  }
  return once(std::move(lines));
}

std::vector<Node> read_uff_nodes(const std::filesystem::path& path) {
  ByteFile file(path);
  const std::vector<Dataset> datasets = uff::scan(file);
  return uff::read_nodes(file, datasets, uff::UnitTable(file, datasets));
}

}  // namespace jointid::frf
