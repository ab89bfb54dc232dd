// Intervals of the response of an assembly from UFF files of two noisy substructures: 200 seeds (quick: 40) of FRFs with errors
// of 1 % and the coherences that belong to them (100 averages), written as UFF 58b, read back, coupled by a joint of Ren's law.
// Promised: intervals of 1.96 deviations, told from the noisy files alone, hold real and imaginary part of harmonics 1, 3, 5 of
// the exact response in 92 to 97 % of all cases (quick: 90 to 98 %, as few seeds tell no more).
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>
#include <vector>

#include "base/temporary_file.hpp"
#include "bench/bench.hpp"
#include "frf/set/frf_source.hpp"
#include "frf/set/frf_system.hpp"
#include "frf/uff/uff_file.hpp"
#include "friction/law/laws.hpp"
#include "response/harmonic/deviations.hpp"
#include "response/structure/frf_receptance.hpp"
#include "response/structure/matrix_receptance.hpp"

namespace {

using namespace jointid;
using namespace jointid::response;

constexpr double noise = 0.01, averages = 100.0, spacing_hz = 0.25;
constexpr int lines = 80;
const std::vector<int> harmonics = {1, 3, 5};
const std::vector<double> asked_hz = {1.5, 2.0, 2.25, 3.0};

frf::Dof dof(int node) { return {node, frf::Direction::x, 1}; }

/// FRFs of three masses between springs, the first to ground.
frf::FrfSet part(double spring, int first_node) {
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(3, 3);
  for (Eigen::Index i = 0; i < 3; ++i) {
    k(i, i) += spring;
    if (i > 0) {
      k(i - 1, i - 1) += spring;
      k(i, i - 1) = k(i - 1, i) = -spring;
    }
  }
  const Eigen::MatrixXd all = Eigen::MatrixXd::Identity(3, 3);
  const MatrixReceptance receptance({all, 2e-3 * k, k}, Eigen::MatrixXd(3, 0), all, all);
  frf::FrfSet set;
  for (int i = 0; i < 3; ++i) set.header.response.push_back(dof(first_node + i));
  set.header.reference = set.header.response;
  for (int line = 1; line <= lines; ++line) {
    set.header.frequency_hz.push_back(line * spacing_hz);
    const Eigen::MatrixXcd h = receptance.at(2.0 * std::numbers::pi * line * spacing_hz);
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index j = 0; j < 3; ++j) set.values.push_back(h(i, j));
    }
  }
  return set;
}

/// Errors of H1 with the coherence that tells them: E|e|² = |H|²(1 − γ²)/(γ²(n − 1)).
frf::FrfSet measured(frf::FrfSet set, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  set.header.noise = frf::NoiseRecord::coherence;
  set.header.averages = averages;
  set.coherence.assign(set.values.size(), 1.0 / (1.0 + noise * noise * (averages - 1.0)));
  for (Complex& value : set.values) {
    const double size = noise * std::abs(value) / std::numbers::sqrt2, re = normal(generator);
    value += size * Complex(re, normal(generator));
  }
  return set;
}

HarmonicBalance balance_of(frf::FrfSystem& parts) {
  const auto structure = std::make_shared<FrfReceptance>(parts, std::vector<JointEnds>{{dof(3), dof(4)}},
                                                         std::vector<frf::Dof>{dof(1), dof(6)}, std::vector<frf::Dof>{dof(1)});
  const Joint joint = {.name = "joint", .friction = friction::make_element("ren", std::vector{0.004, 1.5, 150.0})};
  return {structure, {joint}, Excitation::single(8.0), {.fixed = harmonics}};
}

/// What the files of a seed say.
class Files {
 public:
  explicit Files(const std::filesystem::path& folder) : a_(folder / "jointid-bench-a.uff"), b_(folder / "jointid-bench-b.uff") {}

  HarmonicBalance measure(unsigned seed) {
    std::mt19937_64 generator(seed);
    frf::write_uff(measured(part(300.0, 1), generator), a_.path());
    frf::write_uff(measured(part(120.0, 4), generator), b_.path());
    std::vector<std::unique_ptr<frf::FrfSource>> sources;
    sources.push_back(frf::open(a_.path()));
    sources.push_back(frf::open(b_.path()));
    frf::FrfSystem parts("parts", std::move(sources), frf::Composition::uncoupled, false);
    return balance_of(parts);
  }

 private:
  TemporaryFile a_, b_;  ///< never committed
};

struct Count {
  std::size_t inside = 0, all = 0, lost = 0;
  double share() const { return static_cast<double>(inside) / static_cast<double>(all); }
  void add(double error, double deviation) {
    ++all;
    if (std::abs(error) <= 1.96 * deviation) ++inside;
  }
};

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(0, 200, 40);
  const auto exact_parts = frf::memory_system("parts", {part(300.0, 1), part(120.0, 4)}, frf::Composition::uncoupled);
  const HarmonicBalance exact = balance_of(*exact_parts);
  Files files(std::filesystem::temp_directory_path());
  std::vector<Count> counts(asked_hz.size());
  for (std::size_t seed = 1; seed <= seeds; ++seed) {
    const HarmonicBalance balance = files.measure(static_cast<unsigned>(seed));
    for (std::size_t f = 0; f < asked_hz.size(); ++f) {
      const double omega = 2.0 * std::numbers::pi * asked_hz[f];
      const HarmonicSolution truth = exact.solve(omega), found = balance.solve(omega);
      if (!found.converged || !truth.converged) {
        ++counts[f].lost;
        continue;
      }
      const ResponseDeviations deviation = deviations(balance, found);
      const Eigen::MatrixXcd error = found.response - truth.response;
      for (Eigen::Index e = 0; e < error.size(); ++e) {
        counts[f].add(error(e).real(), deviation.parts(e).real());
        counts[f].add(error(e).imag(), deviation.parts(e).imag());
      }
    }
  }
  Count all;
  fmt::print("{} seeds, {:.0f} % errors of all FRFs: held by the intervals\n", seeds, 100.0 * noise);
  for (std::size_t f = 0; f < counts.size(); ++f) {
    fmt::print("{:>8.2f} Hz{:>8.1f} %\n", asked_hz[f], 100.0 * counts[f].share());
    all.inside += counts[f].inside;
    all.all += counts[f].all;
    all.lost += counts[f].lost;
  }
  fmt::print("     all {:>9.1f} % of {}\n", 100.0 * all.share(), all.all);
  promises.at_least("share of cases held", all.share(), line.quick() ? 0.90 : 0.92);
  promises.at_most("share of cases held", all.share(), line.quick() ? 0.98 : 0.97);
  promises.holds("every response is found", all.lost == 0);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SEEDS]", measure); }
