#include "problems/vibration/law_problem.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "frf/noise/noise.hpp"
#include "frf/set/frf_system.hpp"
#include "friction/law/laws.hpp"
#include "problems/structure/response.hpp"
#include "response/harmonic/harmonic_balance.hpp"

namespace jointid::problems {
namespace {

constexpr double third_of_shaker = 0.02;

/// Lines at the given harmonics of the force's frequencies, none twice.
std::vector<double> lines_of(const LawProblem& problem, const std::vector<int>& harmonics) {
  std::vector<double> lines;
  for (const int n : harmonics) {
    for (const double hz : problem.frequency_hz) lines.push_back(n * hz);
  }
  std::ranges::sort(lines);
  const auto same = [](double a, double b) { return b - a < 1e-9 * b; };
  lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
  return lines;
}

std::vector<frf::FrfSet> parts_of(const LawProblem& problem) {
  std::vector<frf::Dof> wanted = problem.responses;
  for (const LawProblemJoint& joint : problem.joints) {
    wanted.push_back(joint.ends.positive);
    if (joint.ends.negative) wanted.push_back(*joint.ends.negative);
  }
  wanted.push_back(problem.force);
  std::vector<int> harmonics = problem.model;
  harmonics.push_back(harmonics.back() + 2);
  std::vector<frf::FrfSet> sets;
  for (const Structure& part : problem.parts) {
    std::vector<frf::Dof> own;
    for (const frf::Dof& dof : part.dofs()) {
      if (frf::has(wanted, dof)) own.push_back(dof);
    }
    sets.push_back(
        frequency_response(part, {.response = own, .reference = own, .frequency_hz = lines_of(problem, problem.model)}));
    sets.back().header.file = problem.name + "_part_" + std::to_string(sets.size()) + ".h5";
  }
  return sets;
}

frf::FrfSet phasors(const LawProblem& problem, const std::vector<frf::Dof>& dofs, const std::string& file) {
  frf::FrfSet set;
  set.header.file = file;
  set.header.frequency_hz = lines_of(problem, problem.measured);
  set.header.response = dofs;
  set.header.reference = {problem.force};
  set.values.assign(set.header.lines() * set.header.entries(), Complex(0.0));
  return set;
}

std::size_t line_of(const frf::FrfSet& set, double hz) {
  const auto found = std::ranges::lower_bound(set.header.frequency_hz, hz * (1.0 - 1e-9));
  return static_cast<std::size_t>(found - set.header.frequency_hz.begin());
}

response::Excitation shaker(double level) {
  response::Excitation force = {{1, 3}, Eigen::MatrixXcd(2, 1)};
  force.amplitudes << std::polar(level, 0.4), std::polar(third_of_shaker * level, -1.1);
  return force;
}

std::shared_ptr<const response::FrfReceptance> receptance_of(const LawProblem& problem, const std::vector<frf::FrfSet>& parts) {
  const auto system = frf::memory_system("parts", parts, frf::Composition::uncoupled);
  std::vector<response::JointEnds> ends;
  for (const LawProblemJoint& joint : problem.joints) ends.push_back(joint.ends);
  return std::make_shared<response::FrfReceptance>(*system, ends, problem.responses, std::vector<frf::Dof>{problem.force});
}

/// One level: phasors of the responses and of the force.
void measure_level(const LawProblem& problem, const std::shared_ptr<const response::Receptance>& structure,
                   const std::vector<response::Joint>& joints, double level, LawMeasurement& to) {
  const std::string file = problem.name + "_level_" + std::to_string(to.responses.size() + 1);
  frf::FrfSet responses = phasors(problem, problem.responses, file + ".h5"),
              forces = phasors(problem, {problem.force}, file + "_force.h5");
  const response::HarmonicBalance balance(structure, joints, shaker(level), {.fixed = problem.model});
  response::HarmonicSolution last;
  for (const double hz : problem.frequency_hz) {
    last = balance.solve(angular(hz), 1.0, last.converged ? &last : nullptr);
    if (!last.converged) {
      throw InputError({.kind = ErrorKind::data,
                        .file = {},
                        .place = problem.name,
                        .problem = "no response at " + std::to_string(hz) + " Hz and " + std::to_string(level) + " N",
                        .remedy = "change the levels or the lines of the problem"});
    }
    const response::Harmonics harmonics(last.harmonics);
    for (const int n : problem.measured) {
      for (std::size_t r = 0; r < problem.responses.size(); ++r)
        responses.values[responses.index(line_of(responses, n * hz), r, 0)] = last.response(harmonics.find(n), at(r));
      forces.values[forces.index(line_of(forces, n * hz), 0, 0)] = balance.force().of(n)(0);
    }
  }
  to.responses.push_back(std::move(responses));
  to.forces.push_back(std::move(forces));
}

}  // namespace

LawMeasurement measure(const LawProblem& problem) {
  LawMeasurement out;
  out.parts = parts_of(problem);
  std::vector<response::Joint> joints;
  for (const LawProblemJoint& joint : problem.joints)
    joints.push_back({.name = joint.name, .friction = friction::make_element(joint.law, joint.parameters)});
  const auto structure = receptance_of(problem, out.parts);
  for (const double level : problem.levels) measure_level(problem, structure, joints, level, out);
  return out;
}

LawMeasurement polluted(const LawProblem& problem, LawMeasurement exact, std::uint64_t seed) {
  const frf::NoiseModel noise = {.kind = frf::NoiseKind::circular, .level = problem.noise, .record_variance = true};
  std::uint64_t number = 0;
  for (auto* sets : {&exact.parts, &exact.responses}) {
    if (sets == &exact.parts && !problem.noisy_parts) continue;
    for (frf::FrfSet& set : *sets) set = frf::polluted(set, noise, seed, 0, number++);
  }
  return exact;
}

LawStates states_of(const LawProblem& problem, const LawMeasurement& measured) {
  LawStates out = {receptance_of(problem, measured.parts), {}};
  const Eigen::Index harmonics = at(problem.measured.size()), responses = at(problem.responses.size());
  for (std::size_t level = 0; level < problem.levels.size(); ++level) {
    const frf::FrfSet &set = measured.responses[level], &force = measured.forces[level];
    for (const double hz : problem.frequency_hz) {
      response::MeasuredState state = {angular(hz), {problem.measured, Eigen::MatrixXcd(harmonics, 1)}, problem.measured, {}, {}};
      state.response.resize(harmonics, responses);
      state.deviation.resize(harmonics, responses);
      for (Eigen::Index n = 0; n < harmonics; ++n) {
        const std::size_t line = line_of(set, problem.measured[static_cast<std::size_t>(n)] * hz);
        state.force.amplitudes(n, 0) = force.values[force.index(line, 0, 0)];
        for (Eigen::Index r = 0; r < responses; ++r) {
          const std::size_t place = set.index(line, static_cast<std::size_t>(r), 0);
          state.response(n, r) = set.values[place];
          const double own = problem.noise * std::abs(set.values[place]) / std::numbers::sqrt2;
          state.deviation(n, r) = set.variance.empty() ? own : std::sqrt(set.variance[place].real());
        }
      }
      out.states.push_back(std::move(state));
    }
  }
  return out;
}

}  // namespace jointid::problems
