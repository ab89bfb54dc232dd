#include "tasks/convert/line_pieces.hpp"

#include <algorithm>
#include <numeric>

namespace jointid::tasks {
namespace {

std::vector<std::size_t> range(std::size_t first, std::size_t count) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), first);
  return all;
}

}  // namespace

bool for_each_piece(const frf::FrfHeader& header, std::size_t lines_per_piece,
                    const std::function<bool(const frf::Block&)>& visit) {
  const auto responses = range(0, header.response.size());
  const auto references = range(0, header.reference.size());
  for (std::size_t first = 0; first < header.lines(); first += lines_per_piece) {
    const auto lines = range(first, std::min(lines_per_piece, header.lines() - first));
    if (!visit({lines, responses, references})) return false;
  }
  return true;
}

std::size_t lines_per_piece(const frf::FrfHeader& header) {
  return std::max<std::size_t>(1, (std::size_t{1} << 18) / std::max<std::size_t>(1, header.entries()));
}

}  // namespace jointid::tasks
