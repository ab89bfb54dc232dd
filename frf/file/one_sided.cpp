#include "frf/file/one_sided.hpp"

#include <array>
#include <cmath>

#include "base/error.hpp"

namespace jointid::frf {
namespace {

constexpr std::size_t pairs = 6, fewest_lines = 2 * pairs + 4;

/// Lines at the lower end, then as many at the upper end, which mirror them where the axis goes from 0 (or the first line above it) to
/// the sampling rate.
using Ends = std::array<std::size_t, 2 * pairs>;

Ends ends_of(const std::vector<double>& hz) {
  const std::size_t first = hz[0] == 0.0 ? 1 : 0;
  Ends lines{};
  for (std::size_t i = 0; i < pairs; ++i) lines[i] = first + i, lines[2 * pairs - 1 - i] = hz.size() - 1 - i;
  return lines;
}

/// Whether the ends are multiples of one step, so that each pair adds up to the same.
bool may_mirror(const std::vector<double>& hz, const Ends& lines) {
  const double step = hz[1] - hz[0], tolerance = 1e-3 * step, rate = hz[lines.front()] + hz[lines.back()];
  for (std::size_t i = 0; i < pairs; ++i) {
    if (!(std::abs(hz[lines[i]] - static_cast<double>(i + 1) * step) <= tolerance)) return false;
    if (!(std::abs(hz[lines[i]] + hz[lines[2 * pairs - 1 - i]] - rate) <= tolerance)) return false;
  }
  return true;
}

/// Reads what ReadCount does not count: it is no data that anybody asked for.
class Uncounted : public FrfSource {
 public:
  using FrfSource::do_read;
};

}  // namespace

void require_one_sided(FrfSource& source) {
  const FrfHeader& header = source.header();
  const std::vector<double>& hz = header.frequency_hz;
  if (hz.size() < fewest_lines || header.entries() == 0) return;
  const Ends lines = ends_of(hz);
  if (!may_mirror(hz, lines)) return;
  const std::array<std::size_t, 1> one = {0};
  std::array<Complex, 2 * pairs> values{};
  (source.*&Uncounted::do_read)({lines, one, one}, values);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] *= from_receptance(header.quantity, hz[lines[i]]);
  for (std::size_t i = 0; i < pairs; ++i) {
    const Complex below = values[i], above = values[2 * pairs - 1 - i];
    const bool alike = std::abs(below - std::conj(above)) <= 1e-6 * std::abs(below);
    if (!alike || !(std::abs(below.imag()) > 1e-5 * std::abs(below))) return;
  }
  throw InputError({.kind = ErrorKind::data,
                    .file = header.file,
                    .place = {},
                    .problem = "the upper half of the lines are the conjugates of the lower half: spectra from 0 to the sampling rate",
                    .remedy = "export the lines up to half of the sampling rate"});
}

}  // namespace jointid::frf
