#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/complex.hpp"
#include "ident/likelihood/parts/part_groups.hpp"

namespace jointid::ident {

/// FRFs of a group at one line, or what belongs to each of them.
template <class Number>
struct GroupFrfs {
  Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> motion;             ///< x of the assembly [motions, references]
  std::vector<Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>> parts;  ///< H of each member [rows, columns]
};

/// A group at one line. `variance` is E|error|², > 0, of the measured values; `current` are corrected ones.
struct GroupLine {
  double omega = 0.0;                 ///< rad/s
  std::size_t line = 0;               ///< of those that are read
  std::vector<std::size_t> columns;   ///< of each unknown of the group: place among the columns of the group
  GroupFrfs<Complex> measured, current;
  GroupFrfs<double> variance;
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> active;  ///< [rows, references]: all of its FRFs are measured

  std::size_t conditions() const { return static_cast<std::size_t>(active.count()); }
};

/// The joint of a group at one line: Z of the rows of its members, and the elements of its derivative by scaled unknowns.
struct GroupImpedance {
  struct Term {
    std::size_t row = 0, column = 0, unknown = 0;
    Complex factor;
  };
  Eigen::MatrixXcd z;  ///< [motions, motions]
  std::vector<Term> terms;
};

GroupImpedance group_impedance(const PartGroup& group, const std::vector<double>& theta, double omega, double omega0);

}  // namespace jointid::ident
