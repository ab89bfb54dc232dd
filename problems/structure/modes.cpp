#include "problems/structure/modes.hpp"

#include <cmath>
#include <numbers>

#include "base/eigen.hpp"
#include "dense/eigen.hpp"

namespace jointid::problems {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

double factor(double level, double uniform) { return 1.0 + level * (2.0 * uniform - 1.0); }

/// Rows of Φ at the given DOFs, with the sign of the DOF.
Eigen::MatrixXd shapes_at(const Modes& modes, const std::vector<frf::Dof>& dofs) {
  const auto m = at(modes.count());
  const Eigen::Map<const RowMatrixXd> all(modes.shapes.data(), at(modes.dofs.size()), m);
  Eigen::MatrixXd result(at(dofs.size()), m);
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(frf::find_coordinate(modes.dofs, dofs[i]));
    result.row(at(i)) = dofs[i].sign * all.row(row);
  }
  return result;
}

Eigen::VectorXcd amplification(const Modes& modes, double frequency_hz) {
  const double omega = two_pi * frequency_hz;
  Eigen::VectorXcd result(at(modes.count()));
  for (std::size_t r = 0; r < modes.count(); ++r) {
    const double square = std::pow(two_pi * modes.frequency_hz[r], 2);
    result(at(r)) =
        1.0 / Complex(square - omega * omega, modes.loss_factor[r] * square);
  }
  return result;
}

}  // namespace

Modes modes(const Structure& structure) {
  const auto n = at(structure.size());
  const auto real = [&](Kind kind) {
    return Eigen::Map<const RowMatrixXd>(structure.matrix(kind).data(), n, n);
  };
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(real(Kind::stiffness), real(Kind::mass));
  const Eigen::MatrixXd& phi = eigen.vectors;
  const Eigen::VectorXd damping = (phi.transpose() * real(Kind::hysteretic_damping) * phi).diagonal();
  const double smallest = 1e-11 * eigen.values.maxCoeff();
  Modes result{.nodes = structure.nodes(),
               .dofs = structure.dofs(),
               .frequency_hz = {},
               .loss_factor = {},
               .shapes = {}};
  for (Eigen::Index r = 0; r < n; ++r) {
    const double square = eigen.values(r);
    const bool rigid = square < smallest;
    result.frequency_hz.push_back(rigid ? 0.0 : std::sqrt(square) / two_pi);
    result.loss_factor.push_back(rigid ? 0.0 : damping(r) / square);
  }
  result.shapes.resize(structure.size() * structure.size());
  Eigen::Map<RowMatrixXd>(result.shapes.data(), n, n) = phi;
  return result;
}

frf::FrfSet modal_response(const Modes& modes, const ResponseRequest& request) {
  frf::FrfSet set;
  set.header = response_header(modes.nodes, request);
  const Eigen::MatrixXd rows = shapes_at(modes, request.response);
  const Eigen::MatrixXd columns = shapes_at(modes, request.reference);
  for (const double frequency : request.frequency_hz) {
    const Eigen::MatrixXcd h = rows.cast<Complex>() * amplification(modes, frequency).asDiagonal() *
                               columns.transpose().cast<Complex>();
    for (Eigen::Index r = 0; r < h.rows(); ++r) {
      for (Eigen::Index c = 0; c < h.cols(); ++c) set.values.push_back(h(r, c));
    }
  }
  return set;
}

Modes with_consistent_errors(Modes modes, const ConsistentErrors& errors, const RandomStream& stream) {
  for (std::size_t r = 0; r < modes.count(); ++r) {
    const auto u = uniform_numbers(stream, r, 0);
    modes.frequency_hz[r] *= factor(errors.frequency, u[0]);
    modes.loss_factor[r] *= factor(errors.damping, u[1]);
  }
  for (std::size_t i = 0; i < modes.shapes.size(); ++i) {
    modes.shapes[i] *= factor(errors.shape, uniform_numbers(stream, i, 1)[0]);
  }
  return modes;
}

frf::FrfSet with_modal_errors(const frf::FrfSet& clean, const Modes& exact, const ConsistentErrors& errors,
                              const RandomStream& stream) {
  frf::FrfSet result = modal_response(with_consistent_errors(exact, errors, stream),
                                      {.response = clean.header.response,
                                       .reference = clean.header.reference,
                                       .frequency_hz = clean.header.frequency_hz});
  result.header = clean.header;
  return result;
}

}  // namespace jointid::problems
