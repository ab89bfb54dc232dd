// Cost of method "likelihood" with many joint coordinates: two random structures joined by springs, each between two coordinates, whose
// stiffness and damping are unknown; circular errors of 1 %, variances in the files. First 36 other coordinates and 12, 24 and 48 at the
// joint: processor time per line and iteration; then 48 and 24, 48 unknowns, 400 lines, to the intervals, on all cores. Promised: the
// exponent in the joint coordinates is at most 4, the large one takes at most 5 minutes on two free cores and 2 GB, and no estimate is
// more than 5 standard errors off. The quick run takes 6 and 12 coordinates, and 6 with 4 lines; a first word is the number of lines
// of the large one.
#include <fmt/core.h>

#include <cmath>
#include <random>

#include "bench/bench.hpp"
#include "bench/random_structures.hpp"
#include "ident/identify.hpp"

namespace {

using namespace jointid;

struct Run {
  std::size_t iterations = 0;
  double seconds = 0.0, processor_seconds = 0.0, largest_error = 0.0;  ///< error in standard errors
};

Run run(std::size_t lines, std::size_t joint, std::size_t others, ident::Detail detail) {
  bench::SprungSets sets = bench::sprung_sets(lines, joint, others);
  std::mt19937 generator(11);
  for (frf::FrfSet* set : {&sets.frfs.a, &sets.frfs.b, &sets.frfs.both}) bench::pollute(*set, 0.01, generator);
  ident::Scene scene;
  restrictions::JointSpec spec;
  spec.dofs = sets.dofs;
  spec.matrices[restrictions::Kind::stiffness] = sets.springs;
  spec.matrices[restrictions::Kind::hysteretic_damping] = sets.springs;
  scene.joints = {spec};
  scene.identify.method = ident::Method::likelihood;
  std::vector<frf::FrfSet> parts;
  parts.push_back(std::move(sets.frfs.a));
  parts.push_back(std::move(sets.frfs.b));
  std::vector<frf::FrfSet> whole;
  whole.push_back(std::move(sets.frfs.both));
  const auto plan = ident::make_plan(scene, std::move(parts), std::move(whole));
  ident::Control control;
  control.detail = detail;
  const double before = bench::processor_seconds();
  const ident::Solution solution = ident::solve(*plan, control);
  Run out{solution.fit.iterations, solution.runtime_s.total, bench::processor_seconds() - before, 0.0};
  for (std::size_t u = 0; u < sets.truth.size(); ++u) {
    const double error = std::abs(solution.unknowns[u].value - sets.truth[u]) / solution.unknowns[u].std_error.value_or(0.0);
    if (!(error <= out.largest_error)) out.largest_error = error;
  }
  return out;
}

void measure_large(std::size_t lines, std::size_t joint, bench::Promises& promises) {
  const Run large = run(lines, joint, 24, ident::Detail::full);
  const double all = large.seconds * 400.0 / static_cast<double>(lines);
  fmt::print(
      "{} + 24 coordinates, {} unknowns, {} lines   {:.1f} s, {:.1f} of processor time, {} iterations, {:.0f} MB, largest error {:.1f} "
      "standard errors; 400 lines at that rate {:.0f} s\n",
      joint, joint, lines, large.seconds, large.processor_seconds, large.iterations, bench::peak_megabytes(), large.largest_error, all);
  promises.speed_at_most("large, s", all, 300.0);
  if (lines >= 400) promises.at_most("large, MB", bench::peak_megabytes(), 2000.0);
  promises.at_most("large, largest error in standard errors", large.largest_error, 5.0);
}

void measure_growth(const std::vector<std::size_t>& sizes, bench::Promises& promises) {
  constexpr std::size_t lines = 8;
  double before = 0.0;
  for (const std::size_t joint : sizes) {
    const Run now = run(lines, joint, 36, ident::Detail::estimates);
    const double each = now.processor_seconds / static_cast<double>(lines * now.iterations);
    fmt::print("{:2} + 36 coordinates, {} lines   {:.2f} ms of processor time a line and iteration, {} iterations, ", joint, lines,
               1e3 * each, now.iterations);
    fmt::print("largest error {:.1f} standard errors", now.largest_error);
    promises.at_most(fmt::format("{} + 36, largest error in standard errors", joint), now.largest_error, 5.0);
    if (before > 0.0) {
      const double exponent = std::log2(each / before);
      fmt::print(", exponent {:.2f}", exponent);
      promises.speed_at_most(fmt::format("{} + 36, exponent", joint), exponent, 4.0);
    }
    fmt::print("\n");
    std::fflush(stdout);
    before = each;
  }
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  measure_growth(line.quick() ? std::vector<std::size_t>{6, 12} : std::vector<std::size_t>{12, 24, 48}, promises);
  measure_large(line.count(0, 400, 4), line.quick() ? 6 : 48, promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[LINES]", measure); }
