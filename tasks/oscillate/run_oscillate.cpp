#include "tasks/oscillate/run_oscillate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/control.hpp"
#include "base/error.hpp"
#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"
#include "frf/file/columns.hpp"
#include "tasks/tell.hpp"

namespace jointid::tasks {
namespace {

using oscillation::ContactSystem;
using oscillation::Model;
using oscillation::MotionEnd;
using oscillation::PeriodicOrbit;
using oscillation::ReductionBasis;

std::optional<SeenModes> modes_of(const SampledMotion& motion) {
  if (motion.status != MotionEnd::ok) return std::nullopt;
  const oscillation::Samples seen = motion.samples.middleCols(1, at(motion.seen));
  if ((seen.rowwise() - seen.row(0)).cwiseAbs().maxCoeff() == 0.0) return std::nullopt;
  return SeenModes{oscillation::pod(seen), oscillation::square_fractions(seen)};
}

/// Columns q1 … qn of a record, as the modes of the full model are made of it.
oscillation::Samples recorded(const ident::Path& file, Eigen::Index degrees) {
  const frf::Columns columns = frf::read_columns(file);
  std::vector<const frf::NumberColumn*> chosen;
  for (Eigen::Index k = 0; k < degrees; ++k) chosen.push_back(&columns.column(fmt::format("q{}", k + 1)));
  oscillation::Samples out(at(chosen.front()->values.size()), degrees);
  for (Eigen::Index k = 0; k < degrees; ++k) {
    const std::vector<double>& values = chosen[static_cast<std::size_t>(k)]->values;
    if (at(values.size()) != out.rows())
      throw InputError({ErrorKind::data, columns.file, "", "has columns of different length", ""});
    out.col(k) = Eigen::Map<const Eigen::VectorXd>(values.data(), out.rows());
  }
  return out;
}

NormalVibrationResult vibrated(const NormalVibrationSection& asked, SystemSpec spec) {
  NormalVibrationResult out{asked.system, asked.frequencies_hz, {}, {}};
  for (const double hz : asked.frequencies_hz) {
    spec.frequency_hz = hz;
    out.amplitudes.push_back(spec.drive_amplitude());
    out.motions.push_back(oscillation::normal_motion(asked.system, out.amplitudes.back(), angular(hz)));
  }
  return out;
}

/// Carries a scene out.
class Oscillating {
 public:
  Oscillating(const OscillateScene& scene, const ident::Control& control,
              const std::function<void(const OscillateResult&)>& so_far)
      : scene_(scene), control_(control), so_far_(so_far), model_(model_of(scene.system)), system_(contact_system(model_)) {
    run_.title = scene.title;
    run_.system = scene.system;
  }

  OscillateResult run() {
    if (scene_.system.poisson_ratio) run_.thick_modes = oscillation::thick_modes(thick_beam(scene_.system), scene_.system.beam.modes);
    if (scene_.normal_vibrations) run_.normal_vibrations = vibrated(*scene_.normal_vibrations, scene_.system);
    const auto share = [&](double done) { count("motion", done); };
    run_.motion = std::make_shared<const SampledMotion>(sampled_motion(scene_, system_, share, control_.interrupted));
    run_.modes = modes_of(*run_.motion);
    keep();
    if (run_.motion->status != MotionEnd::ok) return std::move(run_);
    if (scene_.orbit) step("periodic orbit", [&] { find_orbit(); });
    if (scene_.exponents) step("exponents", [&] { find_exponents(); });
    if (scene_.sweep) step("sweep", [&] { sweep(); });
    if (scene_.reduction) step("reduced models", [&] { reduce(); });
    return std::move(run_);
  }

 private:
  void count(const char* stage, double share) {
    const int percent = static_cast<int>(100.0 * share);
    if (percent == percent_) return;
    percent_ = percent;
    tell(control_, stage, static_cast<std::size_t>(std::max(percent, 0)), 100);
  }
  void keep() {
    if (so_far_) so_far_(run_);
  }

  template <class Work>
  void step(const char* stage, const Work& work) {
    tell(control_, stage);
    stop_if(control_.interrupted);
    work();
    keep();
  }

  void find_orbit() {
    const std::size_t returns = scene_.orbit->returns;
    if (scene_.system.is_driven()) {
      // From the end of the motion on to the next phase 0 of the drive.
      const double cycle = 1.0 / scene_.system.frequency_hz, now = scene_.motion.transient + scene_.motion.length;
      oscillation::StickSlip on(system_, run_.motion->end, run_.motion->end_mode, now);
      on.advance(cycle * std::ceil(now / cycle - 1e-9));
      run_.orbit = driven_orbit(system_, on.state(), on.mode(), cycle, returns, control_.interrupted);
      return;
    }
    if (run_.motion->break_aways.empty()) {
      run_.remarks.emplace_back("no orbit: the window has no break-away to begin one with");
      run_.orbit = PeriodicOrbit{};
      return;
    }
    run_.orbit = break_away_orbit(system_, run_.motion->break_aways.back().state, returns, 1e4, control_.interrupted);
  }

  void find_exponents() {
    const ExponentSection& asked = *scene_.exponents;
    run_.exponents = lyapunov_exponents(system_, system_.state(scene_.q, scene_.v),
                                        {asked.count, asked.transient, asked.length, asked.interval, control_.interrupted});
  }

  oscillation::SweepCase swept_case(double value) const {
    SystemSpec spec = scene_.system;
    set_swept(spec, scene_.sweep->parameter, value);
    const SeenForm form = seen_forms(spec).front();
    oscillation::SweepCase out{contact_system(model_of(spec)), {}, {}};
    out.start = out.system.state(scene_.q, scene_.v);
    out.form = Eigen::VectorXd::Zero(out.system.size());
    out.form.head(out.system.degrees()) = form.row.transpose();
    out.cycle = spec.is_driven() ? 1.0 / spec.frequency_hz : 0.0;
    const double unit = spec.is_driven() ? out.cycle : 1.0;
    out.transient = unit * scene_.sweep->transient;
    out.length = unit * scene_.sweep->length;
    if (scene_.sweep->ranges()) {
      out.range_form = Eigen::VectorXd::Zero(out.system.size());
      out.range_form.head(out.system.degrees()) = judged_form(spec).row.transpose();
    }
    return out;
  }

  /// The same of the model on a basis.
  oscillation::SweepCase swept_case(double value, const ReductionBasis& basis) const {
    SystemSpec spec = scene_.system;
    set_swept(spec, scene_.sweep->parameter, value);
    const Model full = model_of(spec);
    const oscillation::SweepCase whole = swept_case(value);
    oscillation::SweepCase out = whole;
    out.system = contact_system(reduced(full, basis));
    out.start = out.system.state(reduced_displacements(full.mechanics, basis, scene_.q),
                                 reduced_velocities(full.mechanics, basis, scene_.v));
    const Eigen::VectorXd form = whole.form.head(whole.system.degrees());
    out.form = Eigen::VectorXd::Zero(out.system.size());
    out.form.head(out.system.degrees()) = basis.columns.transpose() * form;
    out.offset = form.dot(basis.mean);
    const Eigen::VectorXd judged = whole.range_form.head(whole.system.degrees());
    out.range_form = Eigen::VectorXd::Zero(out.system.size());
    out.range_form.head(out.system.degrees()) = basis.columns.transpose() * judged;
    out.range_offset = judged.dot(basis.mean);
    return out;
  }

  /// Largest real part of the eigenvalues about steady sliding at a belt's velocity, 1/s.
  double sliding_growth(double velocity) const {
    const oscillation::Mechanics& m = model_.mechanics;
    const oscillation::Friction& friction = model_.friction;
    const Eigen::Index n = m.mass.rows();
    const oscillation::Mode slip = velocity < 0.0 ? oscillation::Mode::backward : oscillation::Mode::forward;
    const double slope = (system_.statical(slip) - system_.kinetic(slip)) * friction.normal * *friction.decay *
                         std::exp(-*friction.decay * std::abs(velocity));
    Eigen::MatrixXd right(n, 2 * n), all = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    right << -m.stiffness, -m.damping + slope * m.contact * m.contact.transpose();
    all.topRightCorner(n, n).setIdentity();
    all.bottomRows(n) = dense::solve_positive(m.mass, right);
    return dense::eigenvalues(all).real().maxCoeff();
  }

  /// Where sliding turns stable between the ends of the sweep of a belt's velocity, by bisection.
  std::optional<double> sliding_limit() const {
    const SweepSection& asked = *scene_.sweep;
    if (asked.parameter != "velocity" || scene_.system.is_driven() || !model_.friction.decay) return std::nullopt;
    double low = std::min(asked.from, asked.to), high = std::max(asked.from, asked.to);
    if (!(sliding_growth(low) > 0.0) || !(sliding_growth(high) < 0.0)) return std::nullopt;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (sliding_growth(middle) > 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  /// Every parameter in the order of the range, and back.
  std::vector<double> swept_values() const {
    const SweepSection& asked = *scene_.sweep;
    std::vector<double> values;
    for (std::size_t k = 0; k < asked.points; ++k)
      values.push_back(std::lerp(asked.from, asked.to, static_cast<double>(k) / static_cast<double>(asked.points - 1)));
    if (asked.back) values.insert(values.end(), values.rbegin() + 1, values.rend());
    return values;
  }

  template <class Make>
  std::vector<oscillation::SweepPoint> swept(const Make& make, const oscillation::SweepOptions& options) const {
    const std::vector<double> values = swept_values();
    if (!scene_.sweep->continued) return oscillation::sweep(values, make, options);
    std::vector<oscillation::SweepPoint> points = oscillation::continued_sweep(values, make, options);
    const bool falls = scene_.sweep->to < scene_.sweep->from;
    for (std::size_t k = 0; k < points.size(); ++k) points[k].direction = (k < scene_.sweep->points) != falls ? 1 : -1;
    return points;
  }

  void sweep() {
    const SweepSection& asked = *scene_.sweep;
    run_.swept = asked;
    run_.sliding_limit = sliding_limit();
    oscillation::SweepOptions options{control_.threads, control_.interrupted};
    options.done = [&](const oscillation::SweepPoint& point) {
      const auto place = std::ranges::lower_bound(run_.sweep, point.parameter, {}, &oscillation::SweepPoint::parameter);
      run_.sweep.insert(asked.continued ? run_.sweep.end() : place, point);
      count("sweep", static_cast<double>(run_.sweep.size()) / static_cast<double>(asked.points));
      keep();
    };
    std::vector<oscillation::SweepPoint> all = swept([&](double value) { return swept_case(value); }, options);
    if (asked.continued) run_.sweep = std::move(all);
  }

  /// The sweep of the models of [reduction]; normal modes move about the static deflection by the kinetic friction.
  void sweep_reduced(const std::optional<oscillation::Pod>& pod) {
    const oscillation::SweepOptions options{control_.threads, control_.interrupted};
    const oscillation::Friction& friction = model_.friction;
    for (const BasisKind kind : scene_.reduction->bases) {
      for (const std::size_t order : scene_.reduction->orders) {
        ReductionBasis on = basis(kind, order, pod);
        if (kind == BasisKind::normal_modes) {
          const double force = system_.kinetic(oscillation::Mode::forward) * friction.normal;
          on.mean = dense::solve_positive(model_.mechanics.stiffness, model_.mechanics.contact * force);
        }
        run_.reduced_sweeps.push_back({kind, order, swept([&](double value) { return swept_case(value, on); }, options)});
        keep();
      }
    }
  }

  oscillation::ComparedMotion compared() const {
    const MotionSection& motion = scene_.motion;
    oscillation::ComparedMotion out{
        scene_.q, scene_.v, motion.transient, motion.length, 600, judged_form(scene_.system).row, control_.interrupted};
    if (scene_.reduction->from_orbit) {
      const Eigen::Index n = system_.degrees();
      out.q = run_.orbit->state.head(n), out.v = run_.orbit->state.segment(n, n);
      out.transient = 0.0, out.length = run_.orbit->period;
    } else {
      out.samples = std::clamp<std::size_t>(static_cast<std::size_t>(motion.length / motion.step), 600, 100'000);
    }
    return out;
  }

  ReductionBasis basis(BasisKind kind, std::size_t order, const std::optional<oscillation::Pod>& pod) const {
    switch (kind) {
      case BasisKind::pod:
        break;
      case BasisKind::normal_modes:
        return normal_modes(model_.mechanics, at(order));
      case BasisKind::craig_bampton:
        return craig_bampton(model_.mechanics, at(order));
    }
    return oscillation::proper_modes(*pod, at(order));
  }

  void reduce() {
    const ReductionSection& asked = *scene_.reduction;
    if (asked.from_orbit && !run_.orbit->converged) {
      run_.remarks.emplace_back("no reduced models: the orbit that they are to be compared on was not found");
      return;
    }
    const oscillation::ComparedMotion motion = compared();
    const oscillation::Trajectory truth = trajectory(model_, motion);
    ReductionTable table{judged_form(scene_.system), truth.seconds, (motion.observed * truth.q).cwiseAbs().maxCoeff(), {}};
    std::optional<oscillation::Pod> pod;
    if (std::ranges::find(asked.bases, BasisKind::pod) != asked.bases.end()) {
      const oscillation::PodOptions options{true, model_.mechanics.mass};
      pod =
          oscillation::pod(asked.record ? recorded(*asked.record, system_.degrees()) : oscillation::Samples(truth.q.transpose()), options);
    }
    for (const BasisKind kind : asked.bases) {
      for (const std::size_t order : asked.orders) {
        stop_if(control_.interrupted);
        const oscillation::Trajectory found = trajectory(model_, basis(kind, order, pod), motion);
        table.rows.push_back({kind, order, reduction_error(model_, truth, found, motion.observed)});
      }
    }
    run_.reduction = std::move(table);
    if (scene_.sweep && scene_.sweep->reduced) sweep_reduced(pod);
  }

  const OscillateScene& scene_;
  const ident::Control& control_;
  const std::function<void(const OscillateResult&)>& so_far_;
  Model model_;
  ContactSystem system_;
  OscillateResult run_;
  int percent_ = -1;
};

}  // namespace

OscillateResult run_oscillate(const OscillateScene& scene, const ident::Control& control,
                              const std::function<void(const OscillateResult&)>& so_far) {
  return Oscillating(scene, control, so_far).run();
}

}  // namespace jointid::tasks
