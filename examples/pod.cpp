// Proper orthogonal modes of samples in memory: two standing waves on three channels. tasks::run_pod(task) reads them from files.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "base/error.hpp"
#include "tasks/pod/run_pod.hpp"

using namespace jointid;

constexpr std::size_t channels = 3, samples = 500;

/// Fills rows of `channels` numbers, as many as fit and are left.
std::size_t next_samples(std::span<double> rows, std::size_t& done) {
  std::size_t count = 0;
  for (; count < rows.size() / channels && done < samples; ++count, ++done) {
    const double one = std::cos(2.0 * M_PI * static_cast<double>(done) / 50.0);
    const double two = 0.5 * std::cos(6.0 * M_PI * static_cast<double>(done) / 50.0);
    double* const row = &rows[count * channels];
    row[0] = 0.6 * one + 0.8 * two, row[1] = 0.8 * one - 0.6 * two, row[2] = 2.0;
  }
  return count;
}

int main() try {
  std::size_t done = 0;
  tasks::PodRecord record{{"a", "b", "c"}, {"m", "m", "m"}, 0, oscillation::RecordTriangle(channels)};
  record.triangle = oscillation::record_triangle(channels, [&](std::span<double> rows) { return next_samples(rows, done); });
  const tasks::PodResult found = tasks::run_pod(tasks::PodTask{}, std::move(record));

  const Eigen::VectorXd shares = found.pod.square_fractions();
  for (Eigen::Index k = 0; k < 2; ++k) {
    std::printf("mode %d: mean square %.6f m^2, up to here %.2f %%, shape", static_cast<int>(k + 1), found.pod.values(k),
                100.0 * shares(k));
    for (const double entry : found.pod.modes.col(k)) std::printf(" %.4f", entry);
    std::putchar('\n');
  }
  return std::abs(found.pod.values(0) - 0.5) < 1e-12 && std::abs(found.pod.values(1) - 0.125) < 1e-12 ? EXIT_SUCCESS
                                                                                                      : EXIT_FAILURE;
} catch (const InputError& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return EXIT_FAILURE;
}
