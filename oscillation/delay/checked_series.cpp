#include "oscillation/delay/checked_series.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "base/error.hpp"

namespace jointid::oscillation {

double deviation(std::span<const double> x) {
  const Eigen::Map<const Eigen::VectorXd> values(x.data(), at(x.size()));
  return std::sqrt((values.array() - values.mean()).square().mean());
}

void check_series(std::span<const double> x, std::size_t least) {
  if (x.size() < least) {
    throw InputError({ErrorKind::data, "", "series",
                      "has " + std::to_string(x.size()) + " samples where at least " + std::to_string(least) + " are needed",
                      "record longer, or take a smaller delay or dimension"});
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i])) {
      throw InputError(
          {ErrorKind::data, "", "sample " + std::to_string(i), "is not a finite number", "cut the record round missing samples"});
    }
  }
}

void wrong_option(const std::string& name, const std::string& problem) {
  throw InputError({ErrorKind::usage, "", name, problem, ""});
}

}  // namespace jointid::oscillation
