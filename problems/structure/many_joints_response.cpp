#include <Eigen/SparseLU>
#include <complex>
#include <map>
#include <numbers>

#include "base/eigen.hpp"
#include "problems/structure/many_joints.hpp"
#include "problems/structure/response.hpp"

namespace jointid::problems {
namespace {

using Extended = std::complex<long double>;

/// A number of a matrix of the assembly, without frequency.
struct Element {
  Eigen::Index row, column;
  Kind kind;
  double value;
};

/// Place of every coordinate: part after part.
std::map<std::int64_t, Eigen::Index> places_of(const ManyJoints& structure) {
  std::map<std::int64_t, Eigen::Index> places;
  for (const Structure& part : structure.parts) {
    for (const frf::Dof& dof : part.dofs()) places.emplace(frf::coordinate_key(dof), at(places.size()));
  }
  return places;
}

void add(const Matrix& matrix, Kind kind, const std::vector<Eigen::Index>& where, std::vector<Element>& out) {
  for (std::size_t i = 0; i < where.size(); ++i) {
    for (std::size_t j = 0; j < where.size(); ++j) out.push_back({where[i], where[j], kind, matrix[i][j]});
  }
}

std::vector<Element> elements_of(const ManyJoints& structure, const std::map<std::int64_t, Eigen::Index>& places) {
  std::vector<Element> out;
  Eigen::Index first = 0;
  for (const Structure& part : structure.parts) {
    const std::size_t n = part.size();
    for (const Kind kind : restrictions::all_kinds) {
      const std::vector<double>& matrix = part.matrix(kind);
      for (std::size_t k = 0; k < matrix.size(); ++k) {
        if (matrix[k] != 0.0) out.push_back({first + at(k / n), first + at(k % n), kind, matrix[k]});
      }
    }
    first += at(n);
  }
  for (const BeamJoint& joint : structure.joints) {
    std::vector<Eigen::Index> where;
    for (const frf::Dof& dof : joint.dofs) where.push_back(places.at(frf::coordinate_key(dof)));
    add(joint.over_dofs(joint.relative_stiffness), Kind::stiffness, where, out);
    add(joint.over_dofs(joint.relative_damping), Kind::hysteretic_damping, where, out);
  }
  return out;
}

Extended factor(Kind kind, long double omega) {
  switch (kind) {
    case Kind::mass:
      return -omega * omega;
    case Kind::viscous_damping:
      return {0.0L, omega};
    case Kind::hysteretic_damping:
      return {0.0L, 1.0L};
    case Kind::stiffness:
      break;
  }
  return 1.0L;
}

/// x of Z x = forces.
Eigen::MatrixXcd solved(const std::vector<Element>& elements, double frequency_hz, const Eigen::MatrixXcd& forces) {
  const long double omega = 2.0L * std::numbers::pi_v<long double> * static_cast<long double>(frequency_hz);
  const Eigen::Index n = forces.rows();
  std::vector<Eigen::Triplet<Complex>> entries;
  entries.reserve(elements.size());
  for (const Element& e : elements) {
    entries.emplace_back(e.row, e.column, Complex(factor(e.kind, omega) * static_cast<long double>(e.value)));
  }
  Eigen::SparseMatrix<Complex> z(n, n);
  z.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<Complex>> lu;
  lu.compute(z);
  Eigen::MatrixXcd x = lu.solve(forces);
  Eigen::Matrix<Extended, Eigen::Dynamic, 1> residual(n);
  for (Eigen::Index c = 0; c < forces.cols(); ++c) {
    residual = forces.col(c).cast<Extended>();
    for (const Element& e : elements)
      residual[e.row] -= factor(e.kind, omega) * static_cast<long double>(e.value) * Extended(x(e.column, c));
    x.col(c) += lu.solve(Eigen::VectorXcd(residual.cast<Complex>()));
  }
  return x;
}

}  // namespace

frf::FrfSet part_receptances(const ManyJoints& structure, std::size_t part) {
  const Structure& own = structure.parts[part];
  std::vector<frf::Dof> references;
  for (const BeamJoint& joint : structure.joints) {
    for (const frf::Dof& dof : joint.dofs) {
      if (frf::has(own.dofs(), dof) && !frf::has(references, dof)) references.push_back(dof);
    }
  }
  for (const frf::Dof& dof : structure.references) {
    if (frf::has(own.dofs(), dof) && !frf::has(references, dof)) references.push_back(dof);
  }
  return frequency_response(own, {.response = own.dofs(), .reference = references, .frequency_hz = structure.frequency_hz});
}

frf::FrfSet assembly_receptances(const ManyJoints& structure) {
  std::vector<frf::Node> nodes;
  ResponseRequest request{.response = {}, .reference = structure.references, .frequency_hz = structure.frequency_hz};
  for (const Structure& part : structure.parts) {
    nodes.insert(nodes.end(), part.nodes().begin(), part.nodes().end());
    request.response.insert(request.response.end(), part.dofs().begin(), part.dofs().end());
  }
  const auto places = places_of(structure);
  const std::vector<Element> elements = elements_of(structure, places);
  Eigen::MatrixXcd forces = Eigen::MatrixXcd::Zero(at(request.response.size()), at(request.reference.size()));
  for (std::size_t c = 0; c < request.reference.size(); ++c) forces(places.at(frf::coordinate_key(request.reference[c])), at(c)) = 1.0;
  frf::FrfSet set;
  set.header = response_header(nodes, request);
  for (const double frequency : request.frequency_hz) {
    const RowMatrixXc motion = solved(elements, frequency, forces);
    set.values.insert(set.values.end(), motion.data(), motion.data() + motion.size());
  }
  return set;
}

}  // namespace jointid::problems
