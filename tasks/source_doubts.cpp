#include "tasks/source_doubts.hpp"

#include <algorithm>

#include "frf/noise/turned_points.hpp"
#include "models/model_source.hpp"

namespace jointid::tasks {
namespace {

/// The first DOFs that a source has in both roles, as a header of these alone, and where they are.
struct DrivingPoints {
  frf::FrfHeader header;
  std::vector<std::size_t> responses, references;

  explicit DrivingPoints(const frf::FrfHeader& all) : header(all) {
    constexpr std::size_t most = 32;
    header.response.clear(), header.reference.clear();
    for (std::size_t r = 0; r < all.response.size() && responses.size() < most; ++r) {
      const std::size_t c = frf::find_coordinate(all.reference, all.response[r]);
      if (c == frf::npos) continue;
      responses.push_back(r), references.push_back(c);
      header.response.push_back(all.response[r]), header.reference.push_back(all.reference[c]);
    }
  }
};

std::string turned_points(frf::FrfSource& source) {
  constexpr std::size_t most_lines = 64;
  const DrivingPoints points(source.header());
  frf::TurnedPoints turned(points.header);
  std::vector<Complex> values(points.header.entries());
  const std::size_t lines = points.header.lines(), count = values.empty() ? 0 : std::min(most_lines, lines);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<std::size_t> line = {(2 * i + 1) * lines / (2 * count)};
    source.read({line, points.responses, points.references}, values);
    turned.add(values);
  }
  return frf::turned_points_text(turned.found());
}

}  // namespace

std::vector<std::string> source_doubts(frf::FrfSource& source) {
  std::vector<std::string> doubts = source.header().doubts;
  if (models::is_model(source.header())) return doubts;
  if (std::string text = turned_points(source); !text.empty()) doubts.push_back(std::move(text));
  return doubts;
}

}  // namespace jointid::tasks
