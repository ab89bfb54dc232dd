#include "stability/exact_responses.hpp"

#include <Eigen/LU>
#include <boost/math/constants/constants.hpp>

#include "base/eigen.hpp"
#include "dense/eigen.hpp"
#include "stability/exact_number.hpp"

namespace jointid::stability {
namespace {

using problems::Kind;

Real<Exact> matrix(const problems::Structure& structure, Kind kind) {
  const auto n = at(structure.size());
  return Eigen::Map<const RowMatrixXd>(structure.matrix(kind).data(), n, n).cast<Exact>();
}

Exact radian_frequency(double frequency_hz) { return 2 * boost::math::constants::pi<Exact>() * Exact(frequency_hz); }

double stored(const Exact& value, Storage storage) {
  return storage == Storage::single_precision ? static_cast<double>(static_cast<float>(value)) : static_cast<double>(value);
}

}  // namespace

frf::FrfSet exact_responses(const problems::Structure& structure, const std::vector<ExactSpring>& springs,
                            const problems::ResponseRequest& request, Storage storage) {
  frf::FrfSet set;
  set.header = problems::response_header(structure.nodes(), request);
  if (storage == Storage::single_precision) set.header.precision = 0x1p-24;
  const auto with_springs = [&](Kind kind) {
    Real<Exact> out = matrix(structure, kind);
    for (const ExactSpring& spring : springs) {
      if (spring.kind != kind) continue;
      const auto i = static_cast<Eigen::Index>(structure.index(spring.first)),
                 j = static_cast<Eigen::Index>(structure.index(spring.second));
      out(i, i) += Exact(spring.value);
      out(j, j) += Exact(spring.value);
      out(i, j) -= Exact(spring.value);
      out(j, i) -= Exact(spring.value);
    }
    return out;
  };
  const Real<Exact> k = with_springs(Kind::stiffness), m = with_springs(Kind::mass), c = with_springs(Kind::viscous_damping),
                    d = with_springs(Kind::hysteretic_damping);
  Pair<Exact> forces(k.rows(), at(request.reference.size()));
  for (std::size_t i = 0; i < request.reference.size(); ++i) {
    forces.re(static_cast<Eigen::Index>(structure.index(request.reference[i])), at(i)) = request.reference[i].sign;
  }
  for (const double frequency : request.frequency_hz) {
    const Exact omega = radian_frequency(frequency);
    const Pair<Exact> motion = solve_exactly({k - Exact(omega * omega) * m, omega * c + d}, forces);
    for (const frf::Dof& dof : request.response) {
      const auto row = static_cast<Eigen::Index>(structure.index(dof));
      for (Eigen::Index column = 0; column < forces.re.cols(); ++column) {
        set.values.emplace_back(dof.sign * stored(motion.re(row, column), storage), dof.sign * stored(motion.im(row, column), storage));
      }
    }
  }
  return set;
}

double exact_natural_frequency(const problems::Structure& structure, std::size_t mode) {
  const Real<Exact> k = matrix(structure, Kind::stiffness), m = matrix(structure, Kind::mass);
  const dense::SymmetricEigen modes = dense::symmetric_eigen(k.cast<double>(), m.cast<double>());
  const auto column = at(mode);
  Real<Exact> x = modes.vectors.col(column).cast<Exact>();
  Exact square = modes.values[column];
  for (int i = 0; i < 3; ++i) {  // Rayleigh quotients converge cubically
    square = (x.transpose() * k * x)(0, 0) / (x.transpose() * m * x)(0, 0);
    x = Real<Exact>(k - Exact(square * (1 + Exact("1e-40"))) * m).partialPivLu().solve(Real<Exact>(m * x));
    x /= x.cwiseAbs().maxCoeff();
  }
  return static_cast<double>(Exact(sqrt(square) / (2 * boost::math::constants::pi<Exact>())));
}

}  // namespace jointid::stability
