#include "ident/likelihood/findings/gain_scores.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/text.hpp"
#include "dense/cholesky.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/line/corrected_line.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t most_sensors = 256, most_suspects = 3;
constexpr double significant = 5.0;
constexpr double dependent = 1e-6;  ///< of the information on a gain: what the others leave of it
constexpr double nearly = 0.95;     ///< of the largest score

struct Trial {
  frf::Dof dof;
  std::string file;
  bool of_assembly;
};

/// The gains that are tried.
struct Trials {
  SystematicPlan plan;
  std::vector<Trial> sensors;

  void add(bool of_assembly, std::size_t file, const frf::FrfHeader& header, const SystematicPlan* declared,
           const Dofs& coordinates) {
    for (const frf::Dof& dof : coordinates) {
      const bool response = frf::has(header.response, dof);
      if (!response && !frf::has(header.reference, dof)) continue;
      const SensorRole role{of_assembly, file, !response, dof};
      if (declared != nullptr && !declared->of(role).empty()) continue;
      plan.add({{Systematic::gain, 1.0}, dof.name(), "", 0.0}, {role});
      sensors.push_back({dof, header.file, of_assembly});
    }
  }
};

Trials trials_of(const Plan& plan, const Observations& observations) {
  Trials out;
  const Dofs& coordinates = observations.layout().coordinates;
  for (const bool of_assembly : {false, true}) {
    const frf::FrfSystem& system = of_assembly ? *plan.assembly : *plan.substructures;
    for (std::size_t s = 0; s < system.source_count(); ++s) {
      out.add(of_assembly, s, system.source(s).header(), observations.systematic_plan(), coordinates);
    }
  }
  return out;
}

/// The terms of both, those of `more` numbered after the others.
std::shared_ptr<const SystematicTerms> joined(const SystematicTerms* declared, std::size_t unknowns,
                                              const SystematicTerms& more) {
  auto out = std::make_shared<SystematicTerms>();
  out->unknowns = unknowns + more.unknowns;
  out->first = {0};
  for (std::size_t element = 0; element + 1 < more.first.size(); ++element) {
    for (std::size_t t = declared ? declared->first[element] : 0; declared && t < declared->first[element + 1]; ++t) {
      out->terms.push_back(declared->terms[t]);
    }
    for (std::size_t t = more.first[element]; t < more.first[element + 1]; ++t) {
      out->terms.push_back(more.terms[t]);
      out->terms.back().unknown += unknowns;
    }
    out->first.push_back(out->terms.size());
  }
  return out;
}

/// Information and gradient of all unknowns, those of the trials last.
struct Scores {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
};

void add_line(const ReducedLine& line, const std::vector<std::size_t>& columns, double weight, Scores& to) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    to.gradient[at(columns[i])] += weight * line.gradient[at(i)];
    for (std::size_t j = 0; j < columns.size(); ++j)
      to.information(at(columns[i]), at(columns[j])) += weight * line.information(at(i), at(j));
  }
}

/// One line after the other, from `first` to `last`.
class LineScores {
 public:
  LineScores(const Plan& plan, const LikelihoodEstimator& estimator, const LikelihoodFit& fit, const SystematicLines& trials)
      : plan_(plan), estimator_(estimator), fit_(fit), trials_(trials), unknowns_(trials.plan().unknowns()) {}

  std::size_t unknowns() const { return fit_.theta.size() + unknowns_.size(); }
  Scores none() const { return {Eigen::MatrixXd::Zero(at(unknowns()), at(unknowns())), Eigen::VectorXd::Zero(at(unknowns()))}; }

  Scores of(std::size_t first, std::size_t last, LineModel& model, const Control& control) const {
    Scores out = none();
    for (std::size_t i = first; i < last; ++i) {
      stop_if(control.interrupted);
      if (fit_.line_weight[i] > 0.0) add(i, model, out);
    }
    return out;
  }

 private:
  void add(std::size_t i, LineModel& model, Scores& out) const {
    const Observations& observations = *likelihood_plan(plan_)->observations;
    const std::size_t joint = plan_.columns->size(), known = fit_.theta.size();
    LineData data = corrected_line(observations.lines()[i], observations.systematic(), std::span(fit_.theta).subspan(joint));
    const std::shared_ptr<const SystematicTerms> declared = data.terms;
    data.systematic = observations.systematic_frfs(i, trials_);
    data = corrected_line(data, unknowns_, {});
    data.terms = joined(declared.get(), known - joint, *data.terms);
    const JointImpedance impedance(plan_.restriction, *plan_.columns, plan_.omega0, data.omega);
    model.linearise(data, impedance, estimator_.impedance_of(i, fit_.theta), estimator_.state_of(i), true);
    const auto reduced = model.reduce(0.0, false);
    if (!reduced) return;
    std::vector<std::size_t> columns = impedance.columns();
    for (std::size_t column = joint; column < unknowns(); ++column) columns.push_back(column);
    add_line(*reduced, columns, fit_.line_weight[i], out);
  }

  const Plan& plan_;
  const LikelihoodEstimator& estimator_;
  const LikelihoodFit& fit_;
  const SystematicLines& trials_;
  std::vector<SystematicUnknown> unknowns_;
};

/// In runs of lines, side by side; what they sum to does not depend on the number of threads.
Scores scores_of(const Plan& plan, const LikelihoodEstimator& estimator, const LikelihoodFit& fit, const SystematicLines& trials,
                 const Control& control) {
  constexpr std::size_t most_runs = 16;
  const LikelihoodPlan& own = *likelihood_plan(plan);
  const Observations& observations = *own.observations;
  const LineShares::Range lines = observations.shares().own(observations.lines().size());
  const LineScores line_scores(plan, estimator, fit, trials);
  const std::size_t runs = std::min(most_runs, lines.size());
  std::vector<Scores> each(runs);
  const auto score = [&](std::size_t run) {
    const auto begin = [&](std::size_t r) { return lines.first + r * lines.size() / runs; };
    LineModel model(observations.layout());
    each[run] = line_scores.of(begin(run), begin(run + 1), model, control);
  };
  oneapi::tbb::task_arena arena(control.threads == 0 ? oneapi::tbb::task_arena::automatic : static_cast<int>(control.threads));
  arena.execute([&] { oneapi::tbb::parallel_for(std::size_t{0}, runs, score); });
  Scores out = line_scores.none();
  for (const Scores& run : each) {
    out.information += run.information;
    out.gradient += run.gradient;
  }
  observations.shares().sum({out.information.data(), static_cast<std::size_t>(out.information.size())});
  observations.shares().sum({out.gradient.data(), static_cast<std::size_t>(out.gradient.size())});
  for (const auto& [column, value, weight] : own.priors) {
    out.information(at(column), at(column)) += weight * weight;
    out.gradient[at(column)] += weight * weight * (value - fit.theta[column]);
  }
  return out;
}

/// What is left of information and gradient of the trials once `known` columns are eliminated.
Scores left_of(const Scores& whole, std::size_t known) {
  const Eigen::Index r = at(known), t = whole.information.rows() - r;
  Eigen::MatrixXd right(r, t + 1);
  right << whole.information.topRightCorner(r, t), whole.gradient.head(r);
  const Eigen::MatrixXd solved = dense::solve_symmetric(whole.information.topLeftCorner(r, r), right);
  const Eigen::MatrixXd cross = whole.information.bottomLeftCorner(t, r);
  return {whole.information.bottomRightCorner(t, t) - cross * solved.leftCols(t), whole.gradient.tail(t) - cross * solved.col(t)};
}

/// Takes trial k as known: the others given it.
void take(Eigen::Index k, Scores& scores) {
  const Eigen::VectorXd column = scores.information.col(k) / scores.information(k, k);
  const Eigen::RowVectorXd row = scores.information.row(k);
  scores.gradient -= column * scores.gradient[k];
  scores.information -= column * row;
}

std::string other_file(const std::vector<Trial>& sensors, const std::vector<double>& scores, std::size_t best) {
  for (std::size_t k = 0; k < sensors.size(); ++k) {
    if (k == best || !sensors[k].dof.same_coordinate(sensors[best].dof)) continue;
    if (std::abs(scores[k]) >= nearly * std::abs(scores[best]) && scores[k] * scores[best] < 0.0) return sensors[k].file;
  }
  return "";
}

}  // namespace

std::vector<GainSuspect> suspect_gains(const Plan& plan, const LikelihoodEstimator& estimator, const LikelihoodFit& fit,
                                       const ChiSquare& chi_square, const Control& control) {
  const LikelihoodPlan& own = *likelihood_plan(plan);
  Trials trials = trials_of(plan, *own.observations);
  const std::vector<Trial> sensors = trials.sensors;
  if (sensors.empty() || sensors.size() > most_sensors || !plan.scene.couple_first.pairs.empty()) return {};
  const SystematicLines lines(std::move(trials.plan), *plan.substructures, *plan.assembly,
                              own.observations->layout().coordinates);
  Scores scores = left_of(scores_of(plan, estimator, fit, lines, control), fit.theta.size());
  const Eigen::VectorXd at_first = scores.information.diagonal();
  const double inflation = std::sqrt(std::max(1.0, chi_square.value / std::max(1.0, chi_square.degrees_of_freedom)));
  std::vector<GainSuspect> out;
  while (out.size() < most_suspects) {
    std::vector<double> z(sensors.size(), 0.0);
    for (std::size_t k = 0; k < z.size(); ++k) {
      const double information = scores.information(at(k), at(k));
      if (information > dependent * at_first[at(k)]) z[k] = scores.gradient[at(k)] / std::sqrt(information) / inflation;
    }
    const auto best =
        static_cast<std::size_t>(std::ranges::max_element(z, {}, [](double value) { return std::abs(value); }) - z.begin());
    if (!(std::abs(z[best]) >= significant)) break;
    const Eigen::Index k = at(best);
    const double information = scores.information(k, k);
    out.push_back({.sensor = sensors[best].dof.name() + " in " + sensors[best].file,
                   .gain = std::exp(scores.gradient[k] / information),
                   .error = inflation / std::sqrt(information),
                   .score = z[best],
                   .instead = other_file(sensors, z, best)});
    take(k, scores);
  }
  return out;
}

void tell_gains(const std::vector<GainSuspect>& suspects, Solution& out) {
  if (!out.identifiability) return;
  for (const GainSuspect& each : suspects) {
    std::string text = "The FRFs fit better with a gain of " + digits(each.gain, "%.4f") + " ± " + digits(each.error, "%.1g") +
                       " of the sensor " + each.sensor + " (" + digits(std::abs(each.score), "%.2g") +
                       " standard deviations from 1)";
    if (!each.instead.empty()) text += ", or with its inverse in " + each.instead;
    out.identifiability->findings.push_back(
        {FindingKind::gain, text + ". Is its calibration off? [[data.gains]] estimates it with the joint."});
  }
}

}  // namespace jointid::ident
