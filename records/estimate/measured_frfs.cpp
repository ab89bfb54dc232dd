#include "records/estimate/measured_frfs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/control.hpp"
#include "base/error.hpp"
#include "base/statistics.hpp"
#include "frf/set/scaled_source.hpp"
#include "records/estimate/decay_correction.hpp"
#include "records/estimate/several_forces.hpp"
#include "records/estimate/stretches.hpp"
#include "records/estimate/transformer.hpp"
#include "records/estimate/window.hpp"

namespace jointid::records {
namespace {

/// FRFs and noise of one reference, as receptances into column c of the set.
void store(const Estimate& estimate, const std::vector<ChannelKind>& kinds, std::size_t c, MeasuredFrfs& made) {
  frf::FrfSet& set = made.set;
  const std::size_t rows = kinds.size(), columns = set.header.reference.size(), pairs = frf::pair_count(rows);
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    std::vector<Complex> factor;
    for (const ChannelKind kind : kinds) factor.push_back(frf::to_receptance(quantity_of(kind), set.header.frequency_hz[line]));
    for (std::size_t r = 0; r < rows; ++r) {
      const std::size_t at = set.index(line, r, c), from = line * rows + r;
      const bool known = std::isfinite(factor[r].real()) && std::isfinite(factor[r].imag());
      set.values[at] = known ? factor[r] * estimate.frf[from] : Complex{nan, nan};
      made.coherence[at] = estimate.coherence[from];
      if (!set.variance.empty())
        set.variance[at] = known ? frf::scaled_variance(factor[r], estimate.variance[from]) : Complex{nan, nan};
      const std::size_t rank = estimate.factor.size() / (set.header.lines() * rows);  // the set's, or less
      for (std::size_t k = 0; k < set.factor.rank; ++k) {
        const Complex value = k < rank ? estimate.factor[from * rank + k] : estimate.variance[from] * 0.0;
        set.factor.rows[((line * rows + r) * set.factor.rank + k) * columns + c] = known ? factor[r] * value : Complex{nan, nan};
      }
      for (std::size_t s = 0; s <= r && !set.covariance.empty(); ++s) {
        const Complex of_pair = factor[r] * std::conj(factor[s]) * estimate.covariance[line * pairs + frf::pair_index(r, s)];
        set.covariance[(line * pairs + frf::pair_index(r, s)) * columns + c] = r == s ? Complex{of_pair.real(), 0.0} : of_pair;
      }
    }
  }
}

/// One run of make_frfs().
class Run {
 public:
  Run(std::span<const Record> records, const FrfOptions& options) : records_(records), options_(options) {
    if (options_.segments || options_.hammer.block_s) begin_together();
    require_alike(records_);
    if (several()) require_several_possible();
    made_.blows = find_stretches(records_, options_);
    length_ = made_.blows.empty() ? 0 : 2;
    for (const Blow& blow : made_.blows) length_ = blow.rejected.empty() ? std::max(length_, blow.length) : length_;
    count_averages();
    make_header();
  }

  MeasuredFrfs run(const std::function<bool()>& interrupted) {
    const double spacing = records_[0].rate_hz / static_cast<double>(length_);
    Transformer transformer(options_, length_, records_[0].rate_hz);
    if (several()) {
      Spectra all = transform(transformer, 0, interrupted);
      const SeveralForces spectra{all.lines, made_.averages.size(), all.responses,
                                  all.count, std::move(all.force),  std::move(all.motion)};
      SeveralEstimates made = estimate(spectra, made_.averages[0].effective, form());
      for (std::size_t c = 0; c < made.of_force.size(); ++c) store(made.of_force[c], kinds_, c, made_);
      if (made_.set.has_covariance()) made_.set.reference_correlation = std::move(made.reference_correlation);
      return std::move(made_);
    }
    for (std::size_t c = 0; c < made_.averages.size(); ++c) {
      const Spectra spectra = transform(transformer, c, interrupted);
      Estimate of_reference = estimate(spectra, options_.estimator, options_.noise, made_.averages[c].effective, form());
      if (options_.decay_time_s) correct_decay(of_reference, kinds_.size(), spacing, *options_.decay_time_s, correlation(c));
      store(of_reference, kinds_, c, made_);
    }
    return std::move(made_);
  }

 private:
  /// Stretches of a record are those of one time in all channels.
  void begin_together() {
    if (std::ranges::none_of(records_, has_delays)) return;
    for (const Record& record : records_) aligned_.push_back(from_common_start(record));
    records_ = aligned_;
  }

  CovarianceForm form() const { return made_.set.factor.any() ? CovarianceForm::factor : CovarianceForm::pairs; }

  /// Columns of the largest factor of all references. Rank 0 where the covariances are better told as pairs: those of neighbouring lines,
  /// which the correction of an exponential window mixes, have no small factor.
  frf::FactorShape factor_shape() const {
    if (options_.decay_time_s) return {};
    std::size_t rank = 0;
    for (const Averages& of : made_.averages) {
      const std::size_t own = several() ? of.kept - std::min(of.kept, made_.averages.size())
                                        : factor_rank(of.kept, options_.estimator, options_.noise);
      rank = std::max(rank, own);
    }
    const frf::FactorShape shape{rank};
    return shape.is_smaller(kinds_.size()) ? shape : frf::FactorShape{};
  }

  void require_several_possible() const {
    if (!options_.segments) force_channel(records_[0]);
    if (options_.estimator == Estimator::h1 && options_.noise == NoiseFrom::residuals) return;
    throw InputError({ErrorKind::usage,
                      {},
                      {},
                      "only H1 separates several forces at once, with variances of the residuals",
                      "leave --estimator and --variances out"});
  }

  bool several() const { return force_channels(records_[0]).size() > 1; }

  /// The place of the force at `dof` among the references, or npos.
  std::size_t reference_of(const Record& record, const frf::Dof& dof) const {
    for (std::size_t c = 0; c < made_.averages.size(); ++c) {
      if (!made_.averages[c].reference.same_coordinate(dof)) continue;
      if (made_.averages[c].reference == dof) return c;
      throw InputError({ErrorKind::data,
                        record.file,
                        {},
                        "the force is at " + dof.name() + ", before at " + made_.averages[c].reference.name(),
                        "give one sign; a hit from the other side has negative numbers"});
    }
    return frf::npos;
  }

  /// Whether a stretch is averaged for reference c.
  bool counts_for(const Blow& blow, std::size_t c) const {
    const Record& record = records_[blow.record];
    const auto at_c = [&](std::size_t i) { return record.channels[i].dof == made_.averages[c].reference; };
    return blow.rejected.empty() && std::ranges::any_of(force_channels(record), at_c);
  }

  /// Of neighbouring lines under the exponential window, for the mean place of the blows.
  std::vector<Complex> correlation(std::size_t c) const {
    double peaks = 0.0;
    for (const Blow& blow : made_.blows) {
      if (counts_for(blow, c)) peaks += static_cast<double>(*blow.peak - blow.first);
    }
    return line_correlation(exponential_window(length_, *options_.decay_time_s, records_[0].rate_hz),
                            peaks / static_cast<double>(made_.averages[c].kept));
  }

  void count(const Blow& blow, const frf::Dof& dof) {
    const Record& record = records_[blow.record];
    std::size_t c = reference_of(record, dof);
    if (c == frf::npos) {
      c = made_.averages.size();
      made_.averages.push_back({dof});
    }
    ++made_.averages[c].found;
    if (!blow.rejected.empty()) return;
    ++made_.averages[c].kept;
    if (blow.length == length_) return;
    throw InputError({ErrorKind::data,
                      record.file,
                      {},
                      fmt::format("has {} samples, another record {}", blow.length, length_),
                      "give --block, the seconds after each trigger"});
  }

  void count_averages() {
    for (const Blow& blow : made_.blows) {
      for (const std::size_t i : force_channels(records_[blow.record])) count(blow, records_[blow.record].channels[i].dof);
    }
    if (made_.averages.empty())
      throw InputError({ErrorKind::data,
                        records_[0].file,
                        {},
                        "no hit was found",
                        "give a lower --trigger, or check which channel is the force"});
    for (Averages& of : made_.averages) {
      if (of.kept == 0) {
        throw InputError(
            {ErrorKind::data,
             records_[0].file,
             {},
             fmt::format("all {} segments with the force at {} are rejected: {}", of.found, of.reference.name(), first_reason()),
             "measure again, or average them all the same with --keep-faulty"});
      }
      of.effective = options_.segments ? frf::effective_averages(static_cast<int>(of.kept), options_.segments->overlap,
                                                                 options_.segments->window)
                                       : static_cast<double>(of.kept);
    }
  }

  std::string first_reason() const {
    const auto found = std::ranges::find_if(made_.blows, [](const Blow& blow) { return !blow.rejected.empty(); });
    return found == made_.blows.end() ? std::string() : found->rejected;
  }

  void make_header() {
    const Record& first = records_[0];
    for (const std::size_t i : motion_channels(first)) kinds_.push_back(first.channels[i].kind);
    frf::FrfHeader& header = made_.set.header;
    header.file = first.file;
    for (const std::size_t i : motion_channels(first)) header.response.push_back(first.channels[i].dof);
    for (const Averages& of : made_.averages) header.reference.push_back(of.reference);
    const bool alike = std::ranges::all_of(kinds_, [&](ChannelKind kind) { return kind == kinds_[0]; });
    header.quantity = alike ? quantity_of(kinds_[0]) : frf::Quantity::receptance;
    for (std::size_t k = 0; k <= length_ / 2; ++k) {
      const double hz = static_cast<double>(k) * first.rate_hz / static_cast<double>(length_);
      if (hz <= options_.highest_hz) header.frequency_hz.push_back(hz);
    }
    frf::validate(header);
    const std::size_t size = header.lines() * header.entries();
    made_.set.values.resize(size);
    made_.coherence.resize(size);
    if (std::ranges::none_of(made_.averages, [](const Averages& of) { return of.effective > 1.0; })) return;
    header.noise = frf::NoiseRecord::variance;
    for (const Averages& of : made_.averages) {
      if (of.effective > 1.0 && (header.averages == 0.0 || of.effective < header.averages)) header.averages = of.effective;
    }
    made_.set.variance.resize(size);
    if (kinds_.size() == 1 && !several()) return;
    made_.set.factor.rank = factor_shape().rank;
    if (made_.set.factor.any()) {
      made_.set.factor.rows.resize(size * made_.set.factor.rank);
      return;
    }
    made_.set.covariance.resize(header.lines() * frf::pair_count(kinds_.size()) * header.reference.size());
  }

  Spectra transform(Transformer& transformer, std::size_t c, const std::function<bool()>& interrupted) const {
    Spectra out{made_.set.header.lines(), kinds_.size(), 0, {}, {}};
    const auto append = [&](const std::vector<Complex>& lines, std::vector<Complex>& to) {
      to.insert(to.end(), lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(out.lines));
    };
    for (const Blow& blow : made_.blows) {
      if (!counts_for(blow, c)) continue;
      stop_if(interrupted);
      const Record& record = records_[blow.record];
      for (const std::size_t i : force_channels(record)) append(transformer.transform(record.channels[i], blow), out.force);
      for (const std::size_t i : motion_channels(record)) append(transformer.transform(record.channels[i], blow), out.motion);
      ++out.count;
    }
    return out;
  }

  std::span<const Record> records_;
  std::vector<Record> aligned_;  ///< where channels begin at different times
  const FrfOptions& options_;
  std::vector<ChannelKind> kinds_;
  std::size_t length_ = 0;
  MeasuredFrfs made_;
};

}  // namespace

MeasuredFrfs make_frfs(std::span<const Record> records, const FrfOptions& options, const std::function<bool()>& interrupted) {
  validate(options);
  if (records.empty()) throw InputError({ErrorKind::usage, {}, {}, "there are no records", "give files of time records"});
  return Run(records, options).run(interrupted);
}

}  // namespace jointid::records
