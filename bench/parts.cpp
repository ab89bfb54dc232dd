// Structures of many parts: chains of 26, 126 and 501 beams (25, 125 and 500 joints of 4 unknowns), 1 % noise, Method One, to the end of
// what the command does: read, assemble, solve, synthesise, check. Prints processor time, phases, memory above what the FRFs themselves
// take, and the growth exponents in the number of parts; then what `jointid check` takes. Promised: the short check inside of a solution is
// at most a fifth of it and a second, its exponent and that of all else at most 1.3, the longest chain 10 s.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "bench/memory.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/case/many_joints_problem.hpp"

namespace {

using namespace jointid;

struct Run {
  ident::Solution solution;
  double processor_seconds = 0.0, megabytes = 0.0, check_seconds = 0.0;
  double largest_error = 0.0;  ///< of the largest stiffness
  std::size_t suspects = 0;
};

Run run(std::size_t parts) {
  const problems::Problem problem =
      problems::many_joints_problem(problems::chain_of_beams({.joints = parts - 1}), {fmt::format("chain-{}", parts - 1), ""}, false);
  const ident::Scene scene = problems::scene(problem);
  const problems::Measurement data = problems::polluted(problem, 1, 0);
  Run out;
  const auto plan = problems::plan(scene, data);
  ident::Control control;
  control.threads = 1;
  out.megabytes = bench::growth_megabytes([&] {
    const double before = bench::processor_seconds();
    out.solution = ident::solve(*plan, control);
    out.processor_seconds = bench::processor_seconds() - before;
  });
  double largest = 0.0;
  for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
    const double truth = problem.unknowns[u].value;
    largest = std::max(largest, std::abs(truth));
    const double error = std::abs(out.solution.unknowns[u].value - truth);
    if (!(error <= out.largest_error)) out.largest_error = error;
  }
  out.largest_error /= largest;
  const double before = bench::processor_seconds();
  out.suspects = problems::check(scene, data).suspects.size();
  out.check_seconds = bench::processor_seconds() - before;
  return out;
}

std::string phases(const ident::RunTime& time) {
  std::string out;
  for (const auto& [name, phase] : ident::run_time_phases) {
    if (time.*phase >= 0.005 * time.total) out += fmt::format("{}{} {:.3f} s", out.empty() ? "" : ", ", name, time.*phase);
  }
  return out;
}

double exponent(double now, double before, double factor) { return std::log(now / before) / std::log(factor); }

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  std::vector<std::size_t> sizes = {26, 126, 501};
  if (line.quick()) sizes.pop_back();
  if (line.words() > 0) sizes = {line.count(0, 0, 0)};
  Run before;
  std::size_t parts_before = 0;
  for (const std::size_t parts : sizes) {
    if (parts < 2) throw bench::UsageError("at least 2 parts");
    const Run now = run(parts);
    const ident::RunTime& time = now.solution.runtime_s;
    fmt::print("{:4} parts, {} unknowns  {:.3f} s of processor time, {:.0f} MB; {}\n", parts, now.solution.unknowns.size(),
               now.processor_seconds, now.megabytes, phases(time));
    fmt::print("            largest error {:.2g}, {}; jointid check {:.3f} s, {} suspects\n", now.largest_error,
               name(now.solution.status), now.check_seconds, now.suspects);
    promises.at_most(fmt::format("{} parts, largest error of the largest stiffness", parts), now.largest_error, 0.05);
    promises.speed_at_most(fmt::format("{} parts, share of the check", parts), time.check / time.total, 0.2);
    if (parts_before > 0) {
      const double factor = static_cast<double>(parts) / static_cast<double>(parts_before);
      const double all = exponent(now.processor_seconds, before.processor_seconds, factor);
      const double of_check = exponent(now.check_seconds, before.check_seconds, factor);
      fmt::print("            exponents: solution {:.2f}, memory {:.2f}, jointid check {:.2f}\n", all,
                 exponent(now.megabytes, before.megabytes, factor), of_check);
      promises.speed_at_most(fmt::format("{} parts, exponent", parts), all, 1.3);
      promises.speed_at_most(fmt::format("{} parts, exponent of jointid check", parts), of_check, 1.3);
    }
    if (parts == 501) promises.speed_at_most("501 parts, s", now.processor_seconds, 10.0);
    before = now;
    parts_before = parts;
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[PARTS]", measure); }
