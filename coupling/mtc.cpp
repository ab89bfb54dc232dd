#include "base/eigen.hpp"
#include "coupling/methods.hpp"
#include "coupling/mtc_steps.hpp"

namespace jointid::coupling {

double alpha(Complex ii, Complex jj, Complex ij) {
  const double size = std::abs(ii) + std::abs(jj) + std::abs(ij);
  return size == 0.0 ? 0.0 : (std::abs(ii - jj) + std::abs(ii - ij) + std::abs(ij - jj)) / size;
}

MtcResult mtc(const MatrixRef& h, const Conditions& conditions, const Wanted& wanted, double epsilon) {
  MtcSteps<Complex> steps(h, at(conditions.size()));
  MtcResult out;
  for (const Condition& condition : conditions) {
    const auto now = steps.receptances(condition);
    out.alpha.push_back(alpha(now.ii, now.jj, 0.5 * (now.ij + now.ji)));
    out.coupled.push_back(!(out.alpha.back() <= epsilon));
    if (out.coupled.back()) steps.couple(condition);
  }
  out.frf = steps.frf(wanted);
  return out;
}

}  // namespace jointid::coupling
