#include "ident/likelihood/errors/line_scores.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/model/corrected_line.hpp"

namespace jointid::ident {
namespace {

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

class LineScores {
 public:
  LineScores(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit, const SystematicLines& trials,
             const TermsOf& terms)
      : plan_(plan), estimator_(estimator), fit_(fit), trials_(trials), terms_(terms), unknowns_(trials.plan().unknowns()) {}

  template <class Look>
  void score(std::size_t i, LineModel& model, const Look& look) const {
    const Observations& observations = *likelihood_plan(plan_)->observations;
    const std::size_t joint = plan_.columns->size(), known = fit_.theta.size();
    LineData data = corrected_line(observations.lines()[i], observations.systematic(), std::span(fit_.theta).subspan(joint));
    const std::shared_ptr<const SystematicTerms> declared = data.terms;
    data.systematic = observations.systematic_frfs(i, trials_);
    if (!terms_) data = corrected_line(data, unknowns_, {});
    data.terms = joined(declared.get(), known - joint, terms_ ? terms_(i, data) : *data.terms);
    const JointImpedance impedance = joint_at(plan_.restriction, *plan_.columns, plan_.omega0, data.omega);
    model.linearise(data, impedance, estimator_.impedance_of(i, fit_.theta), estimator_.state_of(i), true);
    const auto reduced = model.reduce(0.0, false);
    if (!reduced) return;
    std::vector<std::size_t> columns = impedance.columns();
    for (std::size_t column = joint; column < joint + data.terms->unknowns; ++column) columns.push_back(column);
    look({i, fit_.line_weight[i], columns, *reduced, data});
  }

 private:
  const Plan& plan_;
  const LinearisedLikelihood& estimator_;
  const LikelihoodFit& fit_;
  const SystematicLines& trials_;
  const TermsOf& terms_;
  std::vector<SystematicUnknown> unknowns_;
};

}  // namespace

std::vector<Complex> weights_of(const LineData& line) {
  std::vector<Complex> out;
  for (const Channel* channel : {&line.x, &line.y, &line.a, &line.b, &line.d}) {
    out.insert(out.end(), channel->weight.begin(), channel->weight.end());
  }
  return out;
}

void score_lines(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit, const SystematicLines& trials,
                 const Control& control, const std::function<void(std::size_t run, const ScoredLine& line)>& look,
                 const TermsOf& terms) {
  const Observations& observations = *likelihood_plan(plan)->observations;
  const LineShares::Range lines = observations.shares().own(observations.lines().size());
  const LineScores line_scores(plan, estimator, fit, trials, terms);
  const std::size_t runs = std::min(most_runs, lines.size());
  const auto score = [&](std::size_t run) {
    const auto begin = [&](std::size_t r) { return lines.first + r * lines.size() / runs; };
    LineModel model(observations.layout());
    for (std::size_t i = begin(run); i < begin(run + 1); ++i) {
      stop_if(control.interrupted);
      if (fit.line_weight[i] > 0.0) line_scores.score(i, model, [&](const ScoredLine& line) { look(run, line); });
    }
  };
  if (control.threads == 1) {
    for (std::size_t run = 0; run < runs; ++run) score(run);
    return;
  }
  oneapi::tbb::task_arena arena(control.threads == 0 ? oneapi::tbb::task_arena::automatic : static_cast<int>(control.threads));
  arena.execute([&] { oneapi::tbb::parallel_for(std::size_t{0}, runs, score); });
}

Scores Scores::none(std::size_t unknowns) {
  return {Eigen::MatrixXd::Zero(at(unknowns), at(unknowns)), Eigen::VectorXd::Zero(at(unknowns))};
}

void Scores::add(const ScoredLine& line) {
  const auto here = static_cast<std::size_t>(gradient.size());
  for (std::size_t i = 0; i < line.columns.size(); ++i) {
    if (line.columns[i] >= here) continue;
    gradient[at(line.columns[i])] += line.weight * line.reduced.gradient[at(i)];
    for (std::size_t j = 0; j < line.columns.size(); ++j) {
      if (line.columns[j] >= here) continue;
      information(at(line.columns[i]), at(line.columns[j])) += line.weight * line.reduced.information(at(i), at(j));
    }
  }
}

Scores& Scores::operator+=(const Scores& other) {
  information += other.information;
  gradient += other.gradient;
  return *this;
}

Scores left_of(const Scores& whole, std::size_t known) {
  const Eigen::Index r = at(known), t = whole.information.rows() - r;
  Eigen::MatrixXd right(r, t + 1);
  right << whole.information.topRightCorner(r, t), whole.gradient.head(r);
  const Eigen::MatrixXd solved = dense::solve_symmetric(whole.information.topLeftCorner(r, r), right);
  const Eigen::MatrixXd cross = whole.information.bottomLeftCorner(t, r);
  return {whole.information.bottomRightCorner(t, t) - cross * solved.leftCols(t), whole.gradient.tail(t) - cross * solved.col(t)};
}

}  // namespace jointid::ident
