#include "frf/set/frf_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numeric>

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

 private:
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

std::unique_ptr<FrfSource> from_memory(FrfSet set) { return from_shared(std::make_shared<FrfSet>(std::move(set))); }

std::unique_ptr<FrfSource> from_shared(std::shared_ptr<const FrfSet> set) {
  return std::make_unique<MemorySource>(std::move(set));
}

FrfSet load(FrfSource& source) {
  const auto indices = [](std::size_t count) {
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  };
  const auto lines = indices(source.header().lines());
  const auto responses = indices(source.header().response.size());
  const auto references = indices(source.header().reference.size());
  return load(source, {lines, responses, references});
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
