#include "virtualpoint/virtual_source.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "virtualpoint/measured_errors.hpp"
#include "virtualpoint/mixture.hpp"

namespace jointid::virtualpoint {
namespace {

using frf::Block;

/// The measured FRFs behind a block.
struct Needed {
  PickedMixture rows, columns;
  std::size_t size() const { return rows.channels.size() * columns.channels.size(); }
  Block block(std::span<const std::size_t> lines) const { return {lines, rows.channels, columns.channels}; }
};

class VirtualSource final : public frf::FrfSource {
 public:
  VirtualSource(std::unique_ptr<FrfSource> source, Mixture responses, Mixture references,
                const std::optional<frf::NoiseModel>& noise, const std::vector<std::string>& phrases)
      : source_(std::move(source)),
        responses_(std::move(responses)),
        references_(std::move(references)),
        errors_(*source_, noise) {
    header_ = source_->header();
    header_.response = responses_.dofs;
    header_.reference = references_.dofs;
    header_.noise = errors_.known() ? frf::NoiseRecord::variance : frf::NoiseRecord::none;
    header_.averages = 0.0;
    header_.repeats = 0;
    header_.changes.insert(header_.changes.end(), phrases.begin(), phrases.end());
    if (errors_.by_law()) header_.changes.emplace_back("their variances by the law of [noise]");
  }

  bool has_covariance() const override { return errors_.known(); }
  bool has_reference_correlation() const override {
    return errors_.known() && (source_->has_reference_correlation() || shares_channels(references_));
  }

 private:
  static bool shares_channels(const Mixture& side) {
    std::set<std::size_t> taken;
    for (const auto& coordinate : side.shares) {
      for (const Share& share : coordinate) {
        if (!taken.insert(share.channel).second) return true;
      }
    }
    return false;
  }

  Needed needed(std::span<const std::size_t> responses, std::span<const std::size_t> references) const {
    return {PickedMixture(responses_, responses), PickedMixture(references_, references)};
  }

  void do_read(const Block& block, std::span<Complex> out) override {
    const Needed from = needed(block.responses, block.references);
    const std::size_t columns = from.columns.channels.size();
    std::vector<Complex> measured(block.lines.size() * from.size()), row(columns);
    source_->read(from.block(block.lines), measured);
    std::size_t next = 0;
    for (std::size_t line = 0; line < block.lines.size(); ++line) {
      const Complex* y = measured.data() + line * from.size();
      for (const auto& response : from.rows.shares) {
        std::ranges::fill(row, Complex(0.0));
        for (const Share& share : response) {
          for (std::size_t c = 0; c < columns; ++c) row[c] += share.factor * y[share.channel * columns + c];
        }
        for (const auto& reference : from.columns.shares) {
          Complex sum = 0.0;
          for (const Share& share : reference) sum += share.factor * row[share.channel];
          out[next++] = sum;
        }
      }
    }
  }

  /// Variances add up; what the covariances of a file add to them is circular and goes half to each part.
  void do_read_variance(const Block& block, std::span<Complex> out) override {
    const Needed from = needed(block.responses, block.references);
    const std::size_t columns = from.columns.channels.size();
    std::vector<Complex> measured(block.lines.size() * from.size());
    errors_.read_variance(from.block(block.lines), measured);
    std::size_t next = 0;
    for (std::size_t line = 0; line < block.lines.size(); ++line) {
      const Complex* v = measured.data() + line * from.size();
      for (const auto& response : from.rows.shares) {
        for (const auto& reference : from.columns.shares) {
          Complex sum = 0.0;
          for (const Share& r : response) {
            for (const Share& c : reference) sum += std::pow(r.factor * c.factor, 2) * v[r.channel * columns + c.channel];
          }
          out[next++] = sum;
        }
      }
    }
    if (source_->has_covariance()) add_common(block, from, out);
  }

  void add_common(const Block& block, const Needed& from, std::span<Complex> out) {
    const std::vector<Complex> measured = covariances(block.lines, from);
    const std::size_t rows = from.rows.channels.size(), columns = from.columns.channels.size();
    std::size_t next = 0;
    for (std::size_t line = 0; line < block.lines.size(); ++line) {
      for (const auto& response : from.rows.shares) {
        for (const auto& reference : from.columns.shares) {
          double sum = 0.0;
          for (const Share& c : reference) {
            const Complex* of = measured.data() + (line * columns + c.channel) * rows * rows;
            for (const Share& r : response) {
              for (const Share& s : response) {
                if (r.channel != s.channel)
                  sum += c.factor * c.factor * r.factor * s.factor * of[r.channel * rows + s.channel].real();
              }
            }
          }
          Complex& to = out[next++];
          to = {std::max(0.0, to.real() + 0.5 * sum), std::max(0.0, to.imag() + 0.5 * sum)};
        }
      }
    }
  }

  /// [line, reference, response, response] of the measured FRFs.
  std::vector<Complex> covariances(std::span<const std::size_t> lines, const Needed& from) {
    std::vector<Complex> measured(lines.size() * from.size() * from.rows.channels.size());
    errors_.read_covariance(from.block(lines), measured);
    return measured;
  }

  void do_read_coherence(const Block&, std::span<double>) override {}

  void do_read_covariance(const Block& pairs, std::span<Complex> out) override {
    const auto wanted = responses_of(pairs.responses);
    std::vector<std::size_t> some;
    for (const auto& [r, s] : wanted) some.insert(some.end(), {r, s});
    std::ranges::sort(some);
    some.erase(std::unique(some.begin(), some.end()), some.end());
    const auto place = [&](std::size_t r) { return static_cast<std::size_t>(std::ranges::lower_bound(some, r) - some.begin()); };
    const Needed from = needed(some, pairs.references);
    const std::vector<Complex> measured = covariances(pairs.lines, from);
    const std::size_t rows = from.rows.channels.size(), columns = from.columns.channels.size();
    std::size_t next = 0;
    for (std::size_t line = 0; line < pairs.lines.size(); ++line) {
      for (const auto& [r, s] : wanted) {
        for (const auto& reference : from.columns.shares) {
          Complex sum = 0.0;
          for (const Share& c : reference) {
            const Complex* of = measured.data() + (line * columns + c.channel) * rows * rows;
            for (const Share& i : from.rows.shares[place(r)]) {
              for (const Share& j : from.rows.shares[place(s)]) {
                sum += c.factor * c.factor * i.factor * j.factor * of[i.channel * rows + j.channel];
              }
            }
          }
          out[next++] = r == s ? Complex(std::max(0.0, sum.real()), 0.0) : sum;
        }
      }
    }
  }

  /// References made of the same impacts share their errors: those of impact k are taken as √w_k times like ones over the
  /// responses, w_k the mean over the measured responses of its variance in parts of that of all impacts. Exact where covariances
  /// of impacts differ by a factor alone.
  void do_read_reference_correlation(std::span<const std::size_t> lines, std::span<const std::size_t> references,
                                     std::span<Complex> out) override {
    const std::vector<std::size_t> responses = first_indices(header_.response.size());
    const Needed from = needed(responses, references);
    const std::size_t columns = from.columns.channels.size(), size = references.size();
    std::vector<Complex> measured(lines.size() * from.size());
    errors_.read_variance(from.block(lines), measured);
    std::vector<Complex> between;
    if (source_->has_reference_correlation()) {
      between.resize(lines.size() * columns * columns);
      source_->read_reference_correlation(lines, from.columns.channels, between);
    }
    for (std::size_t line = 0; line < lines.size(); ++line) {
      const std::vector<double> root = roots(std::span(measured).subspan(line * from.size(), from.size()), columns);
      const auto common = [&](std::size_t m, std::size_t n) {
        Complex sum = 0.0;
        for (const Share& a : from.columns.shares[m]) {
          for (const Share& b : from.columns.shares[n]) {
            Complex correlation = a.channel == b.channel ? 1.0 : 0.0;
            if (!between.empty()) correlation = between[(line * columns + a.channel) * columns + b.channel];
            if (correlation != Complex(0.0)) sum += a.factor * b.factor * root[a.channel] * root[b.channel] * correlation;
          }
        }
        return sum;
      };
      std::vector<double> own;
      for (std::size_t m = 0; m < size; ++m) own.push_back(std::sqrt(common(m, m).real()));
      for (std::size_t m = 0; m < size; ++m) {
        for (std::size_t n = 0; n < size; ++n) out[(line * size + m) * size + n] = m == n ? 1.0 : common(m, n) / (own[m] * own[n]);
      }
    }
  }

  /// √w of each impact, from the variances [response, impact] of a line; 1 where none is known.
  static std::vector<double> roots(std::span<const Complex> variances, std::size_t columns) {
    std::vector<double> sum(columns, 0.0), count(columns, 0.0);
    for (std::size_t first = 0; first < variances.size(); first += columns) {
      const auto total = [&](std::size_t c) { return variances[first + c].real() + variances[first + c].imag(); };
      double all = 0.0;
      for (std::size_t c = 0; c < columns; ++c) all += total(c);
      if (!(all > 0.0) || !std::isfinite(all)) continue;
      for (std::size_t c = 0; c < columns; ++c) {
        sum[c] += total(c) / all;
        count[c] += 1.0;
      }
    }
    for (std::size_t c = 0; c < columns; ++c) sum[c] = count[c] > 0.0 ? std::sqrt(sum[c] / count[c]) : 1.0;
    return sum;
  }

  /// Responses (r, s) of pair indices.
  std::vector<std::pair<std::size_t, std::size_t>> responses_of(std::span<const std::size_t> pairs) const {
    std::vector<std::pair<std::size_t, std::size_t>> all, out;
    for (std::size_t r = 0; r < header_.response.size(); ++r) {
      for (std::size_t s = 0; s <= r; ++s) all.emplace_back(r, s);
    }
    for (const std::size_t pair : pairs) out.push_back(all[pair]);
    return out;
  }

  std::unique_ptr<FrfSource> source_;
  Mixture responses_, references_;
  MeasuredErrors errors_;
};

/// "VP1 from 12 sensors and 18 impacts", or empty.
std::string phrase(const VirtualPoint& point, const frf::FrfHeader& header) {
  const std::size_t sensors = transformation(point, Side::sensors, header).channels.size();
  const std::size_t impacts = transformation(point, Side::impacts, header).channels.size();
  if (sensors + impacts == 0) return {};
  std::string text = name(point) + " from ";
  if (sensors > 0) text += std::to_string(sensors) + " sensors";
  if (sensors > 0 && impacts > 0) text += " and ";
  return text + (impacts > 0 ? std::to_string(impacts) + " impacts" : "");
}

}  // namespace

std::unique_ptr<frf::FrfSource> virtual_source(std::unique_ptr<frf::FrfSource> source, const std::vector<VirtualPoint>& points,
                                               const std::optional<frf::NoiseModel>& noise) {
  std::vector<std::string> phrases;
  for (const VirtualPoint& point : points) {
    std::string text = phrase(point, source->header());
    if (!text.empty()) phrases.push_back(std::move(text));
  }
  if (phrases.empty()) return source;
  Mixture responses = mixture(source->header(), Side::sensors, points),
          references = mixture(source->header(), Side::impacts, points);
  return std::make_unique<VirtualSource>(std::move(source), std::move(responses), std::move(references), noise, phrases);
}

}  // namespace jointid::virtualpoint
