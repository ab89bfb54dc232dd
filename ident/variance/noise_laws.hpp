#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// E|e|² of the errors e of each receptance H of a file, proportional·|H|² + constant·|c|² with |c|² the squared_factor() of the
/// line.
struct NoiseLaws {
  Eigen::MatrixXd proportional, constant;  ///< [R,C]; NaN where nothing is known

  double operator()(Eigen::Index response, Eigen::Index reference, double square, double factor) const {
    return proportional(response, reference) * square + constant(response, reference) * factor;
  }
};

/// A squared error, the |H|² and |c|² of its line.
struct NoiseSample {
  double error_square, square, factor;
};

/// E|e|² = first·|H|² + second·|c|² of samples whose scatter is in proportion to their expectation (quasi-likelihood of a Gamma
/// law, iterated least squares), both ≥ 0; NaN of fewer than 3 samples. Without dropouts, errors 300 times above
/// what the medians of error over square and of error over factor make together.
std::pair<double, double> fit_noise_law(const std::vector<NoiseSample>& samples);

/// By variances or coherences of the file at up to 32 of the lines, where the scene takes its variances from there. `values`:
/// [line,R,C], the receptances. Null where the file knows nothing.
std::shared_ptr<const NoiseLaws> recorded_laws(frf::FrfSource& source, const std::vector<std::size_t>& source_lines,
                                               std::span<const Complex> values, const Scene& scene);

/// E|e|² [line,R,C] by the variances of the file at all of the lines, where the scene takes them from there and they are no more
/// than a million; else empty. Coherences and repeats are left to laws: what disturbs a line is in them, too.
std::vector<double> recorded_squares(frf::FrfSource& source, const std::vector<std::size_t>& source_lines,
                                     std::span<const Complex> values, const Scene& scene);

/// `count` or fewer of 0 … size−1, evenly spread, the first and the last among them.
std::vector<std::size_t> spread_lines(std::size_t size, std::size_t count);

}  // namespace jointid::ident
