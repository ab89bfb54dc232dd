#include "ident/likelihood/parts/whole_information.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "ident/likelihood/parts/group_conditions.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<Complex>;
using Entries = std::vector<Eigen::Triplet<Complex>>;

/// Conditions of one line that are there, under all references, and their covariance.
class WholeLine {
 public:
  WholeLine(const PartGroup& group, const PartGroups& all, const GroupLine& line, const GroupImpedance& impedance)
      : group_(group), line_(line), conditions_(group, all.references.size(), line, impedance) {
    for (Index l = 0; l < line.active.cols(); ++l) {
      for (Index m = 0; m < line.active.rows(); ++m) {
        if (line.active(m, l)) rows_.push_back({m, l});
      }
    }
    Entries entries = by_errors_of_motion();
    add_errors_of_parts(entries);
    Sparse covariance(at(rows_.size()), at(rows_.size()));
    covariance.setFromTriplets(entries.begin(), entries.end());
    scale_ = covariance.diagonal().real().cwiseSqrt().cwiseInverse();
    covariance = scale_.asDiagonal() * covariance * scale_.asDiagonal();
    factors_.compute(covariance);
  }

  bool is_definite() const { return factors_.info() == Eigen::Success; }

  double cost() const {
    const Eigen::VectorXcd w = misfit();
    return w.dot(solved(w)).real();
  }

  MatrixXd information() const {
    constexpr Index most = 64;  // columns at once
    const Sparse a = derivative();
    MatrixXd out(a.cols(), a.cols());
    for (Index first = 0; first < a.cols(); first += most) {
      const Index width = std::min(most, a.cols() - first);
      out.middleCols(first, width) = 2.0 * (a.adjoint() * solved(MatrixXcd(a.middleCols(first, width)))).real();
    }
    return 0.5 * (out + out.transpose());
  }

  /// The FRFs nearest to the measured ones that meet the linearised conditions.
  GroupFrfs<Complex> corrected() const {
    const Eigen::VectorXcd pull = solved(misfit());
    MatrixXcd of_rows = MatrixXcd::Zero(line_.active.rows(), line_.active.cols());
    for (std::size_t k = 0; k < rows_.size(); ++k) of_rows(rows_[k].first, rows_[k].second) = pull[at(k)];
    GroupFrfs<Complex> out = line_.measured;
    out.motion -= line_.variance.motion.cwiseProduct(conditions_.by_motion().adjoint() * of_rows);
    for (std::size_t s = 0; s < group_.members.size(); ++s) {
      const GroupMember& member = group_.members[s];
      const auto own = of_rows.middleRows(at(member.first_row), at(member.rows.size()));
      out.parts[s] -= line_.variance.parts[s].cwiseProduct(own * conditions_.by_frf()[s].adjoint());
    }
    return out;
  }

 private:
  using Row = std::pair<Index, Index>;  ///< row of the group, reference

  /// Of a row under a reference among those that are there, or −1.
  Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic> places() const {
    Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic> out(line_.active.rows(), line_.active.cols());
    out.setConstant(-1);
    for (std::size_t k = 0; k < rows_.size(); ++k) out(rows_[k].first, rows_[k].second) = at(k);
    return out;
  }

  /// Lower triangle of G Q_l Gᴴ for each reference l.
  Entries by_errors_of_motion() const {
    Entries out;
    const auto place = places();
    const Sparse g = conditions_.by_motion().sparseView();
    for (Index l = 0; l < place.cols(); ++l) {
      const Sparse product = g * line_.variance.motion.col(l).asDiagonal() * Sparse(g.adjoint());
      for (Index column = 0; column < product.outerSize(); ++column) {
        for (Sparse::InnerIterator it(product, column); it; ++it) {
          const Index row = place(it.row(), l), other = place(column, l);
          if (row >= other && other >= 0) out.emplace_back(static_cast<int>(row), static_cast<int>(other), it.value());
        }
      }
    }
    return out;
  }

  /// Those of H(m,p) are in the conditions of m under all references.
  void add_errors_of_parts(Entries& to) const {
    const auto place = places();
    for (std::size_t s = 0; s < group_.members.size(); ++s) {
      const MatrixXcd& by_frf = conditions_.by_frf()[s];
      for (std::size_t m = 0; m < group_.members[s].rows.size(); ++m) {
        const MatrixXcd shared = by_frf.transpose() * line_.variance.parts[s].row(at(m)).transpose().asDiagonal() * by_frf.conjugate();
        const auto own = place.row(at(group_.members[s].first_row + m));
        for (Index l = 0; l < own.size(); ++l) {
          for (Index t = 0; t < own.size(); ++t) {
            if (own[l] >= own[t] && own[t] >= 0) to.emplace_back(static_cast<int>(own[l]), static_cast<int>(own[t]), shared(l, t));
          }
        }
      }
    }
  }

  Sparse derivative() const {
    Entries entries;
    const auto place = places();
    for (Index l = 0; l < place.cols(); ++l) {
      const MatrixXcd a = conditions_.by_unknown(static_cast<std::size_t>(l));
      for (Index c = 0; c < a.cols(); ++c) {
        for (Index m = 0; m < a.rows(); ++m) {
          if (place(m, l) >= 0 && a(m, c) != Complex(0.0))
            entries.emplace_back(static_cast<int>(place(m, l)), static_cast<int>(c), a(m, c));
        }
      }
    }
    Sparse out(at(rows_.size()), at(group_.unknowns.size()));
    out.setFromTriplets(entries.begin(), entries.end());
    return out;
  }

  Eigen::VectorXcd misfit() const {
    const MatrixXcd all = conditions_.misfit();
    Eigen::VectorXcd out(at(rows_.size()));
    for (std::size_t k = 0; k < rows_.size(); ++k) out[at(k)] = all(rows_[k].first, rows_[k].second);
    return out;
  }

  template <class Right>
  Right solved(const Right& right) const {
    return scale_.asDiagonal() * factors_.solve(Right(scale_.asDiagonal() * right));
  }

  const PartGroup& group_;
  const GroupLine& line_;
  GroupConditions conditions_;
  std::vector<Row> rows_;
  VectorXd scale_;
  Eigen::SimplicialLLT<Sparse, Eigen::Lower> factors_;
};

}  // namespace

MatrixXd whole_information(const PartGroup& group, const PartGroups& all, GroupLine line, const GroupImpedance& impedance) {
  constexpr int most = 30;
  constexpr double same = 1e-10, rounding = 1e-12;
  double before = 0.0;
  for (int i = 0;; ++i) {
    const WholeLine now(group, all, line, impedance);
    if (!now.is_definite()) return MatrixXd::Zero(at(group.unknowns.size()), at(group.unknowns.size()));
    const double cost = now.cost();
    const bool stays = i > 0 && std::abs(cost - before) <= same * before;
    if (stays || i == most || cost <= rounding * static_cast<double>(line.conditions())) return now.information();
    before = cost;
    line.current = now.corrected();
  }
}

}  // namespace jointid::ident
