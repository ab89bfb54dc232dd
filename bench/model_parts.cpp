// FRFs of parts that are finite-element models: solid blocks of bricks by a rational Krylov basis, beside a factorisation for
// each line. docs/model-parts.md. Words: about how many coordinates.
// Promised: the largest difference is at most 1e-9 of the largest FRF, and 1,000 lines take at most a tenth of the time of the
// factorisations.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/complex.hpp"
#include "bench/bench.hpp"
#include "models/matrix_model.hpp"
#include "problems/solid/solid_matrices.hpp"

namespace {

using namespace jointid;
using namespace jointid::models;

constexpr std::size_t most_factorised = 20'000;  ///< coordinates: the difference to a factorisation is shown up to there

void compare(std::size_t about, bool quick, bench::Promises& promises) {
  const int n = std::max(2, static_cast<int>(std::lround(std::cbrt(static_cast<double>(about) / 12.0))));
  StructureMatrices matrices = problems::solid_matrices({2.1e11, 0.3, 7800.0}, {.size = {0.5, 0.25, 0.25}, .elements = {2 * n, 2 * n, n}});
  matrices.loss_factor = 0.005;
  const auto size = static_cast<std::size_t>(matrices.mass.rows());
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < 24; ++i) asked.push_back(i * (size / 24));
  std::vector<double> omega;
  for (std::size_t i = 0; i < 1000; ++i) omega.push_back(angular(200.0 + 2.8 * static_cast<double>(i)));
  const bool factorises = size <= most_factorised;
  std::unique_ptr<MatrixModel> exact;
  if (factorises) exact = std::make_unique<MatrixModel>(matrices, MatrixModel::Factors::sparse);
  MatrixModel reduced(std::move(matrices), MatrixModel::Factors::sparse);
  double start = bench::processor_seconds();
  reduced.expect({omega, omega.front(), omega.back(), asked});
  const double prepared = bench::processor_seconds() - start;
  if (reduced.reduction() == nullptr) {
    promises.holds(fmt::format("{} coordinates are reduced", size), false);
    return;
  }
  start = bench::processor_seconds();
  for (const double each : omega) reduced.receptance(each, asked, asked);
  const double lines = bench::processor_seconds() - start;
  fmt::print("{:>8} coordinates: basis of {} vectors, {} shifts, {:.2f} s; 1,000 lines {:.3f} s\n", size,
             reduced.reduction()->vectors(), reduced.reduction()->shifts(), prepared, lines);
  promises.at_most(fmt::format("{} coordinates: the error that is stated", size), reduced.reduction()->error(), 1e-9);
  if (!factorises) return;
  double worst = 0.0, factorised = 0.0;
  const std::size_t compared = quick ? 2 : 5;
  for (std::size_t i = 0; i < compared; ++i) {
    const double each = omega[i * (omega.size() - 1) / (compared - 1)];
    start = bench::processor_seconds();
    const auto expected = exact->receptance(each, asked, asked);
    factorised += (bench::processor_seconds() - start) / static_cast<double>(compared);
    const auto found = reduced.receptance(each, asked, asked);
    worst = std::max(worst, (*found - *expected).cwiseAbs().maxCoeff() / expected->cwiseAbs().maxCoeff());
  }
  fmt::print("{:>8} coordinates: a factorisation {:.3f} s\n", size, factorised);
  promises.at_most(fmt::format("{} coordinates: difference over the largest FRF", size), worst, 1e-9);
  promises.speed_at_least(fmt::format("{} coordinates: 1,000 lines by factorisations over ours", size),
                          1000.0 * factorised / (prepared + lines), 10.0);
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  if (line.words() == 0) {
    const std::vector<std::size_t> sizes = line.quick() ? std::vector<std::size_t>{700} : std::vector<std::size_t>{2000, 3500, 10000};
    for (const std::size_t size : sizes) compare(size, line.quick(), promises);
  }
  for (std::size_t i = 0; i < line.words(); ++i) compare(line.count(i, 2000, 700), line.quick(), promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[COORDINATES ...]", measure); }
