#include "tasks/source_doubts.hpp"

#include <algorithm>
#include <numeric>

#include "frf/noise/turned_points.hpp"

namespace jointid::tasks {

std::vector<std::string> source_doubts(frf::FrfSource& source) {
  constexpr std::size_t most = 64, most_values = std::size_t{1} << 18;
  const frf::FrfHeader& header = source.header();
  std::vector<std::string> doubts = header.doubts;
  std::vector<std::size_t> responses(header.response.size()), references(header.reference.size());
  std::iota(responses.begin(), responses.end(), std::size_t{0});
  std::iota(references.begin(), references.end(), std::size_t{0});
  const std::size_t count = std::min({most, header.lines(), 1 + most_values / (1 + header.entries())});
  std::vector<Complex> values(header.entries());
  frf::TurnedPoints turned(header);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<std::size_t> line = {(2 * i + 1) * header.lines() / (2 * count)};
    source.read({line, responses, references}, values);
    turned.add(values);
  }
  if (std::string text = frf::turned_points_text(turned.found()); !text.empty()) doubts.push_back(std::move(text));
  return doubts;
}

}  // namespace jointid::tasks
