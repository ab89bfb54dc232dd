#include "stability/sweeps.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "ident/identify.hpp"
#include "minimise/linear/sparse_qr.hpp"
#include "stability/draw.hpp"
#include "stability/many_joints_scene.hpp"
#include "stability/matrix_sweeps.hpp"

namespace jointid::stability {
namespace {

using ident::Method;
using ident::Solver;

/// A value of a sweep and the scene for it.
struct Step {
  double value;
  ExtremeScene scene;
};

template <class Change>
std::vector<Step> steps(const std::vector<double>& values, const Change& change) {
  std::vector<Step> out;
  for (const double value : values) {
    Step step{value, {}};
    change(step.scene, value);
    out.push_back(step);
  }
  return out;
}

std::vector<double> decades(int from, int to, int by = 1) {
  std::vector<double> out;
  for (int exponent = from; exponent <= to; exponent += by) out.push_back(std::pow(10.0, exponent));
  return out;
}

void stiffness(ExtremeScene& scene, double value) { scene.joint_stiffness = value; }

void symmetric_stiffness(ExtremeScene& scene, double value) {
  scene.joint_stiffness = value;
  scene.form = Form::symmetric;
}

std::vector<Step> scene_steps(const std::string& sweep) {
  if (sweep == "stiffness") return steps(decades(-6, 9), stiffness);
  if (sweep == "symmetric") return steps(decades(-6, 9, 3), symmetric_stiffness);
  if (sweep == "spread") return steps(decades(-12, 0, 3), [](ExtremeScene& scene, double value) { scene.second_spring = value; });
  if (sweep == "free-free") {
    return steps({0.01, 0.1, 1.0, 10.0}, [](ExtremeScene& scene, double value) {
      scene.free_free = scene.logarithmic = true;
      scene.lowest_hz = value;
    });
  }
  if (sweep == "loss")
    return steps({0.0, 1e-8, 1e-4, 1e-2, 0.5}, [](ExtremeScene& scene, double value) { scene.loss_factor = value; });
  if (sweep == "resonance") {
    return steps({0.0, 1e-12, 1e-8, 1e-4}, [](ExtremeScene& scene, double value) {
      scene.loss_factor = scene.joint_loss = value;
      scene.on_resonance = true;
    });
  }
  if (sweep == "coincident") return steps(decades(-12, 0, 2), [](ExtremeScene& scene, double value) { scene.gap = value; });
  if (sweep == "lines") {
    return steps(decades(0, 5), [](ExtremeScene& scene, double value) { scene.lines = static_cast<std::size_t>(value); });
  }
  if (sweep == "single") {
    return steps(decades(-6, 6, 2), [](ExtremeScene& scene, double value) {
      scene.joint_stiffness = value;
      scene.storage = Storage::single_precision;
    });
  }
  return {};
}

bool follows_all_methods(const std::string& sweep) {
  return sweep == "stiffness" || sweep == "free-free" || sweep == "resonance";
}

/// Up to which number of lines the likelihood and the SVD are measured.
constexpr std::size_t few_lines = 1000;

void stop_if_asked(const Watch& watch) { stop_if(watch.interrupted); }

bool has(Solver solver) { return (solver != Solver::spqr && solver != Solver::cholmod) || minimise::has_spqr(); }

void measure_scene(const std::string& sweep, const Step& step, const Watch& watch, std::vector<Measured>& out) {
  const auto add = [&](ExtremeScene scene, Method method, const std::vector<Way>& ways) {
    scene.method = method;
    const ExtremeProblem problem = make(scene);
    const std::optional<ExactEstimate> exact = exact_estimate(problem);
    for (const Way way : ways) {
      stop_if_asked(watch);
      out.push_back(measure(problem, way, exact));
      out.back().sweep = sweep;
      out.back().value = step.value;
      if (watch.measured) watch.measured(out.back());
    }
  };
  add(step.scene, Method::one, {Solver::normal, Solver::qr, OwnWay::svd, Solver::spqr});
  if (!follows_all_methods(sweep)) return;
  add(step.scene, Method::two, {Solver::qr});
  add(step.scene, Method::direct, {Solver::qr});
  add(step.scene, Method::newton, {Solver::automatic});
  if (step.scene.lines <= few_lines) add(step.scene, Method::likelihood, {Solver::automatic});
}

void measure_rows(const std::string& sweep, double value, const Rows& rows, const Watch& watch, std::vector<Measured>& out) {
  for (const Way way : {Way(Solver::normal), Way(Solver::qr), Way(OwnWay::svd), Way(Solver::spqr), Way(OwnWay::qr_refined)}) {
    stop_if_asked(watch);
    out.push_back(measure(rows, way));
    out.back().sweep = sweep;
    out.back().value = value;
    if (watch.measured) watch.measured(out.back());
  }
}

/// Sparse rows of many joints, free or constrained. No exact reference: digits are those of the truth.
void measure_many_joints(const std::string& sweep, const Watch& watch, std::vector<Measured>& out) {
  for (const double spread : decades(0, 9)) {
    if (watch.progress) watch.progress(sweep);
    const ExtremeProblem problem =
        make(ManyJointsScene{.frame = sweep.starts_with("frame"), .spread = spread, .definite = sweep.ends_with("-definite")});
    for (const Solver solver : {Solver::qr, Solver::spqr, Solver::cholmod, Solver::ldlt}) {
      if (!has(solver)) continue;
      stop_if_asked(watch);
      out.push_back(measure(problem, solver, std::nullopt));
      out.back().sweep = sweep;
      out.back().value = spread;
      if (watch.measured) watch.measured(out.back());
    }
  }
}

void run(const std::string& sweep, const Watch& watch, std::vector<Measured>& out) {
  for (const Step& step : scene_steps(sweep)) {
    if (watch.progress) watch.progress(sweep);
    measure_scene(sweep, step, watch, out);
  }
  if (sweep == "hilbert") {
    for (const std::size_t size : {2u, 4u, 6u, 8u, 10u, 12u})
      measure_rows(sweep, static_cast<double>(size), hilbert(size), watch, out);
  }
  if (sweep == "laeuchli") {
    for (const double delta : decades(-14, 0, 2)) measure_rows(sweep, delta, laeuchli(5, delta), watch, out);
  }
  if (sweep == "weights") {
    for (const double spread : decades(0, 14, 2)) measure_rows(sweep, spread, weighted(60, 5, spread), watch, out);
  }
  if (sweep.starts_with("chain") || sweep.starts_with("frame")) measure_many_joints(sweep, watch, out);
}

Honesty verdict_of(std::uint64_t seed, std::uint64_t index) {
  const ExtremeProblem problem = make(draw(seed, index));
  return measure(problem, draw_solver(seed, index), std::nullopt).verdict;
}

}  // namespace

const std::vector<Sweep>& sweeps() {
  static const std::vector<Sweep> all = {
      {"stiffness", "joint stiffness, two springs with damping", "joint stiffness over the structure's"},
      {"symmetric", "joint stiffness, symmetric matrices K and D", "joint stiffness over the structure's"},
      {"spread", "unknowns of different size", "smaller over larger spring"},
      {"free-free", "free-free parts at low frequency", "lowest line (Hz)"},
      {"loss", "loss factor of the parts", "loss factor"},
      {"resonance", "lines on every resonance to the last bit", "loss factor"},
      {"coincident", "two interface DOFs that nearly coincide", "compliance between them over the others"},
      {"lines", "number of lines", "lines"},
      {"single", "FRFs in single precision", "joint stiffness over the structure's"},
      {"hilbert", "rows: Hilbert matrices", "size"},
      {"laeuchli", "rows: Läuchli matrices", "δ"},
      {"weights", "rows: weights in random order (Powell and Reid)", "largest over smallest weight"},
      {"chain", "27 beams on 26 joints, rows by parts, digits true",
       "stiffest joint over the structure, and the structure over the softest"},
      {"frame", "15 beams on 21 joints, rows by parts, digits true",
       "stiffest joint over the structure, and the structure over the softest"},
      {"chain-definite", "the chain with semidefinite K and D, every other D zero, digits true",
       "stiffest joint over the structure, and the structure over the softest"},
      {"frame-definite", "the frame with semidefinite K and D, every other D zero, digits true",
       "stiffest joint over the structure, and the structure over the softest"}};
  return all;
}

std::vector<Measured> run_sweeps(const std::vector<std::string>& names, const Watch& watch) {
  for (const std::string& name : names) {
    if (std::ranges::find(sweeps(), name, &Sweep::name) != sweeps().end()) continue;
    std::vector<std::string> words;
    std::string list;
    for (const Sweep& each : sweeps()) {
      words.push_back(each.name);
      list += (list.empty() ? "use " : ", ") + each.name;
    }
    const std::string near = nearest_word(name, words);
    throw InputError({ErrorKind::usage, "", "--sweeps", "'" + name + "' is no sweep",
                      (near.empty() ? "" : "did you mean '" + near + "'? ") + list});
  }
  std::vector<Measured> out;
  for (const Sweep& sweep : sweeps()) {
    if (names.empty() || std::ranges::find(names, sweep.name) != names.end()) run(sweep.name, watch, out);
  }
  return out;
}

Count count_verdicts(std::uint64_t seed, std::uint64_t first, std::size_t count, const Watch& watch) {
  Count out;
  for (std::uint64_t index = first; index < first + count; ++index, ++out.scenes) {
    if (watch.counted && index > first) watch.counted(out);
    stop_if_asked(watch);
    if (watch.progress) watch.progress("scene " + std::to_string(index - first + 1) + " of " + std::to_string(count));
    try {
      const Honesty verdict = verdict_of(seed, index);
      out.right += verdict == Honesty::right;
      out.told += verdict == Honesty::told || verdict == Honesty::not_judged;
      out.false_alarm += verdict == Honesty::false_alarm;
      if (verdict == Honesty::silent_wrong) {
        ++out.silent_wrong;
        out.silent.push_back(index);
      }
    } catch (const InputError&) {
      ++out.refused;
    }
  }
  return out;
}

}  // namespace jointid::stability
