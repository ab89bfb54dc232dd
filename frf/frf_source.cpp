#include "frf/frf_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numeric>

#include "frf/error.hpp"

namespace jointid::frf {
namespace {

/// Hands out blocks of a set that lies in memory.
class MemorySource final : public FrfSource {
 public:
  explicit MemorySource(FrfSet set) : set_(std::move(set)) {
    validate(set_.header);
    assert(set_.values.size() == set_.header.lines() * set_.header.entries());
    header_ = set_.header;
  }

 private:
  template <class T>
  void gather(const Block& block, const std::vector<T>& from, std::span<T> out) const {
    std::size_t next = 0;
    for (const std::size_t line : block.lines) {
      for (const std::size_t r : block.responses) {
        const T* row = from.data() + set_.index(line, r, 0);
        for (const std::size_t c : block.references) out[next++] = row[c];
      }
    }
  }

  void do_read(const Block& block, std::span<Complex> out) override { gather(block, set_.values, out); }
  void do_read_variance(const Block& block, std::span<Complex> out) override { gather(block, set_.variance, out); }
  void do_read_coherence(const Block& block, std::span<double> out) override { gather(block, set_.coherence, out); }

  FrfSet set_;
};

/// Coherences of 1 may come from averages of single precision.
constexpr double rounding = 1e-5;

[[noreturn]] void refuse_coherence(const FrfHeader& header, const Block& block, std::size_t at, double value) {
  const std::size_t columns = block.references.size(), rows = block.responses.size();
  const std::string pair = header.response[block.responses[at / columns % rows]].name() + "/" +
                           header.reference[block.references[at % columns]].name();
  throw InputError({.kind = ErrorKind::data,
                    .file = header.file,
                    .place = fmt::format("coherence of {}, line {}", pair, block.lines[at / columns / rows] + 1),
                    .problem = fmt::format("{} is not between 0 and 1", value),
                    .remedy = "export the coherences again, or leave them out"});
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
  if (block.size() > 0) do_read_variance(block, out);
}

void FrfSource::read_coherence(const Block& block, std::span<double> out) {
  assert(header_.noise == NoiseRecord::coherence && out.size() == block.size());
  if (block.size() == 0) return;
  do_read_coherence(block, out);
  const auto wrong = std::find_if(out.begin(), out.end(), [](double value) { return value < 0.0 || value > 1.0 + rounding; });
  if (wrong != out.end()) refuse_coherence(header_, block, static_cast<std::size_t>(wrong - out.begin()), *wrong);
}

std::unique_ptr<FrfSource> from_memory(FrfSet set) { return std::make_unique<MemorySource>(std::move(set)); }

FrfSet load(FrfSource& source) {
  const FrfHeader& header = source.header();
  const auto indices = [](std::size_t count) {
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  };
  const auto lines = indices(header.lines());
  const auto responses = indices(header.response.size());
  const auto references = indices(header.reference.size());
  const Block block{lines, responses, references};
  FrfSet set{.header = header, .values = std::vector<Complex>(block.size()), .variance = {}, .coherence = {}};
  source.read(block, set.values);
  if (header.noise == NoiseRecord::variance) {
    set.variance.resize(block.size());
    source.read_variance(block, set.variance);
  }
  if (header.noise == NoiseRecord::coherence) {
    set.coherence.resize(block.size());
    source.read_coherence(block, set.coherence);
  }
  return set;
}

}  // namespace jointid::frf
