#include "restrictions/joint_impedance.hpp"

#include <algorithm>
#include <utility>

#include "base/eigen.hpp"
#include "base/kernel.hpp"
#include "restrictions/impedance_factor.hpp"

namespace jointid::restrictions {
namespace {

std::vector<ImpedanceTerm> terms_of(const Restriction& restriction, std::size_t unknown) {
  std::vector<ImpedanceTerm> out;
  for (const MatrixTerms& matrix : restriction.matrices) {
    if (matrix.kind != restriction.unknowns[unknown].kind) continue;
    for (const Term& term : matrix.terms) {
      if (term.unknown == unknown) out.push_back({term.row, term.column, term.coefficient});
    }
  }
  return out;
}

bool are_equal(const ImpedanceTerm& a, const ImpedanceTerm& b) {
  return a.row == b.row && a.column == b.column && a.coefficient == b.coefficient;
}

}  // namespace

JointImpedance::JointImpedance(const Restriction& restriction, std::vector<std::size_t> columns,
                               const std::vector<std::size_t>& unknown_of, double omega0, double omega)
    : columns_(std::move(columns)) {
  const auto n = jointid::at(restriction.dofs.size());
  known_ = Eigen::MatrixXcd::Zero(n, n);
  for (const MatrixTerms& matrix : restriction.matrices) {
    for (const Known& known : matrix.known) {
      known_(jointid::at(known.row), jointid::at(known.column)) +=
          impedance_factor(matrix.kind, omega) * known.value;
    }
  }
  std::vector<std::vector<ImpedanceTerm>> shapes;
  std::vector<std::vector<ImpedancePart>> parts;  // of each
  for (std::size_t t = 0; t < columns_.size(); ++t) {
    const std::size_t unknown = unknown_of[t];
    const Kind kind = restriction.unknowns[unknown].kind;
    const auto found = std::ranges::find_if(shapes, [own = terms_of(restriction, unknown)](const auto& shape) {
      return std::ranges::equal(shape, own, are_equal);
    });
    const auto place = static_cast<std::size_t>(found - shapes.begin());
    if (found == shapes.end()) {
      shapes.push_back(terms_of(restriction, unknown));
      parts.emplace_back();
    }
    parts[place].push_back({impedance_factor(kind, omega) * unscale(kind, omega0), t});
  }
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    shapes_.push_back({terms_.size(), terms_.size() + shapes[i].size(), parts_.size(), parts_.size() + parts[i].size()});
    terms_.insert(terms_.end(), shapes[i].begin(), shapes[i].end());
    parts_.insert(parts_.end(), parts[i].begin(), parts[i].end());
  }
}

Eigen::MatrixXcd JointImpedance::at(std::span<const double> theta) const {
  Eigen::MatrixXcd z = known_;
  for (const ImpedanceShape& shape : shapes_) {
    Complex factor = 0.0;
    for (std::size_t i = shape.first_part; i < shape.last_part; ++i) factor += parts_[i].factor * theta[columns_[parts_[i].unknown]];
    for (std::size_t i = shape.first_term; i < shape.last_term; ++i) {
      z(jointid::at(terms_[i].row), jointid::at(terms_[i].column)) += factor * terms_[i].coefficient;
    }
  }
  return z;
}

void JointImpedance::sensitivity(const Complex* left, const Complex* right, Complex* out) const {
  for (const ImpedanceShape& shape : shapes_) {
    Complex sum = 0.0;
    for (std::size_t i = shape.first_term; i < shape.last_term; ++i) {
      sum += product(terms_[i].coefficient * left[terms_[i].row], right[terms_[i].column]);
    }
    for (std::size_t i = shape.first_part; i < shape.last_part; ++i) out[parts_[i].unknown] = product(parts_[i].factor, sum);
  }
}

std::vector<JointImpedance::Place> JointImpedance::places(std::size_t t) const {
  std::vector<Place> out;
  for (const ImpedanceShape& shape : shapes_) {
    for (std::size_t part = shape.first_part; part < shape.last_part; ++part) {
      if (parts_[part].unknown != t) continue;
      for (std::size_t i = shape.first_term; i < shape.last_term; ++i) {
        out.push_back({jointid::at(terms_[i].row), jointid::at(terms_[i].column), parts_[part].factor * terms_[i].coefficient});
      }
    }
  }
  return out;
}

Eigen::VectorXd JointImpedance::along(const Eigen::MatrixXcd& q) const {
  Eigen::VectorXd out(jointid::at(parts_.size()));
  for (const ImpedanceShape& shape : shapes_) {
    Complex sum = 0.0;
    for (std::size_t i = shape.first_term; i < shape.last_term; ++i) {
      sum += terms_[i].coefficient * q(jointid::at(terms_[i].row), jointid::at(terms_[i].column));
    }
    for (std::size_t i = shape.first_part; i < shape.last_part; ++i) {
      out[jointid::at(parts_[i].unknown)] = (std::conj(parts_[i].factor) * sum).real();
    }
  }
  return out;
}

}  // namespace jointid::restrictions
