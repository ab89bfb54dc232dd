#include "ident/check/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "dense/minimum_norm.hpp"
#include "frf/noise/variance_law.hpp"
#include "ident/check/test/file_tests.hpp"
#include "ident/check/test/slope_fit.hpp"
#include "ident/variance/noise_fit.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;

constexpr double beyond_recorded = 3.0, beyond_estimated = 4.0;
constexpr double sure_deviations = 6.0, least_gain = 0.003;
constexpr double just_noise = 1.5;    ///< of χ² over degrees of freedom
constexpr double unsure_noise = 0.3;  ///< of a law of variances
constexpr double least_noise = 1e-7;  ///< of the largest FRF of a reference: what single precision leaves
constexpr double least_share = 0.03;  ///< of a pair, which counts as a gain of one FRF
constexpr double negligible = 1e-12;  ///< of |H_ii H_jj|: FRFs that are zero by symmetry say nothing

/// Largest |H|² of a reference on a line.
double largest_square(const CheckedFile& file, std::size_t line, Index c) {
  double largest = 0.0;
  for (const Complex& value : file.frfs[line].col(c)) {
    if (std::norm(value) > largest) largest = std::norm(value);
  }
  return largest;
}

/// E|e|² of one FRF of a file; NaN where it is not known. `largest`: largest_square() of its reference.
double error_square(const CheckedFile& file, std::size_t line, Index r, Index c, double largest) {
  return file.error_square(line, r, c) + least_noise * least_noise * largest;
}

/// Sums that become an Agreement.
class Sums {
 public:
  Sums(Dofs rows, Dofs columns, std::vector<double> frequency_hz) {
    out_.rows = std::move(rows);
    out_.columns = std::move(columns);
    out_.frequency_hz = std::move(frequency_hz);
    squares_ = counts_ = Eigen::MatrixXd::Zero(at(out_.rows.size()), at(out_.columns.size()));
  }

  void begin_line() { line_square_ = line_freedom_ = 0.0; }
  void cell(Index r, Index c, double ratio) {
    squares_(r, c) += ratio;
    counts_(r, c) += 1.0;
  }
  /// Part of a line that has so much χ² and degrees of freedom, and its worst FRF.
  void add(double square, double freedom, Index worst_row, Index worst_column, double worst_ratio) {
    line_square_ += square;
    line_freedom_ += freedom;
    if (square - freedom <= worst_excess_) return;
    worst_excess_ = square - freedom;
    out_.worst_line = out_.by_line.size();
    out_.worst_row = worst_row;
    out_.worst_column = worst_column;
    out_.worst_ratio = worst_ratio;
  }
  void end_line() {
    const bool any = line_freedom_ > 0.0;
    out_.by_line.push_back(any ? line_square_ / line_freedom_ : nan);
    if (!any) return;
    out_.freedom += line_freedom_;
    square_ += line_square_;
  }

  /// Of a line: what the assembly's FRFs and what they leave have in common, the square of the former, and what noise makes of
  /// both.
  void add_gain(double common, double square, double bias, double freedom) {
    column_freedom_ = freedom;
    excess_.add(bias - common, square - bias);
    bias_ += bias;
  }

  Agreement finish(bool recorded) {
    if (excess_.is_told() && excess_.square() > bias_) {
      out_.excess = excess_.value();
      out_.excess_deviation = excess_.scatter() / excess_.square();
      out_.excess_freedom = excess_.freedom();
      const double ratio = out_.freedom > 0.0 ? square_ / out_.freedom : 1.0;
      out_.ratio_without = ratio - std::pow(out_.excess, 2) * column_freedom_ * excess_.square() / std::max(out_.freedom, 1.0);
      // Below 1 it is where responses share errors, those of the hammer: they leave less than the bias that is taken off.
      out_.excess_doubt = (unsure_noise + std::abs(out_.ratio_without - 1.0)) * bias_ / excess_.square();
    }
    out_.recorded = recorded;
    out_.ratio = out_.freedom > 0.0 ? square_ / out_.freedom : 0.0;
    out_.worst_share = square_ > out_.freedom ? worst_excess_ / (square_ - out_.freedom) : 0.0;
    out_.cells = (counts_.array() > 0.0).select(squares_.array() / counts_.array(), nan).matrix();
    return std::move(out_);
  }

 private:
  Agreement out_;
  Eigen::MatrixXd squares_, counts_;
  SlopeFit excess_;
  double bias_ = 0.0, column_freedom_ = 0.0;
  double square_ = 0.0, line_square_ = 0.0, line_freedom_ = 0.0, worst_excess_ = 0.0;
};

/// Terms of one line of a span test with their error squares.
struct NoisySpan {
  Eigen::MatrixXcd difference, joint, of_assembly;
  Eigen::MatrixXd noise, joint_noise, assembly_noise;

  static void fill(const CheckedFile& file, std::size_t line, const std::vector<Index>& rows, const std::vector<Index>& columns,
                   bool transposed, double sign, Index first, Eigen::MatrixXcd& values, Eigen::MatrixXd& noise) {
    const std::vector<Index>& references = transposed ? rows : columns;
    std::vector<double> largest;
    for (const Index reference : references) largest.push_back(largest_square(file, line, reference));
    for (std::size_t c = 0; c < columns.size(); ++c) {
      for (std::size_t r = 0; r < rows.size(); ++r) {
        const Index i = transposed ? columns[c] : rows[r], j = transposed ? rows[r] : columns[c];
        values(at(r), first + at(c)) += sign * file.frfs[line](i, j);
        noise(at(r), first + at(c)) += error_square(file, line, i, j, largest[transposed ? r : c]);
      }
    }
  }

  NoisySpan(const SpanSetup& setup, const std::vector<CheckedFile>& files, std::size_t line) {
    const Index rows = at(setup.rows.size()), inner = at(setup.part_columns.size()), outer = at(setup.outer_columns.size());
    difference = Eigen::MatrixXcd::Zero(rows, inner + outer);
    noise = Eigen::MatrixXd::Zero(rows, inner + outer);
    joint = Eigen::MatrixXcd::Zero(rows, at(setup.joint.size()));
    joint_noise = Eigen::MatrixXd::Zero(rows, at(setup.joint.size()));
    const CheckedFile &part = files[setup.part], &assembly = files[setup.assembly];
    fill(assembly, line, setup.assembly_rows, setup.assembly_columns, setup.transposed, 1.0, 0, difference, noise);
    fill(assembly, line, setup.assembly_rows, setup.outer_columns, setup.transposed, 1.0, inner, difference, noise);
    of_assembly = difference;
    assembly_noise = noise;
    fill(part, line, setup.part_rows, setup.part_columns, setup.transposed, -1.0, 0, difference, noise);
    fill(part, line, setup.part_rows, setup.joint, setup.transposed, 1.0, 0, joint, joint_noise);
  }

  bool is_complete() const { return difference.allFinite() && joint.allFinite() && noise.allFinite() && joint_noise.allFinite(); }

  void add_to(Sums& sums) const {
    const Index rows = difference.rows();
    const Eigen::VectorXd scale = noise.rowwise().mean().cwiseSqrt();
    if (!(scale.array() > 0.0).all()) return;
    const Eigen::MatrixXcd x = scale.cwiseInverse().asDiagonal() * joint, y = scale.cwiseInverse().asDiagonal() * difference;
    const dense::ComplexMinimumNorm fit(x);
    const auto freedom = static_cast<double>(rows - fit.rank());
    if (!(freedom > 0.0)) return;
    const Eigen::MatrixXcd inverse = fit.pseudo_inverse(), forces = inverse * y, left = y - x * forces;
    const Eigen::MatrixXd expected = scale.cwiseAbs2().cwiseInverse().asDiagonal() * (noise + joint_noise * forces.cwiseAbs2());
    Eigen::VectorXd free(rows);
    for (Index r = 0; r < rows; ++r) free[r] = std::max(1.0 - (x.row(r) * inverse.col(r))(0, 0).real(), 1e-6);
    const Eigen::MatrixXcd scaled = scale.cwiseInverse().asDiagonal() * of_assembly, moved = scaled - x * (inverse * scaled);
    double common = 0.0, moved_square = 0.0, bias = 0.0;
    for (Index c = 0; c < left.cols(); ++c) {
      double square = 0.0, of_noise = 0.0, of_assembly_noise = 0.0, worst = 0.0;
      Index worst_row = 0;
      for (Index r = 0; r < rows; ++r) {
        square += std::norm(left(r, c));
        of_noise += free[r] * expected(r, c);
        of_assembly_noise += free[r] * assembly_noise(r, c) / (scale[r] * scale[r]);
        const double ratio = std::norm(left(r, c)) / (free[r] * expected(r, c));
        sums.cell(r, c, ratio);
        if (ratio > worst) {
          worst = ratio;
          worst_row = r;
        }
      }
      sums.add(freedom * square / of_noise, freedom, worst_row, c, worst);
      common += moved.col(c).dot(left.col(c)).real() / of_noise;
      moved_square += moved.col(c).squaredNorm() / of_noise;
      bias += of_assembly_noise / of_noise;
    }
    sums.add_gain(common, moved_square, bias, freedom);
  }
};

struct MirrorPlaces {
  Dofs dofs;
  std::vector<Index> row, column;

  explicit MirrorPlaces(const CheckedFile& file) {
    for (std::size_t r = 0; r < file.responses.size(); ++r) {
      const std::size_t c = place_of(file.references, file.responses[r]);
      if (c == frf::npos) continue;
      dofs.push_back(file.responses[r]);
      row.push_back(at(r));
      column.push_back(at(c));
    }
  }

  /// each(i, j, H_ij, H_ji) of the pairs i < j of a line that were measured.
  template <class Each>
  void each_pair(const CheckedFile& file, std::size_t line, const Each& each) const {
    for (std::size_t i = 0; i < dofs.size(); ++i) {
      for (std::size_t j = i + 1; j < dofs.size(); ++j) {
        const Eigen::MatrixXcd& h = file.frfs[line];
        const Complex a = h(row[i], column[j]), b = h(row[j], column[i]);
        const double size = std::norm(a) + std::norm(b), points = std::abs(h(row[i], column[i]) * h(row[j], column[j]));
        if (std::isfinite(size) && !(size <= negligible * points)) each(i, j, a, b);
      }
    }
  }
};

/// H_ij and H_ji at one time or on one line are this much of each other's noise: σ² = proportional·|H|² + constant·(mean square
/// of the pair), the constant in the quantity of the file. One law for all pairs, which half of the differences may contradict.
struct MirrorLaw {
  double proportional = 0.0, constant = 0.0;
  Eigen::MatrixXd mean_square;
  Eigen::MatrixXd beyond;  ///< by which a pair's own differences are larger than the law, as most of its lines say; 1 to 30

  MirrorLaw(const CheckedFile& file, const MirrorPlaces& places) {
    constexpr std::size_t most_samples = 6000;
    const Index n = at(places.dofs.size());
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n), count = sum;
    for (std::size_t l = 0; l < file.frfs.size(); ++l) {
      const double factor = frf::squared_factor(file.quantity, file.frequency_hz[l]);
      places.each_pair(file, l, [&](std::size_t i, std::size_t j, const Complex& a, const Complex& b) {
        if (!(factor > 0.0)) return;
        sum(at(i), at(j)) += 0.5 * (std::norm(a) + std::norm(b)) / factor;
        count(at(i), at(j)) += 1.0;
      });
    }
    mean_square = sum.cwiseQuotient(count.cwiseMax(1.0));
    const std::size_t step = 1 + file.frfs.size() * places.dofs.size() * places.dofs.size() / 2 / most_samples;
    std::vector<SquaredError> samples;
    std::size_t number = 0;
    for (std::size_t l = 0; l < file.frfs.size(); ++l) {
      const double factor = frf::squared_factor(file.quantity, file.frequency_hz[l]);
      places.each_pair(file, l, [&](std::size_t i, std::size_t j, const Complex& a, const Complex& b) {
        const double size = mean_square(at(i), at(j)) * factor;
        if (number++ % step != 0 || !(std::isfinite(size) && size > 0.0)) return;
        samples.push_back({std::norm(a - b) / size, (std::norm(a) + std::norm(b)) / size, 2.0, 1.0});
      });
    }
    const frf::VarianceLaw law = fit_noise(samples);
    proportional = 2.0 * law.proportional;
    constant = 2.0 * law.constant;
    beyond = Eigen::MatrixXd::Ones(n, n);
    if (says_anything()) fit_pairs(file, places);
  }

  /// By the median of the ratios, which is ln 2 of their mean in noise.
  void fit_pairs(const CheckedFile& file, const MirrorPlaces& places) {
    constexpr double most = 30.0;
    const std::size_t n = places.dofs.size();
    std::vector<std::vector<double>> ratios(n * n);
    for (std::size_t l = 0; l < file.frfs.size(); ++l) {
      const double factor = frf::squared_factor(file.quantity, file.frequency_hz[l]);
      places.each_pair(file, l, [&](std::size_t i, std::size_t j, const Complex& a, const Complex& b) {
        if (const double ratio = std::norm(a - b) / (*this)(i, j, a, b, factor); std::isfinite(ratio))
          ratios[i * n + j].push_back(ratio);
      });
    }
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      if (!ratios[k].empty()) beyond(at(k / n), at(k % n)) = std::clamp(median(ratios[k]) / std::numbers::ln2, 1.0, most);
    }
  }

  /// E|H_ij − H_ji|².
  double operator()(std::size_t i, std::size_t j, const Complex& a, const Complex& b, double factor) const {
    const double all = proportional * (std::norm(a) + std::norm(b)) + 2.0 * constant * mean_square(at(i), at(j)) * factor;
    return beyond(at(i), at(j)) * all;
  }

  bool says_anything() const { return proportional + constant > 1e-12; }
};

/// E|H_ij − H_ji|² of the pairs of a file: as it is recorded, or by a law that most lines follow.
class MirrorNoise {
 public:
  MirrorNoise(const CheckedFile& file, const MirrorPlaces& places, bool recorded) : file_(file), places_(places) {
    if (!recorded) law_ = std::make_unique<const MirrorLaw>(file, places);
  }

  bool is_known() const { return !law_ || law_->says_anything(); }

  void begin_line(std::size_t line) {
    line_ = line;
    factor_ = frf::squared_factor(file_.quantity, file_.frequency_hz[line]);
    largest_.clear();
    for (const Index c : places_.column) largest_.push_back(largest_square(file_, line, c));
  }

  double operator()(std::size_t i, std::size_t j, const Complex& a, const Complex& b) const {
    if (law_) return (*law_)(i, j, a, b, factor_);
    return error_square(file_, line_, places_.row[i], places_.column[j], largest_[j]) +
           error_square(file_, line_, places_.row[j], places_.column[i], largest_[i]);
  }

 private:
  const CheckedFile& file_;
  const MirrorPlaces& places_;
  std::unique_ptr<const MirrorLaw> law_;
  std::size_t line_ = 0;
  double factor_ = 1.0;
  std::vector<double> largest_;
};

/// H_ij − H_ji = share · (H_ij + H_ji)/2 of a pair, over the lines.
struct PairSlope {
  SlopeFit fit;
  double square = 0.0;               ///< Σ |H_ij − H_ji|², weighed
  double first = 0.0, second = 0.0;  ///< Σ |H_ij|², Σ |H_ji|², weighed
  Complex cross{};                   ///< Σ conj(H_ij) H_ji, weighed

  /// A factor leaves the shape: one of the two that is noise has none.
  bool is_told() const {
    constexpr double least_coherence = 0.8;
    return fit.is_told() && fit.freedom() >= 1.0 && std::norm(cross) > least_coherence * first * second;
  }
  double deviation() const { return fit.scatter() / fit.square(); }
  /// Noise that one of the two has more of than the other looks like a share of at most that.
  double doubt() const { return 0.5 * std::max(0.0, square - fit.value() * fit.slope()) / fit.square(); }
};

/// [i * n + j], i < j.
std::vector<PairSlope> pair_slopes(const CheckedFile& file, const MirrorPlaces& places, MirrorNoise& noise) {
  const std::size_t n = places.dofs.size();
  std::vector<PairSlope> out(n * n);
  for (std::size_t l = 0; l < file.frfs.size(); ++l) {
    noise.begin_line(l);
    places.each_pair(file, l, [&](std::size_t i, std::size_t j, const Complex& a, const Complex& b) {
      const Complex difference = a - b, both = 0.5 * (a + b);
      // Lines that tell a share to less than the least count alike: else the few on resonances would be all.
      const double weight = 1.0 / (noise(i, j, a, b) + least_share * least_share * std::norm(both));
      if (!(std::isfinite(weight) && weight > 0.0)) return;
      PairSlope& pair = out[i * n + j];
      pair.fit.add(weight * (std::conj(both) * difference).real(), weight * std::norm(both));
      pair.square += weight * std::norm(difference);
      pair.first += weight * std::norm(a);
      pair.second += weight * std::norm(b);
      pair.cross += weight * std::conj(a) * b;
    });
  }
  return out;
}

}  // namespace

bool Agreement::tells_gain(double tried) const {
  constexpr double most_gain =
      0.1;  // larger ones heal so much that trials find them; here few lines with noise at the joint look so
  return excess_deviation > 0.0 && ratio_without < just_noise && std::abs(excess) < most_gain &&
         std::abs(excess) > std::max({least_gain, sure_deviations * excess_deviation, excess_doubt}) &&
         !may_be_chance(excess / excess_deviation, excess_freedom, tried);
}

std::vector<std::size_t> Agreement::outlying_lines() const {
  constexpr double far = 100.0;
  std::vector<double> tested = by_line;
  std::erase_if(tested, [](double each) { return std::isnan(each); });
  if (tested.empty()) return {};
  const double limit = far * std::max(1.0, median(tested));
  std::vector<std::size_t> lines;
  for (std::size_t l = 0; l < by_line.size(); ++l) {
    if (by_line[l] > limit) lines.push_back(l);
  }
  return 5 * lines.size() <= tested.size() ? lines : std::vector<std::size_t>{};
}

Agreement Agreement::without(const std::vector<std::size_t>& lines) const {
  Agreement out = *this;
  for (const std::size_t l : lines) out.by_line[l] = nan;
  double sum = 0.0, kept = 0.0, tested = 0.0;
  for (std::size_t l = 0; l < by_line.size(); ++l) {
    tested += std::isnan(by_line[l]) ? 0.0 : 1.0;
    if (std::isnan(out.by_line[l])) continue;
    sum += out.by_line[l];
    kept += 1.0;
  }
  out.ratio = kept > 0.0 ? sum / kept : 0.0;
  out.freedom = tested > 0.0 ? freedom * kept / tested : 0.0;
  return out;
}

bool Agreement::contradicts() const {
  if (!(freedom > 0.0)) return false;
  return ratio > std::max(recorded ? beyond_recorded : beyond_estimated, 1.0 + sure_deviations / std::sqrt(freedom));
}

Agreement span_agreement(const SpanSetup& setup, const std::vector<CheckedFile>& files) {
  const CheckedFile &part = files[setup.part], &assembly = files[setup.assembly];
  if (!part.has_recorded_noise() || !assembly.has_recorded_noise()) return {};
  const Dofs& all_columns = setup.transposed ? assembly.responses : assembly.references;
  Dofs columns;
  for (const auto* some : {&setup.assembly_columns, &setup.outer_columns}) {
    for (const Index c : *some) columns.push_back(all_columns[static_cast<std::size_t>(c)]);
  }
  Sums sums(setup.rows, columns, part.frequency_hz);
  for (std::size_t l = 0; l < part.frfs.size(); ++l) {
    const NoisySpan line(setup, files, l);
    sums.begin_line();
    if (line.is_complete()) line.add_to(sums);
    sums.end_line();
  }
  return sums.finish(true);
}

Agreement mirror_agreement(const CheckedFile& file) { return mirror_agreement(file, file.has_recorded_noise()); }

Agreement mirror_agreement(const CheckedFile& file, bool recorded) {
  const MirrorPlaces places(file);
  if (places.dofs.size() < 2) return {};
  MirrorNoise noise(file, places, recorded);
  if (!noise.is_known()) return {};
  Sums sums(places.dofs, places.dofs, file.frequency_hz);
  for (std::size_t l = 0; l < file.frfs.size(); ++l) {
    noise.begin_line(l);
    sums.begin_line();
    places.each_pair(file, l, [&](std::size_t i, std::size_t j, const Complex& a, const Complex& b) {
      const double ratio = std::norm(a - b) / noise(i, j, a, b);
      if (!std::isfinite(ratio)) return;
      sums.cell(at(i), at(j), ratio);
      sums.cell(at(j), at(i), ratio);
      sums.add(ratio, 1.0, at(i), at(j), ratio);
    });
    sums.end_line();
  }
  return sums.finish(recorded);
}

std::optional<PairFactor> factor_of_one_pair(const CheckedFile& file, double tried) {
  constexpr double beyond_usual = 3.0;
  const MirrorPlaces places(file);
  const std::size_t n = places.dofs.size();
  if (n < 2) return std::nullopt;
  MirrorNoise noise(file, places, file.has_recorded_noise());
  if (!noise.is_known()) return std::nullopt;
  const std::vector<PairSlope> pairs = pair_slopes(file, places, noise);
  std::vector<double> shares;
  for (const PairSlope& pair : pairs) {
    if (pair.is_told()) shares.push_back(std::abs(pair.fit.value()));
  }
  if (shares.empty()) return std::nullopt;
  const double usual = median(shares), all = tried * static_cast<double>(shares.size());
  const PairSlope* worst = nullptr;
  for (const PairSlope& pair : pairs) {
    if (!pair.is_told()) continue;
    const double share = std::abs(pair.fit.value());
    if (!(share > std::max({least_share, beyond_usual * usual, sure_deviations * pair.deviation(), pair.doubt()}))) continue;
    if (may_be_chance(share / pair.deviation(), pair.fit.freedom(), all)) continue;
    if (worst == nullptr || share > std::abs(worst->fit.value())) worst = &pair;
  }
  if (worst == nullptr) return std::nullopt;
  const auto place = static_cast<std::size_t>(worst - pairs.data());
  const double share = worst->fit.value(), factor = (1.0 + 0.5 * share) / (1.0 - 0.5 * share);
  return PairFactor{places.dofs[place / n], places.dofs[place % n], factor, worst->deviation() / std::pow(1.0 - 0.5 * share, 2),
                    usual};
}

ReciprocityMap reciprocity_map(const CheckedFile& file) {
  constexpr std::size_t most = 100;
  const MirrorPlaces places(file);
  const std::size_t n = places.dofs.size();
  ReciprocityMap out{.file = file.name, .dofs = n < 2 ? Dofs{} : places.dofs};
  Eigen::MatrixXd difference = Eigen::MatrixXd::Zero(at(n), at(n)), size = difference;
  for (std::size_t l = 0; l < file.frfs.size(); ++l) {
    const double weight = std::pow(angular(file.frequency_hz[l]), 4);
    places.each_pair(file, l, [&](std::size_t i, std::size_t j, const Complex& a, const Complex& b) {
      difference(at(i), at(j)) += weight * std::norm(a - b);
      size(at(i), at(j)) += weight * 0.5 * (std::norm(a) + std::norm(b));
    });
  }
  out.overall = size.sum() > 0.0 ? std::sqrt(difference.sum() / size.sum()) : 0.0;
  if (n < 2 || n > most) return out;
  out.rms.assign(n, std::vector<double>(n, 0.0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (const double square = size(at(i), at(j)); square > 0.0)
        out.rms[i][j] = out.rms[j][i] = std::sqrt(difference(at(i), at(j)) / square);
    }
  }
  return out;
}

}  // namespace jointid::ident
