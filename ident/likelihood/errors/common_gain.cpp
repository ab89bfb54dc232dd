#include "ident/likelihood/errors/common_gain.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"

namespace jointid::ident {
namespace {

constexpr double telling = 4.5;     ///< standard deviations
constexpr double least_left = 1e-6;  ///< of the information on a gain: what the others leave of it

}  // namespace

double FileGain::posterior_variance() const {
  const double prior = usual_calibration * usual_calibration;
  return is_determined() ? 1.0 / (1.0 / (error * error) + 1.0 / prior) : prior;
}

double FileGain::posterior_mean() const { return is_determined() ? gain * posterior_variance() / (error * error) : 0.0; }

std::vector<FileGain> file_gains(const ErrorTrials& trials, const Scores& scores, std::size_t known, double inflation) {
  const Eigen::Index r = at(known), count = at(trials.shared_by_lines() - trials.sensors.size()), first = r + at(trials.sensors.size());
  const Eigen::MatrixXd cross = scores.information.block(0, first, r, count);
  Eigen::MatrixXd right(r, count + 1);
  right << cross, scores.gradient.head(r);
  const Eigen::MatrixXd solved = dense::solve_symmetric(scores.information.topLeftCorner(r, r), right);
  std::vector<FileGain> out;
  for (Eigen::Index f = 0; f < count; ++f) {
    const double all = scores.information(first + f, first + f), left = all - cross.col(f).dot(solved.col(f));
    const auto file = static_cast<std::size_t>(f);
    FileGain of{.file = trials.files[file % trials.files.size()], .answer = -solved.col(f)};
    if (left > least_left * all) {
      const double gradient = scores.gradient[first + f] - cross.col(f).dot(solved.col(count));
      of.error = inflation / std::sqrt(left);
      of.gain = gradient / left;
      of.score = of.gain / of.error;
    }
    out.push_back(std::move(of));
  }
  return out;
}

const FileGain* telling_gain(const std::vector<FileGain>& gains) {
  const auto best = std::ranges::max_element(gains, {}, [](const FileGain& gain) { return std::abs(gain.score); });
  return best != gains.end() && std::abs(best->score) >= telling ? &*best : nullptr;
}

AssumedGain::AssumedGain(const Plan& plan, const FileTrial& file) : plan_(plan) {
  LikelihoodPlan& own = *likelihood_plan(plan);
  ErrorTrials trials;
  trials.add_files(plan);
  const auto chosen = std::ranges::find_if(trials.files, [&](const FileTrial& other) {
    return other.of_assembly == file.of_assembly && (file.of_assembly || other.number == file.number);
  });
  SystematicPlan gain;
  gain.add({{Systematic::gain, usual_calibration}, "gain of " + std::string(file.of_assembly ? "the assembly" : file.name), "", 0.0},
           trials.roles[static_cast<std::size_t>(chosen - trials.files.begin())]);
  own.observations->assume(std::move(gain), *plan.substructures, *plan.assembly);
  own.priors.push_back({plan.columns->size(), 0.0, 1.0});
}

AssumedGain::~AssumedGain() {
  LikelihoodPlan& own = *likelihood_plan(plan_);
  own.priors.pop_back();
  own.observations->assume({}, *plan_.substructures, *plan_.assembly);
}

}  // namespace jointid::ident
