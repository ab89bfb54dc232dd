#include "records/estimate/frf_options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace jointid::records {
namespace {

[[noreturn]] void refuse_option(const char* place, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::usage, {}, place, std::move(problem), std::move(remedy)});
}

}  // namespace

void validate(const FrfOptions& options) {
  const auto share = [](const char* place, double value) {
    if (!(value > 0.0 && value < 1.0))
      refuse_option(place, fmt::format("{:g} is no share between 0 and 1", value), "give e.g. 0.1");
  };
  const auto positive = [](const char* place, std::optional<double> value) {
    if (value && !(*value > 0.0 && std::isfinite(*value)))
      refuse_option(place, fmt::format("{:g} s is not above 0", *value), "give seconds");
  };
  share("trigger", options.hammer.trigger);
  share("second peak", options.hammer.second_peak);
  positive("block", options.segments ? std::optional(options.segments->block_s) : options.hammer.block_s);
  positive("force window", options.force_window_s);
  positive("exponential window", options.decay_time_s);
  if (!(options.hammer.pretrigger_s >= 0.0)) refuse_option("pretrigger", "is below 0", "give seconds");
  if (!options.segments) return;
  if (!(options.segments->overlap >= 0.0 && options.segments->overlap < 1.0)) {
    refuse_option("overlap", fmt::format("{:g} is not from 0 to below 1", options.segments->overlap), "give e.g. 0.5");
  }
  if (options.force_window_s || options.decay_time_s)
    refuse_option("windows", "force and exponential windows are for hits of a hammer", "leave them out for segments");
}

}  // namespace jointid::records
