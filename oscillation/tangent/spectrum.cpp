#include "oscillation/tangent/spectrum.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/random.hpp"

namespace jointid::oscillation {
namespace {

void check(const SpectrumOptions& options, std::size_t free) {
  const auto wrong = [](const std::string& name, const std::string& problem) {
    throw InputError({ErrorKind::usage, "", name, problem, ""});
  };
  if (options.count == 0 || options.count > free)
    wrong("count", std::to_string(options.count) + " is not between 1 and " + std::to_string(free));
  if (options.blocks < 2) wrong("blocks", "are fewer than 2");
  if (options.steps < options.blocks) wrong("steps", "are fewer than blocks");
  if (!(options.step_time > 0.0)) wrong("step_time", "is not above 0");
}

Eigen::MatrixXd start(Eigen::Index size, std::size_t count, const std::vector<Eigen::Index>& free) {
  Eigen::MatrixXd tangents = Eigen::MatrixXd::Zero(size, at(count));
  for (std::size_t k = 0; k < count; ++k) {
    for (const Eigen::Index i : free) tangents(i, at(k)) = normal_numbers({}, k * 4096 + static_cast<std::uint64_t>(i))[0];
  }
  orthonormalise(tangents);
  return tangents;
}

void summarise(Spectrum& spectrum, std::size_t blocks) {
  const double n = static_cast<double>(blocks);
  for (const std::vector<double>& values : spectrum.block) {
    double mean = 0.0, square = 0.0;
    for (const double value : values) mean += value / n;
    for (const double value : values) square += (value - mean) * (value - mean);
    spectrum.exponent.push_back(mean);
    spectrum.standard_error.push_back(std::isfinite(mean) ? std::sqrt(square / (n * (n - 1.0))) : 0.0);
  }
}

}  // namespace

Eigen::VectorXd orthonormalise(Eigen::MatrixXd& columns) {
  Eigen::VectorXd length(columns.cols());
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    auto column = columns.col(k);
    const double before = column.norm();
    for (int pass = 0; pass < 2; ++pass) {
      for (Eigen::Index left = 0; left < k; ++left) column -= columns.col(left) * columns.col(left).dot(column);
    }
    length(k) = column.norm();
    if (length(k) > 1e-14 * before) {
      column /= length(k);
    } else {
      length(k) = 0.0;
      column.setZero();
    }
  }
  return length;
}

Spectrum lyapunov_spectrum(const TangentStep& step, Eigen::VectorXd state, const SpectrumOptions& options,
                           const std::vector<Eigen::Index>& free) {
  std::vector<Eigen::Index> coordinates = free;
  for (Eigen::Index i = 0; free.empty() && i < state.size(); ++i) coordinates.push_back(i);
  check(options, coordinates.size());
  Eigen::MatrixXd tangents = start(state.size(), options.count, coordinates);
  for (std::size_t k = 0; k < options.transient; ++k) {
    step(state, tangents);
    orthonormalise(tangents);
  }
  Spectrum spectrum;
  spectrum.block.assign(options.count, std::vector<double>(options.blocks, 0.0));
  const std::size_t length = options.steps / options.blocks;
  for (std::size_t b = 0; b < options.blocks; ++b) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(at(options.count));
    for (std::size_t k = 0; k < length; ++k) {
      step(state, tangents);
      sum.array() += orthonormalise(tangents).array().log();
    }
    for (std::size_t e = 0; e < options.count; ++e)
      spectrum.block[e][b] = sum(at(e)) / (static_cast<double>(length) * options.step_time);
  }
  summarise(spectrum, options.blocks);
  return spectrum;
}

}  // namespace jointid::oscillation
