#include "frf/set/frf_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace jointid::frf {
namespace {

/// Hands out blocks of a set that lies in memory.
class MemorySource final : public FrfSource {
 public:
  explicit MemorySource(std::shared_ptr<const FrfSet> set) : set_(std::move(set)) {
    validate(set_->header);
    assert(set_->values.size() == set_->header.lines() * set_->header.entries());
    header_ = set_->header;
  }

  bool in_memory() const override { return true; }
  bool has_covariance() const override { return !set_->covariance.empty(); }

 private:
  void do_read_covariance(const Block& pairs, std::span<Complex> out) override {
    const std::size_t rows = pair_count(header_.response.size()), columns = header_.reference.size();
    std::size_t next = 0;
    for (const std::size_t line : pairs.lines) {
      for (const std::size_t pair : pairs.responses) {
        for (const std::size_t c : pairs.references) out[next++] = set_->covariance[(line * rows + pair) * columns + c];
      }
    }
  }

  template <class T>
  void gather(const Block& block, const std::vector<T>& from, std::span<T> out) const {
    std::size_t next = 0;
    for (const std::size_t line : block.lines) {
      for (const std::size_t r : block.responses) {
        const T* row = from.data() + set_->index(line, r, 0);
        for (const std::size_t c : block.references) out[next++] = row[c];
      }
    }
  }

  void do_read(const Block& block, std::span<Complex> out) override { gather(block, set_->values, out); }
  void do_read_variance(const Block& block, std::span<Complex> out) override { gather(block, set_->variance, out); }
  void do_read_coherence(const Block& block, std::span<double> out) override { gather(block, set_->coherence, out); }

  std::shared_ptr<const FrfSet> set_;
};

/// Coherences of 1 may come from averages of single precision.
constexpr double rounding = 1e-5;

/// "4:+Y/1:+Y, line 7": what stands at a place of a block.
std::string place_text(const FrfHeader& header, const Block& block, std::size_t at) {
  const std::size_t columns = block.references.size(), rows = block.responses.size();
  return fmt::format("{}/{}, line {}", header.response[block.responses[at / columns % rows]].name(),
                     header.reference[block.references[at % columns]].name(), block.lines[at / columns / rows] + 1);
}

std::vector<std::size_t> indices(std::size_t count) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// Throws InputError unless the covariance of an error with itself is real and not below 0, to rounding.
void require_diagonal(const FrfHeader& header, std::size_t line, std::size_t r, std::size_t c, Complex value) {
  if (!(value.real() < 0.0) && !(std::abs(value.imag()) > rounding * value.real())) return;
  fail(header, fmt::format("covariance of {}/{}, line {}", header.response[r].name(), header.reference[c].name(), line + 1),
       fmt::format("{:g} + {:g}i is no variance", value.real(), value.imag()),
       "export the covariances again, or leave them out");
}

}  // namespace

void FrfSource::read(const Block& block, std::span<Complex> out) {
  assert(out.size() == block.size());
  ++count_.calls;
  count_.lines += block.lines.size();
  count_.entries += block.size();
  if (block.size() > 0) do_read(block, out);
}

void FrfSource::read_variance(const Block& block, std::span<Complex> out) {
  assert(header_.noise == NoiseRecord::variance && out.size() == block.size());
  if (block.size() == 0) return;
  do_read_variance(block, out);
  const auto wrong = std::find_if(out.begin(), out.end(), [](Complex v) { return v.real() < 0.0 || v.imag() < 0.0; });
  if (wrong == out.end()) return;
  fail(header_, "variance of " + place_text(header_, block, static_cast<std::size_t>(wrong - out.begin())),
         fmt::format("{} is below 0", std::min(wrong->real(), wrong->imag())), "export the variances again, or leave them out");
}

void FrfSource::read_coherence(const Block& block, std::span<double> out) {
  assert(header_.noise == NoiseRecord::coherence && out.size() == block.size());
  if (block.size() == 0) return;
  do_read_coherence(block, out);
  const auto wrong = std::find_if(out.begin(), out.end(), [](double value) { return value < 0.0 || value > 1.0 + rounding; });
  if (wrong == out.end()) return;
  fail(header_, "coherence of " + place_text(header_, block, static_cast<std::size_t>(wrong - out.begin())),
         fmt::format("{} is not between 0 and 1", *wrong), "export the coherences again, or leave them out");
}

void FrfSource::read_covariance(const Block& block, std::span<Complex> out) {
  const std::size_t rows = block.responses.size(), columns = block.references.size();
  assert(has_covariance() && out.size() == block.size() * rows);
  if (block.size() == 0) return;
  std::vector<std::size_t> pairs;
  for (const std::size_t r : block.responses) {
    for (const std::size_t s : block.responses) pairs.push_back(pair_index(std::max(r, s), std::min(r, s)));
  }
  std::vector<std::size_t> stored = pairs;
  std::ranges::sort(stored);
  stored.erase(std::unique(stored.begin(), stored.end()), stored.end());
  std::vector<Complex> values(block.lines.size() * stored.size() * columns);
  do_read_covariance({block.lines, stored, block.references}, values);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const std::size_t i = k / rows, j = k % rows;
    const auto at = static_cast<std::size_t>(std::ranges::lower_bound(stored, pairs[k]) - stored.begin());
    for (std::size_t l = 0; l < block.lines.size(); ++l) {
      for (std::size_t c = 0; c < columns; ++c) {
        const Complex value = values[(l * stored.size() + at) * columns + c];
        out[(l * columns + c) * rows * rows + k] = block.responses[i] < block.responses[j] ? std::conj(value) : value;
        if (i == j) require_diagonal(header_, block.lines[l], block.responses[i], block.references[c], value);
      }
    }
  }
}

void FrfSource::read_covariance_pairs(std::span<const std::size_t> lines, std::span<Complex> out) {
  const std::size_t rows = header_.response.size();
  const auto pairs = indices(pair_count(rows)), references = indices(header_.reference.size());
  assert(has_covariance() && out.size() == lines.size() * pairs.size() * references.size());
  if (out.empty()) return;
  do_read_covariance({lines, pairs, references}, out);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    for (std::size_t r = 0; r < rows; ++r) {
      for (const std::size_t c : references) {
        require_diagonal(header_, lines[l], r, c, out[(l * pairs.size() + pair_index(r, r)) * references.size() + c]);
      }
    }
  }
}

void FrfSource::do_read_covariance(const Block&, std::span<Complex>) {
  throw std::logic_error("a source that has covariances must read them");
}

std::vector<ErrorSums> FrfSource::read_error_sums(const Block& block) {
  assert(has_error_sums());
  return do_read_error_sums(block);
}

std::vector<ErrorSums> FrfSource::do_read_error_sums(const Block&) {
  throw std::logic_error("a source that has sums of errors must read them");
}

std::unique_ptr<FrfSource> from_memory(FrfSet set) { return from_shared(std::make_shared<FrfSet>(std::move(set))); }

std::unique_ptr<FrfSource> from_shared(std::shared_ptr<const FrfSet> set) {
  return std::make_unique<MemorySource>(std::move(set));
}

FrfSet load(FrfSource& source) {
  const auto lines = indices(source.header().lines());
  const auto responses = indices(source.header().response.size());
  const auto references = indices(source.header().reference.size());
  return load(source, {lines, responses, references});
}

FrfSet load_with_covariance(FrfSource& source) {
  FrfSet set = load(source);
  if (!source.has_covariance()) return set;
  const FrfHeader& header = set.header;
  set.covariance.resize(header.lines() * pair_count(header.response.size()) * header.reference.size());
  source.read_covariance_pairs(indices(header.lines()), set.covariance);
  return set;
}

FrfSet load(FrfSource& source, const Block& block) {
  FrfSet set{.header = source.header(), .values = std::vector<Complex>(block.size()), .variance = {}, .coherence = {}};
  const auto pick = [](auto& from, std::span<const std::size_t> indices) {
    std::remove_reference_t<decltype(from)> picked;
    for (const std::size_t i : indices) picked.push_back(from[i]);
    from = std::move(picked);
  };
  pick(set.header.frequency_hz, block.lines);
  pick(set.header.response, block.responses);
  pick(set.header.reference, block.references);
  source.read(block, set.values);
  if (set.header.noise == NoiseRecord::variance) {
    set.variance.resize(block.size());
    source.read_variance(block, set.variance);
  }
  if (set.header.noise == NoiseRecord::coherence) {
    set.coherence.resize(block.size());
    source.read_coherence(block, set.coherence);
  }
  return set;
}

}  // namespace jointid::frf
