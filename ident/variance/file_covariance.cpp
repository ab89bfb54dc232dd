#include "ident/variance/file_covariance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/eigen.hpp"
#include "frf/noise/variance_law.hpp"
#include "ident/scene/variance_origin.hpp"

namespace jointid::ident {
namespace {

using Eigen::MatrixXcd;
using Eigen::VectorXcd;

/// The same of samples of `freedom` degrees each.
CovarianceLaw law_of(const std::vector<CovarianceSample>& samples, Eigen::Index size, double freedom) {
  constexpr double enough = 3.0;  // degrees of freedom a response
  const auto is_known = [](const CovarianceSample& s, Eigen::Index r) {
    return std::isfinite(s.frf[r].real()) && std::isfinite(s.covariance(r, r).real());
  };
  std::vector<Eigen::Index> some;
  for (Eigen::Index r = 0; r < size; ++r) {
    const auto count = std::ranges::count_if(samples, [&](const CovarianceSample& s) { return is_known(s, r); });
    if (count > 0 && 2 * static_cast<std::size_t>(count) >= samples.size()) some.push_back(r);
  }
  std::vector<CovarianceSample> known;
  for (const CovarianceSample& sample : samples) {
    CovarianceSample part{sample.frf(some), sample.covariance(some, some)};
    if (part.frf.allFinite() && part.covariance.allFinite()) known.push_back(std::move(part));
  }
  if (some.empty() || static_cast<double>(known.size()) * freedom < enough * static_cast<double>(some.size())) return {};
  const CovarianceLaw fitted = fit_covariance(std::move(known));
  CovarianceLaw law{MatrixXcd::Zero(size, size), MatrixXcd::Zero(size, size)};
  law.proportional(some, some) = fitted.proportional;
  law.constant(some, some) = fitted.constant;
  return law;
}

}  // namespace

bool covariances_count(const frf::FrfSource& source, const Scene& scene) {
  if (!source.has_covariance()) return false;
  const VarianceOrigin origin = variance_origin(scene, source.header());
  return origin == VarianceOrigin::variance || origin == VarianceOrigin::repeats;
}

VectorXcd StoredGroup::frf(std::size_t line) const { return Eigen::Map<const VectorXcd>(values.data() + line * size, at(size)); }

MatrixXcd StoredGroup::covariance(std::size_t line) const {
  return Eigen::Map<const MatrixXcd>(covariances.data() + line * size * size, at(size), at(size)).transpose();
}

StoredGroup read_stored(frf::FrfSource& source, const std::vector<std::size_t>& responses, std::size_t reference,
                        const std::vector<std::size_t>& lines) {
  const std::size_t size = lines.size() * responses.size();
  StoredGroup out{std::vector<Complex>(size), std::vector<Complex>(size * responses.size()), responses.size()};
  const frf::Block block{lines, responses, std::span(&reference, 1)};
  source.read(block, out.values);
  source.read_covariance(block, out.covariances);
  return out;
}

double freedom_of(const frf::FrfHeader& header) {
  if (header.repeats > 1) return static_cast<double>(header.repeats - 1);
  return std::max(0.0, header.averages - 1.0);
}

CovarianceSample sample_of(const StoredGroup& stored, std::size_t i, const frf::FrfHeader& header, std::size_t line) {
  const double factor = frf::squared_factor(header.quantity, header.frequency_hz[line]);
  return {stored.frf(i) / std::sqrt(factor), stored.covariance(i) / factor};
}

CovarianceLaw law_of(const std::vector<CovarianceSample>& samples, const frf::FrfHeader& header, std::size_t responses) {
  const double freedom = freedom_of(header);
  return law_of(samples, at(responses), freedom > 0.0 ? freedom : static_cast<double>(responses));
}

}  // namespace jointid::ident
