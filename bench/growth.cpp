// How the cost of one solution (assembling and solving, one thread) grows with the size of the problem, on random FRFs.
// The exponent is that of the last step: log(time ratio) / log(size ratio).
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "ident/identify.hpp"


namespace {

using namespace jointid;

struct Size {
  std::size_t lines = 100, other = 20, joint = 6;
  restrictions::Pattern pattern = restrictions::Pattern::symmetric;
};

frf::FrfSet random_set(std::size_t lines, std::size_t dofs, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  frf::FrfSet set;
  for (std::size_t i = 0; i < lines; ++i) set.header.frequency_hz.push_back(100.0 + static_cast<double>(i));
  for (std::size_t i = 0; i < dofs; ++i) set.header.response.push_back({static_cast<std::int64_t>(i + 1), frf::Direction::y, +1});
  set.header.reference = set.header.response;
  for (std::size_t i = 0; i < lines * dofs * dofs; ++i) set.values.emplace_back(normal(generator), normal(generator));
  return set;
}

std::unique_ptr<frf::FrfSystem> system(const char* name, frf::FrfSet set) {
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  sources.push_back(frf::from_memory(std::move(set)));
  return std::make_unique<frf::FrfSystem>(name, std::move(sources), frf::Composition::merged, false);
}

double milliseconds(const Size& size) {
  ident::Scene scene;
  restrictions::JointSpec joint;
  for (std::size_t i = 0; i < size.joint; ++i) joint.dofs.push_back({static_cast<std::int64_t>(i + 1), frf::Direction::y, +1});
  joint.matrices[restrictions::Kind::stiffness] = size.pattern;
  scene.joints = {joint};
  scene.identify.equations = {ident::Equation::nn, ident::Equation::nj};
  const std::size_t dofs = size.joint + size.other;
  const auto plan = ident::make_plan(scene, system("substructures", random_set(size.lines, dofs, 1)),
                                     system("assembly", random_set(size.lines, dofs, 2)));
  ident::Control control;
  control.threads = 1;
  control.detail = ident::Detail::estimates;
  double best = 1e9;
  const auto begin = std::chrono::steady_clock::now();
  for (int round = 0; round < 50 && (round < 3 || std::chrono::steady_clock::now() - begin < std::chrono::seconds(1)); ++round) {
    best = std::min(best, ident::solve(*plan, control).runtime_s.total);
  }
  return 1e3 * best;
}

struct Step {
  double size = 0.0;
  Size problem;
};

void print(const char* what, const std::vector<Step>& steps) {
  fmt::print("{:34}", what);
  std::vector<double> times;
  for (const Step& step : steps) {
    times.push_back(milliseconds(step.problem));
    fmt::print("  {:5g}: {:9.3f} ms", step.size, times.back());
  }
  const std::size_t last = steps.size() - 1;
  fmt::print("   exponent {:.2f}, over the last step {:.2f}\n",
             std::log(times[last] / times[0]) / std::log(steps[last].size / steps[0].size),
             std::log(times[last] / times[last - 1]) / std::log(steps[last].size / steps[last - 1].size));
}

}  // namespace

int main() {
  using enum restrictions::Pattern;
  fmt::print("one solution, WB, nn + nj; if not said otherwise 100 lines, 20 non-joint and 6 joint coordinates, symmetric K\n");
  print("lines", {{100, {.lines = 100}}, {300, {.lines = 300}}, {1000, {.lines = 1000}}});
  print("non-joint coordinates", {{20, {.other = 20}}, {60, {.other = 60}}, {200, {.other = 200}}});
  print("joint coordinates, symmetric K", {{4, {.joint = 4}}, {8, {.joint = 8}}, {12, {.joint = 12}}});
  print("unknowns, 10 joint coordinates", {{10, {.joint = 10, .pattern = diagonal}},
                                           {55, {.joint = 10, .pattern = symmetric}},
                                           {100, {.joint = 10, .pattern = full}}});
  return 0;
}
