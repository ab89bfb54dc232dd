#include "oscillation/measurement/strain.hpp"

#include <string>

#include "base/error.hpp"
#include "base/text.hpp"
#include "dense/svd.hpp"

namespace jointid::oscillation {
namespace {

InputError wrong_gauges(const std::string& place, const std::string& problem, const std::string& remedy) {
  return InputError({ErrorKind::usage, "", place, problem, remedy});
}

void check(const GaugedBeam& beam, const std::vector<Shape>& basis, const std::vector<double>& points) {
  if (!(beam.length > 0.0)) throw wrong_gauges("length", digits(beam.length) + " m is not above 0", "");
  if (!(beam.thickness > 0.0)) throw wrong_gauges("thickness", digits(beam.thickness) + " m is not above 0", "");
  if (beam.gauges.size() < basis.size() || basis.empty()) {
    throw wrong_gauges("gauges", std::to_string(beam.gauges.size()) + " cannot determine " + std::to_string(basis.size()) + " shapes",
                       "take at most as many shapes as gauges");
  }
  for (const auto* places : {&beam.gauges, &points}) {
    for (const double x : *places) {
      if (!(x >= 0.0 && x <= beam.length))
        throw wrong_gauges("place", digits(x, "%.4g") + " m is not on the beam", "count from the clamp");
    }
  }
}

}  // namespace

StrainMap strain_map(const GaugedBeam& beam, const std::vector<Shape>& basis, const std::vector<double>& points) {
  check(beam, basis, points);
  Eigen::MatrixXd psi(at(beam.gauges.size()), at(basis.size())), phi(at(points.size()), at(basis.size()));
  for (std::size_t k = 0; k < basis.size(); ++k) {
    for (std::size_t g = 0; g < beam.gauges.size(); ++g)
      psi(at(g), at(k)) = deflection(basis[k], beam.length, beam.gauges[g]).curvature;
    for (std::size_t p = 0; p < points.size(); ++p) phi(at(p), at(k)) = deflection(basis[k], beam.length, points[p]).value;
    const double size = psi.col(at(k)).norm();  // shapes have different units
    if (size > 0.0) psi.col(at(k)) /= size, phi.col(at(k)) /= size;
  }
  const dense::RealSvd svd = dense::jacobi_svd(psi, dense::Vectors::thin, dense::Vectors::thin);
  const double smallest = svd.sigma(svd.sigma.size() - 1);
  if (!(smallest > 1e-12 * svd.sigma(0)))
    throw wrong_gauges("gauges", "see no difference between the shapes", "place them apart, or take fewer shapes");
  StrainMap out;
  out.condition = svd.sigma(0) / smallest;
  out.matrix = phi * svd.v * svd.sigma.cwiseInverse().asDiagonal() * svd.u.transpose() / (0.5 * beam.thickness);
  out.noise = out.matrix.rowwise().norm();
  return out;
}

}  // namespace jointid::oscillation
