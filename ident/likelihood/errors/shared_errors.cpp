#include "ident/likelihood/errors/shared_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {
namespace {

constexpr double seen = 5.0;   ///< standard deviations
constexpr double apart = 3.0;  ///< of the difference of real parts and phases

std::size_t kind_of(const ReferenceTrial& trial) { return 2 * trial.file + (trial.is_phase ? 1 : 0); }

std::vector<std::size_t> kinds_of(const ErrorTrials& trials) {
  std::vector<std::size_t> out;
  for (const ReferenceTrial& trial : trials.references) out.push_back(kind_of(trial));
  return out;
}

}  // namespace

bool SharedErrors::are_seen() const {
  return std::ranges::any_of(files, [](const OfFile& file) { return file.significance >= seen; });
}

Eigen::MatrixXd SharedErrors::scatter() const {
  if (!are_seen()) return {};
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(files.front().scatter.rows(), files.front().scatter.cols());
  for (const OfFile& file : files) out += file.share * file.scatter;
  return out;
}

double SharedErrors::bias(std::size_t file) const {
  return are_seen() ? 2.0 * std::max(0.0, files[file].averages - 1.0) * files[file].share : 0.0;
}

double SharedErrors::bias_deviation(std::size_t file) const {
  return are_seen() ? 2.0 * std::max(0.0, files[file].averages - 1.0) * files[file].deviation : 0.0;
}

SharedErrorSums::SharedErrorSums(const ErrorTrials& trials, std::size_t lines, std::size_t unknowns)
    : trials_(&trials),
      unknowns_(unknowns),
      squares_(lines, kinds_of(trials), 2 * trials.files.size()),
      scatter_(trials.files.size(), Eigen::MatrixXd::Zero(at(unknowns), at(unknowns))),
      variance_(Eigen::VectorXd::Zero(at(trials.files.size()))),
      count_(variance_) {}

void SharedErrorSums::note_variances(const ScoredLine& line) {
  if (!line.data.systematic) return;
  const std::vector<Complex> weights = weights_of(line.data);
  for (const SystematicFrf& frf : *line.data.systematic) {
    const double weight = weights[frf.element].real(), value = std::abs(frf.value);
    if (!(weight > 0.0 && value > 0.0) || frf.ways.empty()) continue;
    for (const SystematicFactor& factor : frf.ways.front().factors) {
      if (factor.unknown < trials_->shared_by_lines()) continue;
      const Eigen::Index file = at(trials_->references[factor.unknown - trials_->shared_by_lines()].file);
      const auto ways = static_cast<double>(frf.ways.size());
      variance_[file] += std::log(ways * frf.share / (weight * weight * value * value));
      count_[file] += 1.0;
      break;
    }
  }
}

void SharedErrorSums::add(const ScoredLine& line) {
  const std::size_t references = trials_->references.size();
  if (references == 0 || line.weight < 0.5) return;
  note_variances(line);
  const Eigen::Index first = at(line.columns.size() - references);
  Eigen::VectorXd scale(at(references));
  for (std::size_t k = 0; k < references; ++k) scale[at(k)] = trials_->references[k].is_phase ? 1.0 / line.data.omega : 1.0;
  const Eigen::MatrixXd& information = line.reduced.information;
  if (squares_.keeps(line.line)) {
    squares_.add(line.line, scale.cwiseProduct(line.reduced.gradient.tail(at(references))),
                 scale.asDiagonal() * information.bottomRightCorner(at(references), at(references)) * scale.asDiagonal());
  }
  for (std::size_t k = 0; k < references; ++k) {
    Eigen::VectorXd answer = Eigen::VectorXd::Zero(at(unknowns_));
    for (Eigen::Index i = 0; i < first; ++i) {
      const std::size_t unknown = line.columns[static_cast<std::size_t>(i)];
      if (unknown < unknowns_) answer[at(unknown)] = scale[at(k)] * line.weight * information(i, first + at(k));
    }
    scatter_[trials_->references[k].file] += answer * answer.transpose();
  }
}

SharedErrorSums& SharedErrorSums::operator+=(const SharedErrorSums& other) {
  squares_ += other.squares_;
  for (std::size_t f = 0; f < scatter_.size(); ++f) scatter_[f] += other.scatter_[f];
  variance_ += other.variance_;
  count_ += other.count_;
  return *this;
}

std::vector<double> SharedErrorSums::numbers() const {
  std::vector<double> out = squares_.numbers();
  const auto put = [&](const auto& of) { out.insert(out.end(), of.data(), of.data() + of.size()); };
  for (const Eigen::MatrixXd& of : scatter_) put(of);
  put(variance_);
  put(count_);
  return out;
}

void SharedErrorSums::take(const std::vector<double>& numbers) {
  const std::size_t rest = scatter_.size() * (unknowns_ * unknowns_ + 2);
  const auto middle = numbers.end() - static_cast<std::ptrdiff_t>(rest);
  squares_.take({numbers.begin(), middle});
  auto from = middle;
  const auto get = [&](auto& to) {
    std::copy_n(from, to.size(), to.data());
    from += to.size();
  };
  for (Eigen::MatrixXd& of : scatter_) get(of);
  get(variance_);
  get(count_);
}

/// Noise of the force makes errors of real parts and of phases alike; where these differ by more than chance it is the less: a gain of a
/// file is an error of real parts, a delay one of phases.
SharedErrors SharedErrorSums::result() const {
  SharedErrors out;
  const Eigen::Index files = variance_.size();
  Eigen::VectorXd most = Eigen::VectorXd::Zero(2 * files);
  for (Eigen::Index f = 0; f < files; ++f) {
    if (count_[f] > 0.0) most[2 * f] = most[2 * f + 1] = std::exp(variance_[f] / count_[f]);
  }
  const Eigen::VectorXd significance = squares_.significance(most);
  for (Eigen::Index f = 0; f < files; ++f) {
    const auto file = static_cast<std::size_t>(f);
    out.files.push_back({.significance = most[2 * f] > 0.0 ? std::min(significance[2 * f], significance[2 * f + 1]) : 0.0,
                         .variance = most[2 * f],
                         .scatter = scatter_[file],
                         .averages = trials_->files[file].averages});
  }
  if (!out.are_seen()) return out;
  const SharedVariances::Found found = squares_.estimate(most);
  for (Eigen::Index f = 0; f < files; ++f) {
    SharedErrors::OfFile& of = out.files[static_cast<std::size_t>(f)];
    const double real = found.variance[2 * f], phase = found.variance[2 * f + 1];
    const Eigen::Matrix2d covariance = found.covariance.block<2, 2>(2 * f, 2 * f);
    const double difference = covariance(0, 0) + covariance(1, 1) - 2.0 * covariance(0, 1);
    const bool differ = std::abs(real - phase) > apart * std::sqrt(difference);
    of.share = std::clamp(differ ? std::min(real, phase) : 0.5 * (real + phase), 0.0, of.variance);
    of.deviation = std::sqrt(differ ? covariance(real < phase ? 0 : 1, real < phase ? 0 : 1) : 0.25 * covariance.sum());
  }
  return out;
}

}  // namespace jointid::ident
