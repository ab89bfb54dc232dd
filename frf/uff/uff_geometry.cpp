#include "frf/uff/uff_geometry.hpp"

#include <cmath>
#include <set>

#include "frf/uff/uff_coordinate_systems.hpp"
#include "frf/uff/uff_text.hpp"

namespace jointid::frf::uff {
namespace {

/// Calls `use(line)` for every line of the dataset that is not blank.
template <class Use>
void for_each_line(ByteFile& file, const Dataset& dataset, Use use) {
  std::string_view line;
  file.seek(dataset.payload_begin);
  while (file.position() < dataset.payload_end && file.next_line(line)) {
    if (!trim(line).empty()) use(line);
  }
}

class NodeReader {
 public:
  NodeReader(const CoordinateSystems& systems, std::vector<Node>& nodes, std::set<std::int64_t>& known)
      : systems_(systems), nodes_(nodes), known_(known) {}

  void use(const Dataset& dataset, std::string_view line, double length) {
    if (dataset.number == 15) {
      begin(dataset, line);
      finish(dataset, line, 40, 13, length);
    } else if (!open_) {
      begin(dataset, line);
      open_ = true;
    } else {
      finish(dataset, line, 0, 25, length);
      open_ = false;
    }
  }

 private:
  void begin(const Dataset& dataset, std::string_view line) {
    const auto id = parse_integer(column(line, 0, 10));
    const auto defined_in = parse_integer(column(line, 10, 10)), displaced_in = parse_integer(column(line, 20, 10));
    if (!id || !defined_in || !displaced_in || column(line, 0, 10).empty()) fail(dataset, line);
    id_ = *id;
    defined_in_ = *defined_in;
    displaced_in_ = *displaced_in;
  }

  void finish(const Dataset& dataset, std::string_view line, std::size_t begin, std::size_t width,
              double length) {
    std::array<double, 3> local{};
    const auto texts = three_fields(line, begin, width);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = parse_real(texts[i]);
      if (!value || !std::isfinite(*value)) fail(dataset, line);
      local[i] = *value;
    }
    const auto position = systems_.global(defined_in_, local, length);
    if (position && known_.insert(id_).second) nodes_.push_back({id_, *position, systems_.axes(displaced_in_, *position)});
  }

  [[noreturn]] static void fail(const Dataset& dataset, std::string_view line) {
    dataset.place.fail("nodes", "'" + to_utf8(one_byte_per_column(trim(line))) + "' is not a node",
                       "correct the line or leave the geometry out");
  }

  const CoordinateSystems& systems_;
  std::vector<Node>& nodes_;
  std::set<std::int64_t>& known_;
  std::int64_t id_ = 0, defined_in_ = 0, displaced_in_ = 0;
  bool open_ = false;
};

}  // namespace

std::vector<Node> read_nodes(ByteFile& file, const std::vector<Dataset>& datasets, const UnitTable& units) {
  const CoordinateSystems systems(file, datasets, units);
  std::vector<Node> nodes;
  std::set<std::int64_t> known;
  for (const Dataset& dataset : datasets) {
    if ((dataset.number != 15 && dataset.number != 2411) || dataset.binary) continue;
    const double length = units.at(dataset).length;
    NodeReader reader(systems, nodes, known);
    for_each_line(file, dataset, [&](std::string_view line) { reader.use(dataset, line, length); });
  }
  return nodes;
}

}  // namespace jointid::frf::uff
