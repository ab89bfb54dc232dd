#include "ident/likelihood/errors/tried_errors.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/errors/sensor_screen.hpp"

namespace jointid::ident {
namespace {

ErrorTrials trials_of(const Plan& plan, bool of_sensors) {
  const Observations& observations = *likelihood_plan(plan)->observations;
  ErrorTrials trials;
  if (of_sensors) trials.add_sensors(plan);
  if (trials.sensors.size() > ErrorTrials::most) trials = {};
  if (observations.systematic_plan() != nullptr) return trials;
  trials.add_files(plan);
  trials.add_stretches();
  ErrorTrials more = trials;
  more.add_references(plan);
  return !observations.has_independent_errors() || more.references.size() > ErrorTrials::most ? trials : more;
}

/// Sums of all kinds over the lines of a run.
struct Sums {
  Scores scores;
  SharedErrorSums shared;
  BlockScores blocks;

  void add(const ScoredLine& line) {
    scores.add(line);
    shared.add(line);
    blocks.add(line);
  }
  Sums& operator+=(const Sums& other) {
    scores += other.scores;
    shared += other.shared;
    blocks += other.blocks;
    return *this;
  }
};

template <class T>
void exchange(const LineShares& shares, T& sums) {
  if (shares.size() == 1) return;
  std::vector<double> numbers = sums.numbers();
  shares.sum(numbers);
  sums.take(numbers);
}

/// Over all processes.
Sums total(Sums all, const LineShares& shares) {
  shares.sum({all.scores.information.data(), static_cast<std::size_t>(all.scores.information.size())});
  shares.sum({all.scores.gradient.data(), static_cast<std::size_t>(all.scores.gradient.size())});
  exchange(shares, all.shared);
  exchange(shares, all.blocks);
  return all;
}

/// In one pass over the lines. `screen`: takes them, too.
TriedErrors tried(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit, double inflation,
                  const Control& control, ErrorTrials trials, LinearisedLikelihood::NearbyGradients& nearby, SensorScreen* screen) {
  TriedErrors out;
  out.trials = std::move(trials);
  const LikelihoodPlan& own = *likelihood_plan(plan);
  const std::size_t known = fit.theta.size(), summed = known + out.trials.shared_by_lines();
  const SystematicLines lines(out.trials.plan, *plan.substructures, *plan.assembly, own.observations->layout().coordinates);
  const std::size_t count = fit.line_weight.size();
  const Sums none{Scores::none(summed), SharedErrorSums(out.trials, count, known),
                  BlockScores(count, known, known + out.trials.first_stretch(), out.trials.stretches)};
  const FactorsOf factors = [&](std::size_t line, LineModel& model) {
    if (!nearby.offsets.empty()) estimator.take_nearby(line, model, nearby);
    if (screen != nullptr) screen->take(line, model);
  };
  Sums all = total(sum_over_lines(plan, estimator, fit, lines, control, none, {}, factors), own.observations->shares());
  out.scores = std::move(all.scores);
  out.shared = all.shared.result();
  out.blocks = std::move(all.blocks);
  for (const auto& [column, value, weight] : own.priors) {
    out.scores.information(at(column), at(column)) += weight * weight;
    out.scores.gradient[at(column)] += weight * weight * (value - fit.theta[column]);
  }
  out.inflation = inflation;
  out.is_calibration_stated = !plan.scene.data.gains.empty();
  if (!out.trials.files.empty()) out.files = file_gains(out.trials, out.scores, known, out.inflation);
  const auto gains = out.files.begin() + static_cast<std::ptrdiff_t>(out.files.size() - out.trials.stretches);
  out.stretches.assign(gains, out.files.end());
  out.files.erase(gains, out.files.end());
  return out;
}

}  // namespace

std::optional<TriedErrors> try_errors(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit,
                                      double chi_square, const Control& control, LinearisedLikelihood::NearbyGradients& nearby) {
  if (!plan.scene.couple_first.pairs.empty()) return std::nullopt;
  const double inflation = std::sqrt(std::max(1.0, chi_square));
  const auto tried_with = [&](bool of_sensors, SensorScreen* screen) {
    return tried(plan, estimator, fit, inflation, control, trials_of(plan, of_sensors), nearby, screen);
  };
  const bool of_sensors = control.detail == Detail::full;
  if (!of_sensors) return tried_with(false, nullptr);
  const std::unique_ptr<SensorScreen> screen = SensorScreen::of(plan, estimator, fit, inflation, control);
  if (screen == nullptr || !screen->is_promising()) return tried_with(true, nullptr);
  TriedErrors without = tried_with(false, screen.get());
  if (screen->excludes_all(without.scores.gradient.head(at(fit.theta.size())))) return without;
  return tried_with(true, nullptr);
}

const FileGain* TriedErrors::stretch() const {
  const FileGain* out = nullptr;
  for (const FileGain& each : stretches) {
    if (out == nullptr || std::abs(each.score) > std::abs(out->score) + 1.0) out = &each;
  }
  return out;
}

std::optional<Jackknife> TriedErrors::jackknife(std::size_t known, const FileGain* taken) const {
  Eigen::VectorXd change = Eigen::VectorXd::Zero(at(stretches.size()));
  if (taken != nullptr) change[taken - stretches.data()] = taken->gain;
  std::vector<Eigen::Index> which;
  for (std::size_t u = 0; u < known; ++u) which.push_back(at(u));
  for (std::size_t s = 0; s < stretches.size(); ++s) which.push_back(at(known + trials.first_stretch() + s));
  return blocks->jackknife({scores.information(which, which), scores.gradient(which)}, change);
}

}  // namespace jointid::ident
