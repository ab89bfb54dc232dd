#include "records/file/time_axis.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "base/error.hpp"
#include "base/text.hpp"

namespace jointid::records {

double rate_of(std::span<const double> times, const std::string& file, const std::string& place) {
  const auto fail = [&](std::string problem) {
    throw InputError({ErrorKind::data, file, place, std::move(problem), "give --rate, or sample evenly"});
  };
  if (times.size() < 2) fail("less than two times");
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  if (!(step > 0.0) || !std::isfinite(step)) fail("the times do not rise");
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double even = times.front() + step * static_cast<double>(i);
    if (std::abs(times[i] - even) <= 0.01 * step) continue;
    fail(fmt::format("the times are not even: sample {} at {:g} s, by the mean step {:g} s", i + 1, times[i], even));
  }
  const double rate = 1.0 / step, round = std::strtod(digits(rate, "%.6g").c_str(), nullptr);
  return std::abs(round - rate) < 1e-6 * rate ? round : rate;
}

}  // namespace jointid::records
