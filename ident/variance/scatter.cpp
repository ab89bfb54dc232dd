#include "ident/variance/scatter.hpp"

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "ident/variance/local_model.hpp"
#include "ident/variance/mirror_difference.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t most_order = 6, most_windows = 24, least_windows = 8;

/// The lines of the file that say something about those in use: all between, and a window beyond.
std::vector<std::size_t> around(const frf::FrfHeader& header, std::span<const std::size_t> lines) {
  const std::size_t margin = window_lines(most_order);
  const std::size_t first = lines.front() > margin ? lines.front() - margin : 0;
  const std::size_t last = std::min(lines.back() + margin, header.lines() - 1);
  std::vector<std::size_t> all;
  for (std::size_t line = first; line <= last; ++line) all.push_back(line);
  if (all.size() < window_lines(1)) {
    throw InputError({.kind = ErrorKind::data,
                      .file = header.file,
                      .place = "variances",
                      .problem = std::to_string(all.size()) + " lines are too few to see the scatter of the FRFs",
                      .remedy = "give " + std::to_string(window_lines(1)) +
                                " lines or more, repeats, or a [noise] section with model and level"});
  }
  return all;
}

/// First lines of windows that cover the range: side by side, or overlapping when there are few.
std::vector<std::size_t> windows(std::size_t lines, std::size_t length) {
  const std::size_t room = lines - length;
  const std::size_t step = std::max({std::size_t{1}, std::min(length, room / (least_windows - 1)),
                                     (room + most_windows - 2) / (most_windows - 1)});
  std::vector<std::size_t> starts;
  for (std::size_t start = 0; start <= room; start += step) starts.push_back(start);
  return starts;
}

/// The FRFs of a piece as stored, entry by entry over some lines.
class Stored {
 public:
  Stored(frf::FrfSource& source, const frf::BlockPiece& piece) : source_(source), piece_(piece) {}

  void read(std::span<const std::size_t> lines) {
    const frf::FrfHeader& header = source_.header();
    values_.resize(lines.size() * piece_.size());
    source_.read({lines, piece_.responses, piece_.references}, values_);
    lines_.assign(lines.begin(), lines.end());
    for (std::size_t i = 0; i < values_.size(); ++i) {
      values_[i] *= frf::from_receptance(header.quantity, header.frequency_hz[lines[i / piece_.size()]]);
    }
  }

  /// What was measured of an entry.
  void take(std::size_t entry, std::vector<double>& frequency_hz, std::vector<Complex>& frf) const {
    frequency_hz.clear();
    frf.clear();
    for (std::size_t line = 0; line < lines_.size(); ++line) {
      const Complex value = values_[line * piece_.size() + entry];
      if (std::isnan(value.real())) continue;
      frequency_hz.push_back(source_.header().frequency_hz[lines_[line]]);
      frf.push_back(value);
    }
  }

 private:
  frf::FrfSource& source_;
  const frf::BlockPiece& piece_;
  std::vector<std::size_t> lines_;
  std::vector<Complex> values_;
};

/// What models of one order find of an FRF.
struct OrderFit {
  frf::VarianceLaw law;
  double level = 0.0;     ///< mean of log σ²
  double relative = 0.0;  ///< σ²/|H|² where the FRF has its rms
};

OrderFit summarise(std::span<const SquaredError> samples) {
  OrderFit fit{.law = fit_noise(samples), .level = 0.0, .relative = 0.0};
  double variance = 0.0, square = 0.0;
  for (const SquaredError& sample : samples) {
    const double noise = 2.0 * (fit.law.proportional * sample.proportional + fit.law.constant * sample.constant);
    fit.level += std::log(std::max(noise / sample.constant, 1e-300)) / static_cast<double>(samples.size());
    variance += noise;
    square += sample.proportional;
  }
  fit.relative = square > 0.0 ? variance / square : 0.0;
  return fit;
}

std::vector<std::vector<SquaredError>> residuals(Stored& stored, std::size_t entries, std::span<const std::size_t> lines,
                                                 std::size_t order) {
  std::vector<std::vector<SquaredError>> all(entries);
  std::vector<double> frequency_hz;
  std::vector<Complex> frf;
  for (const std::size_t start : windows(lines.size(), window_lines(order))) {
    stored.read(lines.subspan(start, window_lines(order)));
    for (std::size_t entry = 0; entry < entries; ++entry) {
      stored.take(entry, frequency_hz, frf);
      if (frf.size() < least_window_lines(order)) continue;
      const SquaredError error = local_residual(frequency_hz, frf, order);
      if (error.constant > 0.0) all[entry].push_back(error);
    }
  }
  return all;
}

/// Picks the order; true when the FRF is resolved.
bool choose(const std::vector<OrderFit>& fits, frf::VarianceLaw& law) {
  constexpr double about_same = 0.7, agree = 0.7, most_relative = 0.09;
  if (fits.empty()) return true;  // nothing was measured
  const double least = std::min_element(fits.begin(), fits.end(), [](const OrderFit& a, const OrderFit& b) {
                         return a.level < b.level;
                       })->level;
  const auto near = [&](double distance) {
    return [=](const OrderFit& fit) { return fit.level <= least + distance; };
  };
  const auto chosen = std::find_if(fits.begin(), fits.end(), near(about_same));
  law = chosen->law;
  return std::count_if(fits.begin(), fits.end(), near(agree)) > 1 && chosen->relative <= most_relative;
}

}  // namespace

Scatter estimate_scatter(frf::FrfSource& source, const frf::BlockPiece& piece, std::span<const std::size_t> lines) {
  const std::vector<std::size_t> near = around(source.header(), lines);
  const std::size_t entries = piece.size();
  const std::vector<std::optional<frf::VarianceLaw>> direct = mirror_laws(source, piece, near);
  Stored stored(source, piece);
  std::vector<std::vector<OrderFit>> fits(entries);
  const bool all_direct = std::all_of(direct.begin(), direct.end(), [](const auto& law) { return law.has_value(); });
  for (std::size_t order = 1; order <= most_order && window_lines(order) <= near.size() && !all_direct; ++order) {
    const auto samples = residuals(stored, entries, near, order);
    for (std::size_t entry = 0; entry < entries; ++entry) {
      if (!direct[entry] && !samples[entry].empty()) fits[entry].push_back(summarise(samples[entry]));
    }
  }
  Scatter out{.laws = std::vector<frf::VarianceLaw>(entries), .unresolved = 0};
  for (std::size_t entry = 0; entry < entries; ++entry) {
    if (direct[entry]) {
      out.laws[entry] = *direct[entry];
    } else if (!choose(fits[entry], out.laws[entry])) {
      ++out.unresolved;
    }
  }
  return out;
}

}  // namespace jointid::ident
