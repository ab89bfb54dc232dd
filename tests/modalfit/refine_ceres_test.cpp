#include <ceres/ceres.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/complex.hpp"
#include "modalfit/band/basis.hpp"
#include "modalfit/model/fit.hpp"
#include "problems/case/modal_set.hpp"

namespace jointid::modalfit {
namespace {

constexpr std::size_t modes = 2;

/// One FRF of the model H = Σ A_r/(ω_r² − ω² + iη_rω_r²) − L/ω² + U written out, ω in units of the highest line, differentiated by Ceres.
struct EntryResidual {
  const Band& band;
  std::size_t entry;

  template <class T>
  bool operator()(const T* poles, const T* c, T* residual) const {
    for (std::size_t i = 0; i < band.lines(); ++i) {
      const double x2 = std::pow(band.frequency_hz[i] / band.scale_hz(), 2.0);
      T real = c[modes + 2] - c[modes] / x2, imag = c[modes + 3] - c[modes + 1] / x2;
      for (std::size_t r = 0; r < modes; ++r) {
        const T w2 = exp(2.0 * poles[2 * r]), re = w2 - x2, im = poles[2 * r + 1] * w2, square = re * re + im * im;
        real += c[r] * re / square;
        imag -= c[r] * im / square;
      }
      residual[2 * i] = (real - band.value(entry)[i].real()) * band.weights(entry)[2 * i];
      residual[2 * i + 1] = (imag - band.value(entry)[i].imag()) * band.weights(entry)[2 * i + 1];
    }
    return true;
  }
};

TEST(Refine, AgreesWithCeresOnAllUnknownsAtOnce) {
  const auto set = problems::make_modal_set("modes-pair");
  const frf::FrfSet noisy = problems::polluted(set, 5, 0);
  Band band = make_band(noisy, std::array{97.0, 104.0});
  const ModalFit own = fit(band, noisy.header, {.kind = {Damping::hysteretic, true}});
  ASSERT_EQ(own.modes.size(), modes);

  std::vector<double> poles = {std::log(100.003 / band.scale_hz()), 0.0021, std::log(100.997 / band.scale_hz()), 0.0019};
  std::vector<std::vector<double>> coefficients;
  ceres::Problem problem;
  for (std::size_t e = 0; e < band.entries(); ++e) {
    const double* c = own.residues.coefficients.data() + e * own.residues.columns;
    coefficients.emplace_back(c, c + own.residues.columns);
    for (double& value : coefficients.back()) value *= 1.1;
  }
  for (std::size_t e = 0; e < band.entries(); ++e) {
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<EntryResidual, ceres::DYNAMIC, 2 * modes, modes + 4>(
                                 new EntryResidual{band, e}, static_cast<int>(2 * band.lines())),
                             nullptr, poles.data(), coefficients[e].data());
  }
  ceres::Solver::Options options;
  options.max_num_iterations = 200;
  options.function_tolerance = options.parameter_tolerance = options.gradient_tolerance = 1e-15;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  EXPECT_NEAR(own.cost / (2.0 * summary.final_cost), 1.0, 1e-8);
  for (std::size_t r = 0; r < modes; ++r) {
    const double frequency = band.scale_hz() * std::exp(poles[2 * r]);
    EXPECT_NEAR(own.modes[r].pole.frequency_hz, frequency, 0.01 * own.modes[r].frequency_deviation_hz);
    EXPECT_NEAR(own.modes[r].pole.damping, poles[2 * r + 1], 0.01 * own.modes[r].damping_deviation);
  }
}

}  // namespace
}  // namespace jointid::modalfit
