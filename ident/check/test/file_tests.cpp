#include "ident/check/test/file_tests.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numbers>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "ident/check/test/delay_fit.hpp"
#include "ident/check/test/slope_fit.hpp"

namespace jointid::ident {
namespace {

constexpr double least_difference = 0.004;  ///< below it, relative differences of H_ij and H_ji count as that
constexpr double negligible = 1e-12;        ///< of |H_ii H_jj|: FRFs that are zero by symmetry say nothing

struct BothRoles {
  Dofs dofs;
  std::vector<Eigen::Index> row, column;
};

BothRoles both_roles(const CheckedFile& file) {
  BothRoles both;
  for (std::size_t r = 0; r < file.responses.size(); ++r) {
    const std::size_t c = place_of(file.references, file.responses[r]);
    if (c == frf::npos) continue;
    both.dofs.push_back(file.responses[r]);
    both.row.push_back(at(r));
    both.column.push_back(at(c));
  }
  return both;
}

/// One pair over the lines.
struct Pair {
  double log_square = 0.0;
  std::size_t lines = 0;
  std::vector<double> log_ratio;

  void add(std::complex<double> a, std::complex<double> b, double point, bool with_ratio) {
    const double size = std::norm(a) + std::norm(b);
    if (!(std::isfinite(size) && size > negligible * point)) return;
    log_square += std::log(std::norm(a - b) / size + least_difference * least_difference);
    ++lines;
    if (with_ratio && a != 0.0 && b != 0.0) log_ratio.push_back(0.5 * std::log(std::norm(a) / std::norm(b)));
  }
};

/// Σ over pairs of one line for the mass that travels with the sensor.
struct MassSums {
  SlopeFit fit;

  void add_line(const Eigen::MatrixXcd& h, const Dofs& dofs, double omega) {
    const auto loaded = [&](Eigen::Index k) { return dofs[static_cast<std::size_t>(k)].is_rotation() ? 0.0 : 1.0; };
    double line_slope = 0.0, line_square = 0.0;
    for (Eigen::Index i = 0; i < h.rows(); ++i) {
      for (Eigen::Index j = i + 1; j < h.rows(); ++j) {
        const double size = std::norm(h(i, j)) + std::norm(h(j, i));
        const std::complex<double> x = -omega * omega * (loaded(j) * h(i, j) * h(j, j) - loaded(i) * h(j, i) * h(i, i));
        const std::complex<double> y = h(i, j) - h(j, i);
        if (!(size > 0.0 && std::isfinite(std::norm(x)) && std::isfinite(std::norm(y)))) continue;
        line_slope += (std::conj(x) * y).real() / size;
        line_square += std::norm(x) / size;
      }
    }
    fit.add(line_slope, line_square);
  }

  void finish(ReciprocityTest& out) const {
    if (!fit.is_told()) return;
    out.mass = fit.value();
    out.mass_deviation = fit.scatter() / fit.square();
    out.mass_freedom = fit.freedom();
  }
};

/// a_i − a_j = median over the lines of log|H_ij/H_ji|; a_i by the median over j, which one wrong channel does not move.
/// `shared`: variance of what all pairs of a coordinate have in common, on one line.
void find_gains(const std::vector<std::vector<Pair>>& pairs, double shared, ReciprocityTest& out) {
  const std::size_t n = pairs.size();
  std::vector<double> a(n), error(n), freedom(n);
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> middles, errors;
    std::size_t lines = 1;
    for (std::size_t j = 0; j < n; ++j) {
      if (i == j) continue;
      const std::vector<double>& ratios = i < j ? pairs[i][j].log_ratio : pairs[j][i].log_ratio;
      if (ratios.size() < 3) continue;
      const double middle = median(ratios);
      lines = std::max(lines, ratios.size());
      std::vector<double> off;
      for (const double ratio : ratios) off.push_back(std::abs(ratio - middle));
      middles.push_back(i < j ? middle : -middle);
      errors.push_back(std::max(1.86 * median(off) / std::sqrt(static_cast<double>(ratios.size())), 1e-4));
    }
    a[i] = middles.empty() ? 0.0 : median(middles);
    std::vector<double> off;
    for (const double middle : middles) off.push_back(std::abs(middle - a[i]));
    const double spread = middles.empty() ? 1.0 : std::hypot(median(errors), 1.48 * median(off));
    error[i] = 1.25 * spread / std::sqrt(std::max(static_cast<double>(middles.size()), 1.0));
    error[i] = std::hypot(error[i], 1.25 * std::sqrt(shared / static_cast<double>(lines)));
    freedom[i] = freedom_of_median(static_cast<double>(lines)) * static_cast<double>(middles.size());
  }
  const double common = median(a);
  for (std::size_t i = 0; i < n; ++i) {
    out.gain.push_back(std::exp(common - a[i]));
    out.deviation.push_back(error[i]);
    out.freedom.push_back(freedom[i]);
  }
}

/// Half of the mean of E[e_r e_s*]/(H_r H_s*), r ≠ s, of the FRFs to one reference: what the noise of its blows gives the logarithms of
/// all of them.
double shared_by_responses(const CheckedFile& file, const BothRoles& both) {
  if (!file.errors) return 0.0;
  const auto n = static_cast<double>(both.row.size());
  const Eigen::MatrixXcd all = file.errors->proportional(both.row, both.row);
  return std::max(0.0, 0.5 * (all.sum() - all.trace()).real() / (n * (n - 1.0)));
}

}  // namespace

bool may_be_chance(double deviations, double freedom, double tried) {
  constexpr double by_chance = 1e-3;
  if (!(freedom >= 1.0)) return true;
  if (!std::isfinite(deviations)) return std::isnan(deviations);
  const boost::math::students_t_distribution<double> law(freedom);
  return !(tried * 2.0 * boost::math::cdf(boost::math::complement(law, std::abs(deviations))) < by_chance);
}

double relative_error(const CheckedFile& file) {
  double logs = 0.0;
  std::size_t lines = 0;
  for (std::size_t l = 0; l < file.frfs.size(); ++l) {
    double sum = 0.0;
    std::size_t count = 0;
    for (Eigen::Index c = 0; c < file.frfs[l].cols(); ++c) {
      for (Eigen::Index r = 0; r < file.frfs[l].rows(); ++r) {
        const double size = std::norm(file.frfs[l](r, c));
        if (!(std::isfinite(size) && size > 0.0)) continue;
        sum += std::min(1.0, file.variance(l, r, c) / size);
        ++count;
      }
    }
    if (!(sum > 0.0)) continue;
    logs += std::log(sum / static_cast<double>(count));
    ++lines;
  }
  return lines > 0 ? std::exp(0.5 * logs / static_cast<double>(lines)) : 0.0;
}

ReciprocityTest reciprocity_test(const CheckedFile& file, bool with_rows) {
  ReciprocityTest out;
  const BothRoles both = both_roles(file);
  const std::size_t n = both.dofs.size();
  if (n < 2) return out;
  out.dofs = both.dofs;
  std::vector<std::vector<Pair>> pairs(n, std::vector<Pair>(n));
  MassSums mass;
  for (std::size_t l = 0; l < file.frfs.size(); ++l) {
    const Eigen::MatrixXcd h = file.frfs[l](both.row, both.column);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        const auto r = at(i), c = at(j);
        pairs[i][j].add(h(r, c), h(c, r), std::abs(h(r, r) * h(c, c)), with_rows);
      }
    }
    if (with_rows) mass.add_line(h, both.dofs, angular(file.frequency_hz[l]));
  }
  double logs = 0.0;
  std::size_t count = 0;
  out.row.assign(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (pairs[i][j].lines == 0) continue;
      const double mean = pairs[i][j].log_square / static_cast<double>(pairs[i][j].lines);
      logs += mean;
      ++count;
      out.row[i] += std::exp(mean) / static_cast<double>(n - 1);
      out.row[j] += std::exp(mean) / static_cast<double>(n - 1);
    }
  }
  out.level = count > 0 ? std::exp(0.5 * logs / static_cast<double>(count)) : 0.0;
  if (with_rows) {
    find_gains(pairs, shared_by_responses(file, both), out);
    mass.finish(out);
  }
  return out;
}

PassivityTest passivity_test(const CheckedFile& file, double noise) {
  PassivityTest out;
  const BothRoles both = both_roles(file);
  double all = 0.0, all_square = 0.0;
  for (std::size_t k = 0; k < both.dofs.size(); ++k) {
    double sum = 0.0, square = 0.0;
    for (std::size_t l = 0; l < file.frfs.size(); ++l) {
      const double weight = std::pow(file.frequency_hz[l], 2);
      const std::complex<double> h = file.frfs[l](both.row[k], both.column[k]) * weight;
      if (!std::isfinite(std::norm(h))) continue;
      sum += h.imag();
      square += file.errors ? file.variance(l, both.row[k], both.column[k]) * weight * weight : noise * noise * std::norm(h);
    }
    const double scale = std::sqrt(0.5 * square);
    if (!(scale > 0.0)) continue;
    out.dofs.push_back(both.dofs[k]);
    out.excess.push_back(sum / scale);
    all += sum / scale;
    all_square += 1.0;
  }
  out.total = all_square > 0.0 ? all / std::sqrt(all_square) : 0.0;
  return out;
}

PhaseTest phase_test(const CheckedFile& file, bool with_delay) {
  PhaseTest out;
  std::vector<PhaseSample> samples;
  double real = 0.0, size = 0.0;
  for (std::size_t l = 0; l < file.frfs.size(); ++l) {
    std::complex<double> sum = 0.0;
    std::size_t count = 0;
    for (const std::complex<double>& h : file.frfs[l].reshaped()) {
      const double square = std::norm(h);
      if (!(std::isfinite(square) && square > 0.0)) continue;
      sum += h * h / square;
      ++count;
    }
    if (count == 0) continue;
    sum /= static_cast<double>(count);
    samples.push_back({4.0 * std::numbers::pi * file.frequency_hz[l], sum});
    real += sum.real();
    size += std::abs(sum);
  }
  if (samples.empty()) return out;
  out.real_share = real / static_cast<double>(samples.size());
  out.coherence = size / static_cast<double>(samples.size());
  if (with_delay) {
    const DelayFit fit = fit_delay(samples);
    out.delay = fit.delay;
    out.delay_deviation = fit.deviation;
  }
  return out;
}

}  // namespace jointid::ident
