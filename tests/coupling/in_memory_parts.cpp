#include "in_memory_parts.hpp"

#include <numeric>

#include "problems/structure/response.hpp"

namespace jointid::coupling {

Part part_of(const std::string& name, frf::FrfSet set, bool reciprocity) {
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  set.header.file = name;
  sources.push_back(frf::from_memory(std::move(set)));
  return {name, std::make_shared<frf::FrfSystem>(name, std::move(sources), frf::Composition::merged, reciprocity)};
}

frf::FrfSet receptances(const problems::Structure& structure, const std::vector<double>& frequency_hz) {
  return problems::frequency_response(
      structure, {.response = structure.dofs(), .reference = structure.dofs(), .frequency_hz = frequency_hz});
}

frf::FrfSet read_all(AssemblyReader& reader) {
  const auto all = [](std::size_t count) {
    std::vector<std::size_t> out(count);
    std::iota(out.begin(), out.end(), std::size_t{0});
    return out;
  };
  frf::FrfSet set{.header = reader.header(), .values = {}, .variance = {}, .coherence = {}};
  const auto lines = all(set.header.lines()), rows = all(set.header.response.size()), columns = all(set.header.reference.size());
  const frf::Block block{lines, rows, columns};
  set.values.resize(block.size());
  if (set.header.noise == frf::NoiseRecord::variance) set.variance.resize(block.size());
  reader.read(block, set.values, set.variance);
  return set;
}

frf::FrfSet couple_all(const std::vector<Part>& parts, const Assembly& assembly, const Options& options) {
  AssemblyReader reader(parts, assembly, options, "test");
  return read_all(reader);
}

double largest_difference(const frf::FrfSet& found, const std::vector<frf::Dof>& names, const frf::FrfSet& expected) {
  double worst = 0.0;
  for (std::size_t line = 0; line < expected.header.lines(); ++line) {
    double largest = 0.0, difference = 0.0;
    for (std::size_t r = 0; r < names.size(); ++r) {
      for (std::size_t c = 0; c < names.size(); ++c) {
        const std::size_t row = frf::find_coordinate(found.header.response, names[r]),
                          column = frf::find_coordinate(found.header.reference, names[c]);
        if (row == frf::npos || column == frf::npos) return HUGE_VAL;
        const Complex value = expected.values[expected.index(line, r, c)];
        largest = std::max(largest, std::abs(value));
        difference = std::max(difference, std::abs(found.values[found.index(line, row, column)] - value));
      }
    }
    worst = std::max(worst, difference / largest);
    if (std::isnan(difference)) return HUGE_VAL;
  }
  return worst;
}

frf::Dof y(std::int64_t node, int sign) { return {.node = node, .direction = frf::Direction::y, .sign = sign}; }

PlacedDof placed(const std::string& text) { return parse_placed_dof(text); }

}  // namespace jointid::coupling
