#include "ident/likelihood/parts/parts_covariance.hpp"

#include <Eigen/SparseCore>
#include <cmath>
#include <map>

#include "base/eigen.hpp"
#include "base/parallel.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Two groups that take the same motions.
struct Neighbours {
  std::size_t first = 0, second = 0;
  std::vector<std::pair<std::size_t, std::size_t>> motions;  ///< places in each
  MatrixXd covariance;                                       ///< of their gradients [columns of the first, of the second]
};

std::vector<Neighbours> neighbours_of(const PartGroups& all, const PartsData& data) {
  std::map<std::int64_t, std::vector<std::pair<std::size_t, std::size_t>>> takers;
  for (std::size_t g = 0; g < all.groups.size(); ++g) {
    const Dofs& motions = all.groups[g].motions;
    for (std::size_t m = 0; m < motions.size(); ++m) takers[frf::coordinate_key(motions[m])].emplace_back(g, m);
  }
  std::map<std::pair<std::size_t, std::size_t>, Neighbours> pairs;
  for (const auto& [key, by] : takers) {
    for (std::size_t a = 0; a < by.size(); ++a) {
      for (std::size_t b = a + 1; b < by.size(); ++b) pairs[{by[a].first, by[b].first}].motions.emplace_back(by[a].second, by[b].second);
    }
  }
  std::vector<Neighbours> out;
  for (auto& [groups, pair] : pairs) {
    pair.first = groups.first;
    pair.second = groups.second;
    pair.covariance = MatrixXd::Zero(at(data.columns(pair.first).size()), at(data.columns(pair.second).size()));
    out.push_back(std::move(pair));
  }
  return out;
}

/// All groups at one line, linearised where the fit ended.
class LineOfGroups {
 public:
  LineOfGroups(const Plan& plan, const PartGroups& all, PartsData& data, const PartsFit& fit, std::size_t line, std::size_t threads)
      : all_(all), data_(data), line_(line), linearised_(all.groups.size()), answers_(all.groups.size()), threads_(threads) {
    for_each_index(all.groups.size(), threads, [&](std::size_t g) {
      const GroupLine& own = data.groups()[g][line];
      std::vector<double> theta;
      for (const std::size_t place : own.columns) theta.push_back(fit.theta[data.columns(g)[place]]);
      impedance_[g] = group_impedance(all.groups[g], theta, own.omega, plan.omega0);
      linearised_[g] = std::make_unique<GroupLinearisation>(all.groups[g], all, own, impedance_[g]);
    });
  }

  void add(std::vector<Neighbours>& pairs) {
    for (std::size_t l = 0; l < all_.references.size(); ++l) {
      for_each_index(answers_.size(), threads_, [&](std::size_t g) { answers_[g] = linearised_[g]->answer(l); });
      for_each_index(pairs.size(), threads_, [&](std::size_t k) { add(l, pairs[k]); });
    }
  }

 private:
  void add(std::size_t reference, Neighbours& pair) const {
    const GroupLine& one = data_.groups()[pair.first][line_];
    const GroupLine& two = data_.groups()[pair.second][line_];
    const MatrixXcd& first = answers_[pair.first];
    const MatrixXcd& second = answers_[pair.second];
    MatrixXd sum = MatrixXd::Zero(first.cols(), second.cols());
    for (const auto& [m, n] : pair.motions) {
      const double variance = std::sqrt(one.variance.motion(at(m), at(reference)) * two.variance.motion(at(n), at(reference)));
      sum += 0.5 * variance * (first.row(at(m)).adjoint() * second.row(at(n))).real();
    }
    for (std::size_t i = 0; i < one.columns.size(); ++i) {
      for (std::size_t j = 0; j < two.columns.size(); ++j)
        pair.covariance(at(one.columns[i]), at(two.columns[j])) += sum(at(i), at(j));
    }
  }

  const PartGroups& all_;
  PartsData& data_;
  std::size_t line_;
  std::vector<GroupImpedance> impedance_ = std::vector<GroupImpedance>(all_.groups.size());
  std::vector<std::unique_ptr<GroupLinearisation>> linearised_;
  std::vector<MatrixXcd> answers_;
  std::size_t threads_;
};

using Sparse = Eigen::SparseMatrix<double>;

/// Of the gradient of all groups.
Sparse gradient_covariance(const minimise::SparseSymmetric& information, const std::vector<Neighbours>& pairs, const PartsData& data) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](std::size_t i, std::size_t j, double value) {
    entries.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
  };
  for (std::size_t c = 0; c < information.size(); ++c) {
    for (auto i = static_cast<std::size_t>(information.start[c]); i < static_cast<std::size_t>(information.start[c + 1]); ++i) {
      const auto row = static_cast<std::size_t>(information.row[i]);
      add(row, c, 0.5 * information.value[i]);
      if (row != c) add(c, row, 0.5 * information.value[i]);
    }
  }
  for (const Neighbours& pair : pairs) {
    const auto& rows = data.columns(pair.first);
    const auto& columns = data.columns(pair.second);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < columns.size(); ++j) {
        add(rows[i], columns[j], pair.covariance(at(i), at(j)));
        add(columns[j], rows[i], pair.covariance(at(i), at(j)));
      }
    }
  }
  Sparse out(at(information.size()), at(information.size()));
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

}  // namespace

MatrixXd dense_information(const minimise::SparseSymmetric& information) {
  MatrixXd out = MatrixXd::Zero(at(information.size()), at(information.size()));
  for (std::size_t c = 0; c < information.size(); ++c) {
    for (auto i = static_cast<std::size_t>(information.start[c]); i < static_cast<std::size_t>(information.start[c + 1]); ++i) {
      const auto row = at(static_cast<std::size_t>(information.row[i]));
      out(row, at(c)) = out(at(c), row) = information.value[i];
    }
  }
  return out;
}

PartsCovariance covariance_by_parts(const Plan& plan, const PartGroups& groups, PartsData& data, const PartsFit& fit, std::size_t threads) {
  std::vector<Neighbours> pairs = neighbours_of(groups, data);
  for (std::size_t i = 0; i < data.lines() && !pairs.empty(); ++i) LineOfGroups(plan, groups, data, fit, i, threads).add(pairs);
  const Sparse scatter = gradient_covariance(fit.information, pairs, data);
  const std::size_t unknowns = fit.theta.size();
  const InformationSolver solve(fit.information);
  PartsCovariance out;
  if (!solve.is_definite()) return out;
  MatrixXd inverse;
  if (unknowns <= most_of_dense) inverse.resize(at(unknowns), at(unknowns));
  out.variance.resize(at(unknowns));
  for (std::size_t c = 0; c < unknowns; ++c) {
    std::vector<double> unit(unknowns, 0.0);
    unit[c] = 1.0;
    const std::vector<double> column = solve(std::move(unit));
    const Eigen::Map<const VectorXd> x(column.data(), at(unknowns));
    if (inverse.size() > 0) {
      inverse.col(at(c)) = x;
    } else {
      out.variance[at(c)] = x.dot(scatter * x);
    }
  }
  if (inverse.size() == 0) return out;
  const MatrixXd half = scatter * inverse;
  out.whole = inverse * half;
  out.whole = 0.5 * (out.whole + out.whole.transpose()).eval();
  out.variance = out.whole.diagonal();
  return out;
}

}  // namespace jointid::ident
