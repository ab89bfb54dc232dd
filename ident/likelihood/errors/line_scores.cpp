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
void join(const SystematicTerms& declared, std::size_t unknowns, const SystematicTerms& more, SystematicTerms& out) {
  out.unknowns = unknowns + more.unknowns;
  out.terms.clear();
  out.first.assign(1, 0);
  for (std::size_t element = 0; element + 1 < more.first.size(); ++element) {
    for (std::size_t t = declared.first[element]; t < declared.first[element + 1]; ++t) out.terms.push_back(declared.terms[t]);
    for (std::size_t t = more.first[element]; t < more.first[element + 1]; ++t) {
      out.terms.push_back(more.terms[t]);
      out.terms.back().unknown += unknowns;
    }
    out.first.push_back(out.terms.size());
  }
}

/// What a run of lines needs, in which every line takes over the memory of the one before.
struct Room {
  explicit Room(const LineLayout& layout) : model(layout) {}

  LineModel model;
  LineData data;
  std::shared_ptr<SystematicFrfs> frfs = std::make_shared<SystematicFrfs>();
  std::shared_ptr<SystematicTerms> terms = std::make_shared<SystematicTerms>(), all = std::make_shared<SystematicTerms>();
  std::vector<std::size_t> columns;
};

class LineScores {
 public:
  LineScores(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit, const SystematicLines& trials,
             const TermsOf& terms)
      : observations_(*likelihood_plan(plan)->observations),
        joint_(plan.columns->size()),
        estimator_(estimator),
        fit_(fit),
        trials_(trials),
        terms_(terms),
        unknowns_(trials.plan().unknowns()) {}

  /// The model of the room has the factors then.
  template <class Look>
  bool score(std::size_t i, Room& room, const Look& look) const {
    LineData& data = room.data;
    if (observations_.systematic().empty()) {
      data = observations_.lines()[i];
    } else {
      data = corrected_line(observations_.lines()[i], observations_.systematic(), std::span(fit_.theta).subspan(joint_));
    }
    put_terms(i, room);
    const JointImpedance& impedance = estimator_.line_at(i).joint;
    room.model.linearise(data, impedance, estimator_.impedance_of(i, fit_.theta), estimator_.state_of(i), true);
    const auto reduced = room.model.reduce(0.0, false);
    if (!reduced) return false;
    room.columns = impedance.columns();
    for (std::size_t u = 0; u < data.terms->unknowns; ++u) room.columns.push_back(joint_ + u);
    look({i, fit_.line_weight[i], room.columns, *reduced, data});
    return true;
  }

 private:
  void put_terms(std::size_t i, Room& room) const {
    LineData& data = room.data;
    const std::shared_ptr<const SystematicTerms> declared = data.terms;
    observations_.write_systematic_frfs(i, trials_, *room.frfs);
    data.systematic = room.frfs;
    if (terms_) {
      *room.terms = terms_(i, data);
    } else {
      write_terms(data, unknowns_, *room.terms);
    }
    data.terms = room.terms;
    if (!declared) return;
    join(*declared, fit_.theta.size() - joint_, *room.terms, *room.all);
    data.terms = room.all;
  }

  const Observations& observations_;
  std::size_t joint_;
  const LinearisedLikelihood& estimator_;
  const LikelihoodFit& fit_;
  const SystematicLines& trials_;
  const TermsOf& terms_;
  std::vector<SystematicUnknown> unknowns_;
};

}  // namespace

std::vector<Complex> weights_of(const LineData& line) {
  std::vector<Complex> out;
  for (const Channel* channel : {&line.sub_jn, &line.sub_jj, &line.asm_jn, &line.asm_jj, &line.drop_nn}) {
    out.insert(out.end(), channel->weight.begin(), channel->weight.end());
  }
  return out;
}

void score_lines(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit, const SystematicLines& trials,
                 const Control& control, const std::function<void(std::size_t run, const ScoredLine& line)>& look,
                 const TermsOf& terms, const FactorsOf& factors) {
  const Observations& observations = *likelihood_plan(plan)->observations;
  const LineShares::Range lines = observations.shares().own(observations.lines().size());
  const LineScores line_scores(plan, estimator, fit, trials, terms);
  const std::size_t runs = std::min(most_runs, lines.size());
  const auto score = [&](std::size_t run) {
    const auto begin = [&](std::size_t r) { return lines.first + r * lines.size() / runs; };
    Room room(observations.layout());
    for (std::size_t i = begin(run); i < begin(run + 1); ++i) {
      stop_if(control.interrupted);
      if (!(fit.line_weight[i] > 0.0)) continue;
      const bool has_factors = line_scores.score(i, room, [&](const ScoredLine& line) { look(run, line); });
      if (has_factors && factors) factors(i, room.model);
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
