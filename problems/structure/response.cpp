#include "problems/structure/response.hpp"

#include <algorithm>
#include <complex>
#include <numbers>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "dense/lu.hpp"

namespace jointid::problems {
namespace {

struct Place {
  Eigen::Index index;
  double sign;
};

std::vector<Place> places(const Structure& structure, const std::vector<frf::Dof>& dofs) {
  std::vector<Place> result;
  for (const frf::Dof& dof : dofs) {
    const std::size_t index = structure.index(dof);
    result.push_back(
        {at(index), static_cast<double>(dof.sign * structure.dofs()[index].sign)});
  }
  return result;
}

using Extended = std::complex<long double>;
using ExtendedMatrix = Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>;

Extended laplace(double window_rate, double frequency_hz) {
  return {window_rate, 2.0L * std::numbers::pi_v<long double> * frequency_hz};
}

ExtendedMatrix dynamic_stiffness(const Structure& structure, Extended s) {
  const auto n = at(structure.size());
  const auto real = [&](Kind kind) {
    return Eigen::Map<const RowMatrixXd>(structure.matrix(kind).data(), n, n).cast<Extended>();
  };
  return real(Kind::stiffness) + s * s * real(Kind::mass) + s * real(Kind::viscous_damping) +
         Extended(0.0L, 1.0L) * real(Kind::hysteretic_damping);
}

/// Solves Z x = f to the last bit of double precision: LU in double, and one step of refinement with the residual in long
/// double. Noise-free FRFs are the reference that methods are held against, the ill-conditioned direct solution too.
Eigen::MatrixXcd solve_refined(const ExtendedMatrix& z, const Eigen::MatrixXcd& forces) {
  const dense::ComplexLu lu(z.cast<Complex>());
  const Eigen::MatrixXcd first = lu.solve(forces);
  const ExtendedMatrix residual = forces.cast<Extended>() - z.lazyProduct(first.cast<Extended>());
  const Eigen::MatrixXcd correction = lu.solve(residual.cast<Complex>());
  return (first.cast<Extended>() + correction.cast<Extended>()).cast<Complex>();
}

}  // namespace

frf::FrfHeader response_header(const std::vector<frf::Node>& nodes, const ResponseRequest& request) {
  frf::FrfHeader header;
  header.frequency_hz = request.frequency_hz;
  header.response = request.response;
  header.reference = request.reference;
  for (const frf::Node& node : nodes) {
    const auto at_node = [&](const frf::Dof& dof) { return dof.node == node.id; };
    if (std::any_of(request.response.begin(), request.response.end(), at_node) ||
        std::any_of(request.reference.begin(), request.reference.end(), at_node)) {
      header.nodes.push_back(node);
    }
  }
  frf::validate(header);
  return header;
}

frf::FrfSet frequency_response(const Structure& structure, const ResponseRequest& request) {
  frf::FrfSet set;
  set.header = response_header(structure.nodes(), request);
  set.values.reserve(set.header.lines() * set.header.entries());
  const std::vector<Place> rows = places(structure, request.response);
  const std::vector<Place> columns = places(structure, request.reference);
  const auto n = at(structure.size());
  Eigen::MatrixXcd forces = Eigen::MatrixXcd::Zero(n, at(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    forces(columns[c].index, at(c)) = columns[c].sign;
  }
  for (const double frequency : request.frequency_hz) {
    const ExtendedMatrix z = dynamic_stiffness(structure, laplace(request.window_rate, frequency));
    const Eigen::MatrixXcd motion = solve_refined(z, forces);
    for (const Place& row : rows) {
      for (Eigen::Index c = 0; c < forces.cols(); ++c) set.values.push_back(row.sign * motion(row.index, c));
    }
  }
  return set;
}

frf::FrfSet with_accelerometer(const frf::FrfSet& set, double mass, double window_rate) {
  frf::FrfSet result = set;
  for (std::size_t r = 0; r < set.header.response.size(); ++r) {
    const frf::Dof& dof = set.header.response[r];
    const std::size_t point = frf::find_coordinate(set.header.reference, dof);
    if (point == frf::npos) {
      throw InputError({.kind = ErrorKind::usage,
                        .file = set.header.file,
                        .place = "accelerometer mass",
                        .problem = "there is no point FRF at " + dof.name(),
                        .remedy = "compute the set with that reference"});
    }
    const double sign = dof.sign * set.header.reference[point].sign;
    for (std::size_t line = 0; line < set.header.lines(); ++line) {
      const Complex s(laplace(window_rate, set.header.frequency_hz[line]));
      const Complex loaded = 1.0 + s * s * mass * sign * set.values[set.index(line, r, point)];
      for (std::size_t c = 0; c < set.header.reference.size(); ++c)
        result.values[set.index(line, r, c)] /= loaded;
    }
  }
  return result;
}

}  // namespace jointid::problems
