#include "ident/likelihood/errors/shared_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {
namespace {

constexpr double seen = 5.0;  ///< standard deviations

Eigen::Index kind_of(const ReferenceTrial& trial) { return at(2 * trial.file + (trial.is_phase ? 1 : 0)); }

std::vector<Complex> weights_of(const LineData& line) {
  std::vector<Complex> out;
  for (const Channel* channel : {&line.x, &line.y, &line.a, &line.b, &line.d}) {
    out.insert(out.end(), channel->weight.begin(), channel->weight.end());
  }
  return out;
}

}  // namespace

bool SharedErrors::are_seen() const {
  return std::ranges::any_of(files, [](const OfFile& file) { return file.significance >= seen; });
}

Eigen::MatrixXd SharedErrors::scatter() const {
  Eigen::MatrixXd out;
  for (const OfFile& file : files) {
    if (file.significance < seen) continue;
    if (out.size() == 0) out = Eigen::MatrixXd::Zero(file.scatter.rows(), file.scatter.cols());
    out += file.share * file.scatter;
  }
  return out;
}

double SharedErrors::bias(std::size_t file) const {
  const OfFile& of = files[file];
  if (of.significance < seen) return 0.0;
  return 2.0 * of.averages * of.share;
}

SharedErrorSums::SharedErrorSums(const ErrorTrials& trials, std::size_t unknowns)
    : trials_(&trials),
      unknowns_(unknowns),
      squares_(Eigen::MatrixXd::Zero(at(2 * trials.files.size()), at(2 * trials.files.size()))),
      excess_(Eigen::VectorXd::Zero(at(2 * trials.files.size()))),
      information_(excess_),
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
  const std::size_t first = line.columns.size() - references;
  const Eigen::MatrixXd& information = line.reduced.information;
  std::vector<double> scale(references);
  for (std::size_t k = 0; k < references; ++k) scale[k] = trials_->references[k].is_phase ? 1.0 / line.data.omega : 1.0;
  for (std::size_t k = 0; k < references; ++k) {
    const Eigen::Index kind = kind_of(trials_->references[k]);
    const double gradient = scale[k] * line.reduced.gradient[at(first + k)];
    const double own = scale[k] * scale[k] * information(at(first + k), at(first + k));
    excess_[kind] += gradient * gradient - own;
    information_[kind] += own;
    for (std::size_t l = 0; l < references; ++l) {
      const double cross = scale[k] * scale[l] * information(at(first + k), at(first + l));
      squares_(kind, kind_of(trials_->references[l])) += cross * cross;
    }
    Eigen::VectorXd answer = Eigen::VectorXd::Zero(at(unknowns_));
    for (std::size_t i = 0; i < first; ++i) {
      if (line.columns[i] < unknowns_) answer[at(line.columns[i])] = scale[k] * line.weight * information(at(i), at(first + k));
    }
    scatter_[trials_->references[k].file] += answer * answer.transpose();
  }
}

SharedErrorSums& SharedErrorSums::operator+=(const SharedErrorSums& other) {
  squares_ += other.squares_;
  excess_ += other.excess_;
  information_ += other.information_;
  for (std::size_t f = 0; f < scatter_.size(); ++f) scatter_[f] += other.scatter_[f];
  variance_ += other.variance_;
  count_ += other.count_;
  return *this;
}

std::vector<double> SharedErrorSums::numbers() const {
  std::vector<double> out;
  const auto put = [&](const auto& of) { out.insert(out.end(), of.data(), of.data() + of.size()); };
  put(squares_);
  put(excess_);
  put(information_);
  for (const Eigen::MatrixXd& of : scatter_) put(of);
  put(variance_);
  put(count_);
  return out;
}

void SharedErrorSums::take(const std::vector<double>& numbers) {
  auto from = numbers.begin();
  const auto get = [&](auto& to) {
    std::copy_n(from, to.size(), to.data());
    from += to.size();
  };
  get(squares_);
  get(excess_);
  get(information_);
  for (Eigen::MatrixXd& of : scatter_) get(of);
  get(variance_);
  get(count_);
}

/// A gain of a file is an error of real parts, a delay one of phases: what both have is shared on a line alone.
SharedErrors SharedErrorSums::result() const {
  SharedErrors out;
  const auto files = static_cast<std::size_t>(variance_.size());
  std::vector<Eigen::Index> there;
  for (Eigen::Index kind = 0; kind < excess_.size(); ++kind) {
    if (squares_(kind, kind) > 0.0) there.push_back(kind);
  }
  for (std::size_t f = 0; f < files; ++f) {
    const double variance = count_[at(f)] > 0.0 ? std::exp(variance_[at(f)] / count_[at(f)]) : 0.0;
    const bool is_tried = variance > 0.0;
    out.files.push_back({.share = variance,
                         .significance = is_tried ? std::numeric_limits<double>::infinity() : 0.0,
                         .variance = variance,
                         .scatter = scatter_[f],
                         .averages = trials_->files[f].averages});
  }
  if (there.empty()) return out;
  Eigen::MatrixXd rate = squares_(there, there);
  for (std::size_t i = 0; i < there.size(); ++i) {
    const double variance = out.files[static_cast<std::size_t>(there[i] / 2)].variance, square = squares_(there[i], there[i]);
    if (variance > 0.0) rate(at(i), at(i)) -= std::min(information_[there[i]] / variance, 0.5 * square);
  }
  const Eigen::VectorXd share = dense::solve_symmetric(rate, excess_(there));
  const Eigen::MatrixXd squares = squares_(there, there);
  const Eigen::MatrixXd covariance = 2.0 * dense::solve_symmetric(squares, Eigen::MatrixXd::Identity(squares.rows(), squares.cols()));
  for (std::size_t i = 0; i < there.size(); ++i) {
    SharedErrors::OfFile& of = out.files[static_cast<std::size_t>(there[i] / 2)];
    of.share = std::clamp(share[at(i)], 0.0, of.share);
    of.significance = std::min(of.significance, share[at(i)] / std::sqrt(covariance(at(i), at(i))));
  }
  return out;
}

}  // namespace jointid::ident
