#include "records/file/time_axis.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/set/unit_label.hpp"
#include "records/file/stated_unit.hpp"
#include "records/file/time_title.hpp"

namespace jointid::records {
namespace {

constexpr double most_off = 0.01;  ///< of a step

double step_of(std::span<const double> times) {
  return times.size() < 2 ? 0.0 : (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

/// The first time that is not where even steps lead, or their number.
std::size_t first_uneven(std::span<const double> times) {
  const double step = step_of(times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!(std::abs(times[i] - times.front() - step * static_cast<double>(i)) <= most_off * step)) return i;
  }
  return times.size();
}

}  // namespace

bool are_even(std::span<const double> times) {
  const double step = step_of(times);
  return step > 0.0 && std::isfinite(step) && first_uneven(times) == times.size();
}

double rate_of(std::span<const double> times, const std::string& file, const std::string& place) {
  const auto fail = [&](std::string problem) {
    throw InputError({ErrorKind::data, file, place, std::move(problem), "give --rate (in a scene: rate), or sample evenly"});
  };
  if (times.size() < 2) fail("less than two times");
  const double step = step_of(times);
  if (!(step > 0.0) || !std::isfinite(step)) fail("the times do not rise");
  if (const std::size_t i = first_uneven(times); i < times.size()) {
    const double even = times.front() + step * static_cast<double>(i);
    fail(fmt::format("the times are not even: sample {} at {:g} s, by the mean step {:g} s", i + 1, times[i], even));
  }
  const double rate = 1.0 / step, round = std::strtod(digits(rate, "%.6g").c_str(), nullptr);
  return std::abs(round - rate) < 1e-6 * rate ? round : rate;
}

double agreed_rate(double stated_hz, double given_hz, const std::string& file, const std::string& place) {
  constexpr double digits_of_files = 1e-3;
  if (std::abs(stated_hz - given_hz) <= digits_of_files * given_hz) return given_hz;
  throw InputError({ErrorKind::data, file, place,
                    fmt::format("states {:.6g} samples per second, --rate (in a scene: rate) {:.6g}", stated_hz, given_hz),
                    "leave the rate out, or correct the file"});
}

double stated_or_given_rate(const frf::NumberColumn& times, const std::string& file, std::optional<double> given_hz) {
  const std::string place = "column " + times.name;
  const bool counts =
      given_hz && times.values.size() > 1 && times.values[1] - times.values[0] == 1.0 && stated_time_unit(times).empty();
  if (counts) return *given_hz;  // numbers of samples
  if (given_hz && !frf::states_no_unit(stated_time_unit(times)) && !seconds_of(stated_time_unit(times))) return *given_hz;
  std::vector<double> seconds = times.values;
  const double unit = seconds_per_number(times, file);
  for (double& time : seconds) time *= unit;
  if (given_hz && !are_even(seconds)) return *given_hz;
  const double stated_hz = rate_of(seconds, file, place);
  return given_hz ? agreed_rate(stated_hz, *given_hz, file, place) : stated_hz;
}

}  // namespace jointid::records
