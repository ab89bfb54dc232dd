#include "frf/set/frf_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

#include "base/kernel.hpp"
#include "frf/set/gather.hpp"

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
  bool has_covariance() const override { return set_->has_covariance(); }
  FactorShape factor_shape() const override { return set_->factor.shape(); }
  bool has_reference_correlation() const override { return !set_->reference_correlation.empty(); }

 private:
  void do_read_reference_correlation(std::span<const std::size_t> lines, std::span<const std::size_t> references,
                                     std::span<Complex> out) override {
    gather({lines, references, references}, set_->reference_correlation, header_.reference.size(), out);
  }

  void do_read_covariance(const Block& pairs, std::span<Complex> out) override {
    if (set_->factor.any()) return FrfSource::do_read_covariance(pairs, out);
    gather(pairs, set_->covariance, pair_count(header_.response.size()), out);
  }

  void do_read_factor(const Block& block, std::span<Complex> rows, std::span<double> diagonal) override {
    std::size_t next = 0;
    for (const std::size_t line : block.lines) {
      for (const std::size_t r : block.responses) {
        for (std::size_t k = 0; k < set_->factor.rank; ++k) {
          const Complex* row = set_->factor.rows.data() + set_->index(line, r, 0) * set_->factor.rank + k * header_.reference.size();
          for (const std::size_t c : block.references) rows[next++] = row[c];
        }
      }
    }
    if (!diagonal.empty()) gather(block, set_->factor.diagonal, header_.response.size(), diagonal);
  }

  /// Of an array with so many rows a line.
  template <class T>
  void gather(const Block& block, const std::vector<T>& from, std::size_t rows, std::span<T> out) const {
    gather_elements(LineArray<T>{from, rows, header_.reference.size()}, block.lines, block.responses, block.references, out);
  }

  void do_read(const Block& block, std::span<Complex> out) override {
    gather(block, set_->values, header_.response.size(), out);
  }
  void do_read_variance(const Block& block, std::span<Complex> out) override {
    gather(block, set_->variance, header_.response.size(), out);
  }
  void do_read_coherence(const Block& block, std::span<double> out) override {
    gather(block, set_->coherence, header_.response.size(), out);
  }

  std::shared_ptr<const FrfSet> set_;
};

/// Coherences of 1 may come from averages of single precision.
constexpr double correlation_rounding = 1e-5;

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
  if (!(value.real() < 0.0) && !(std::abs(value.imag()) > correlation_rounding * value.real())) return;
  fail(header, fmt::format("covariance of {}/{}, line {}", header.response[r].name(), header.reference[c].name(), line + 1),
       fmt::format("{:g} + {:g}i is no variance", value.real(), value.imag()),
       "export the covariances again, or leave them out");
}

}  // namespace

void FrfSource::place_nodes(const std::vector<Node>& nodes) {
  for (const Node& node : nodes) {
    const auto known = std::ranges::find(header_.nodes, node.id, &Node::id);
    if (known == header_.nodes.end())
      header_.nodes.push_back(node);
    else
      known->position = node.position;
  }
}

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
  const auto wrong =
      std::find_if(out.begin(), out.end(), [](double value) { return value < 0.0 || value > 1.0 + correlation_rounding; });
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

void FrfSource::do_read_covariance(const Block& pairs, std::span<Complex> out) {
  if (factor_shape().rank == 0) throw std::logic_error("a source that has covariances must read them");
  form_pairs(pairs, out);
}

void FrfSource::form_pairs(const Block& pairs, std::span<Complex> out) {
  const auto [rank, with_diagonal] = factor_shape();
  std::vector<std::array<std::size_t, 2>> responses;  // r and s of each pair
  std::map<std::size_t, std::size_t> place;           // of a response among those that are read
  std::size_t r = 0;
  for (const std::size_t pair : pairs.responses) {  // ascending
    while (pair_count(r + 1) <= pair) ++r;
    responses.push_back({r, pair - pair_count(r)});
    for (const std::size_t response : responses.back()) place[response] = 0;
  }
  std::vector<std::size_t> some;
  for (auto& [response, at] : place) {
    at = some.size();
    some.push_back(response);
  }
  const Block block{pairs.lines, some, pairs.references};
  const std::size_t columns = pairs.references.size();
  std::vector<Complex> rows(block.size() * rank);
  std::vector<double> diagonal(with_diagonal ? block.size() : 0);
  read_factor(block, rows, diagonal);
  Complex* next = out.data();
  for (std::size_t l = 0; l < pairs.lines.size(); ++l, next += responses.size() * columns) {
    Complex* sums = next;
    for (const auto& [first, second] : responses) {
      const std::size_t of_first = l * some.size() + place[first], of_second = l * some.size() + place[second];
      const Complex *a = rows.data() + of_first * rank * columns, *b = rows.data() + of_second * rank * columns;
      for (std::size_t c = 0; c < columns; ++c, ++sums) {
        *sums = with_diagonal && first == second ? diagonal[of_first * columns + c] : 0.0;
        for (std::size_t k = 0; k < rank; ++k) *sums += product(a[k * columns + c], std::conj(b[k * columns + c]));
      }
    }
  }
}

void FrfSource::read_factor(const Block& block, std::span<Complex> rows, std::span<double> diagonal) {
  const FactorShape shape = factor_shape();
  assert(shape.rank > 0 && rows.size() == block.size() * shape.rank && diagonal.size() == (shape.diagonal ? block.size() : 0));
  if (block.size() == 0) return;
  do_read_factor(block, rows, diagonal);
  const std::size_t columns = block.references.size();
  const auto wrong = [&](std::size_t at, const std::string& problem) {
    fail(header_, "covariance of " + place_text(header_, block, at), problem, "export the covariances again, or leave them out");
  };
  for (std::size_t at = 0; at < block.size(); ++at) {
    std::size_t unknown = 0, infinite = 0;
    for (std::size_t k = 0; k < shape.rank; ++k) {
      const Complex value = rows[(at / columns * shape.rank + k) * columns + at % columns];
      unknown += std::isnan(value.real()) || std::isnan(value.imag()) ? 1U : 0U;
      infinite += std::isinf(value.real()) || std::isinf(value.imag()) ? 1U : 0U;
    }
    if (shape.diagonal) {
      const double d = diagonal[at];
      if (d < 0.0 || std::isinf(d)) wrong(at, fmt::format("its diagonal part {:g} is no variance", d));
      unknown += std::isnan(d) ? 1U : 0U;
    }
    if (infinite > 0) wrong(at, "its factor has an infinite number");
    const std::size_t all = shape.rank + (shape.diagonal ? 1 : 0);
    if (unknown > 0 && unknown < all) wrong(at, fmt::format("{} of the {} numbers of its factor and diagonal are NaN", unknown, all));
  }
}

void FrfSource::read_reference_correlation(std::span<const std::size_t> lines, std::span<const std::size_t> references,
                                           std::span<Complex> out) {
  const std::size_t size = references.size();
  assert(has_reference_correlation() && out.size() == lines.size() * size * size);
  if (out.empty()) return;
  do_read_reference_correlation(lines, references, out);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const Complex* of = out.data() + l * size * size;
    for (std::size_t m = 0; m < size; ++m) {
      for (std::size_t n = 0; n <= m; ++n) {
        const Complex value = of[m * size + n];
        if (std::isnan(value.real()) || std::isnan(value.imag())) continue;
        const bool right = m == n ? std::abs(value - 1.0) <= correlation_rounding
                                  : std::abs(value) <= 1.0 + correlation_rounding &&
                                        std::abs(value - std::conj(of[n * size + m])) <= correlation_rounding;
        if (right) continue;
        fail(header_,
             fmt::format("correlation of references {} and {}, line {}", header_.reference[references[m]].name(),
                         header_.reference[references[n]].name(), lines[l] + 1),
             fmt::format("{:g} + {:g}i is none: it must be Hermitian, at most 1, and 1 of a reference with itself", value.real(),
                         value.imag()),
             "export it again, or leave it out");
      }
    }
  }
}

void FrfSource::do_read_reference_correlation(std::span<const std::size_t>, std::span<const std::size_t>, std::span<Complex>) {
  throw std::logic_error("a source whose references are correlated must state how");
}

void FrfSource::do_read_factor(const Block&, std::span<Complex>, std::span<double>) {
  throw std::logic_error("a source whose covariances have a factor must read it");
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
  const auto lines = indices(header.lines()), responses = indices(header.response.size()), references = indices(header.reference.size());
  if (source.has_reference_correlation()) {
    set.reference_correlation.resize(lines.size() * references.size() * references.size());
    source.read_reference_correlation(lines, references, set.reference_correlation);
  }
  if (const FactorShape shape = source.factor_shape(); shape.rank > 0) {
    set.factor.rank = shape.rank;
    set.factor.rows.resize(set.values.size() * shape.rank);
    set.factor.diagonal.resize(shape.diagonal ? set.values.size() : 0);
    source.read_factor({lines, responses, references}, set.factor.rows, set.factor.diagonal);
    return set;
  }
  set.covariance.resize(header.lines() * pair_count(header.response.size()) * header.reference.size());
  source.read_covariance_pairs(lines, set.covariance);
  return set;
}

std::vector<Complex> covariance_pairs(const FrfSet& set) {
  if (!set.factor.any()) return set.covariance;
  const auto source = from_shared(std::shared_ptr<const FrfSet>(std::shared_ptr<void>(), &set));
  std::vector<Complex> out(set.header.lines() * pair_count(set.header.response.size()) * set.header.reference.size());
  source->read_covariance_pairs(indices(set.header.lines()), out);
  return out;
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
