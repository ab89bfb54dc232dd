#include "frf/file/memory_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "frf/set/gather.hpp"
#include "frf/set/scaled_source.hpp"

namespace jointid::frf {
namespace {

void require_length(const FrfHeader& header, const char* what, std::size_t length, std::size_t expected, bool may_be_empty) {
  if (length == expected || (may_be_empty && length == 0)) return;
  fail(header, what, std::to_string(length) + " numbers where lines, responses and references make " + std::to_string(expected),
       "give an array of the shape [lines, responses, references]");
}

void validate(const FrfArrays& arrays) {
  const FrfHeader& header = arrays.header;
  validate(header);
  const std::size_t lines = header.lines(), columns = header.reference.size(), entries = lines * header.entries();
  require_length(header, "frfs", arrays.values.size(), entries, false);
  require_length(header, "variance", arrays.variance.size(), entries, header.noise != NoiseRecord::variance);
  require_length(header, "coherence", arrays.coherence.size(), entries, header.noise != NoiseRecord::coherence);
  require_length(header, "covariance", arrays.covariance.size(), lines * pair_count(header.response.size()) * columns, true);
  require_length(header, "covariance_factor", arrays.factor.size(), entries * arrays.rank, false);
  require_length(header, "covariance_diagonal", arrays.factor_diagonal.size(), entries, true);
  if (arrays.rank > 0 && !arrays.covariance.empty())
    fail(header, "covariance", "there are covariances and a factor of them", "give one of both");
  if (arrays.rank == 0 && !arrays.factor_diagonal.empty())
    fail(header, "covariance_diagonal", "it is given without a factor", "give the variances in its place");
  require_length(header, "reference_correlation", arrays.reference_correlation.size(), lines * columns * columns, true);
}

/// Gathers blocks out of the arrays, and makes receptances of them.
class ArraySource final : public FrfSource {
 public:
  explicit ArraySource(std::shared_ptr<const FrfArrays> arrays) : arrays_(std::move(arrays)) {
    validate(*arrays_);
    header_ = arrays_->header;
  }

  bool in_memory() const override { return true; }
  bool has_covariance() const override { return !arrays_->covariance.empty() || arrays_->rank > 0; }
  FactorShape factor_shape() const override { return arrays_->factor_shape(); }
  bool has_reference_correlation() const override { return !arrays_->reference_correlation.empty(); }

 private:
  Complex factor(std::size_t line) const { return to_receptance(header_.quantity, header_.frequency_hz[line]); }

  template <class T>
  LineArray<T> by_lines(std::span<const T> values, std::size_t rows) const {
    return {values, rows, header_.reference.size()};
  }

  void do_read(const Block& block, std::span<Complex> out) override {
    const LineArray<Complex> frfs = by_lines<Complex>(arrays_->values, header_.response.size());
    if (header_.quantity == Quantity::receptance) return gather_elements(frfs, block.lines, block.responses, block.references, out);
    gather_elements(frfs, block.lines, block.responses, block.references, out,
                    [&](Complex value, std::size_t line) { return factor(line) * value; });
  }

  void do_read_variance(const Block& block, std::span<Complex> out) override {
    gather_elements(by_lines<Complex>(arrays_->variance, header_.response.size()), block.lines, block.responses, block.references,
                    out, [&](Complex value, std::size_t line) { return scaled_variance(factor(line), value); });
  }

  void do_read_coherence(const Block& block, std::span<double> out) override {
    gather_elements(by_lines<double>(arrays_->coherence, header_.response.size()), block.lines, block.responses, block.references, out);
  }

  void do_read_factor(const Block& block, std::span<Complex> rows, std::span<double> diagonal) override {
    const std::size_t columns = header_.reference.size(), responses = header_.response.size();
    std::size_t next = 0;
    for (const std::size_t line : block.lines) {
      const double scale = std::abs(factor(line));
      for (const std::size_t r : block.responses) {
        const Complex* const own = arrays_->factor.data() + (line * responses + r) * arrays_->rank * columns;
        for (std::size_t k = 0; k < arrays_->rank; ++k) {
          for (const std::size_t c : block.references) rows[next++] = scale * own[k * columns + c];
        }
      }
    }
    if (diagonal.empty()) return;
    gather_elements(by_lines<double>(arrays_->factor_diagonal, responses), block.lines, block.responses, block.references, diagonal,
                    [&](double value, std::size_t line) { return std::norm(factor(line)) * value; });
  }

  void do_read_covariance(const Block& pairs, std::span<Complex> out) override {
    if (arrays_->rank > 0) return FrfSource::do_read_covariance(pairs, out);
    gather_elements(by_lines<Complex>(arrays_->covariance, pair_count(header_.response.size())), pairs.lines, pairs.responses,
                    pairs.references, out, [&](Complex value, std::size_t line) { return std::norm(factor(line)) * value; });
  }

  void do_read_reference_correlation(std::span<const std::size_t> lines, std::span<const std::size_t> references,
                                     std::span<Complex> out) override {
    gather_elements(by_lines<Complex>(arrays_->reference_correlation, header_.reference.size()), lines, references, references, out);
  }

  std::shared_ptr<const FrfArrays> arrays_;
};

/// The name of a set as that of a file, of none that has a meaning by its ending.
std::string file_name(std::string set) {
  std::ranges::replace(set, '/', '_');
  return set.empty() || set.starts_with('.') || set.ends_with(".toml") ? "set" + set + "_" : set;
}

/// What is in memory under which path. Runs open and close files on threads of their own.
class MemoryFiles {
 public:
  std::filesystem::path add(std::shared_ptr<const FrfArrays> arrays) {
    const std::string name = file_name(arrays->header.file);
    const std::lock_guard lock(mutex_);
    std::filesystem::path path = "/jointid-memory/" + std::to_string(next_++) + "/" + name;
    files_[path] = std::move(arrays);
    return path;
  }

  void remove(const std::filesystem::path& path) {
    std::shared_ptr<const FrfArrays> last;  // whose end may take a while, outside of the lock
    const std::lock_guard lock(mutex_);
    if (auto node = files_.extract(path)) last = std::move(node.mapped());
  }

  std::shared_ptr<const FrfArrays> find(const std::filesystem::path& path) const {
    const std::lock_guard lock(mutex_);
    const auto found = files_.find(path);
    return found == files_.end() ? nullptr : found->second;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::filesystem::path, std::shared_ptr<const FrfArrays>> files_;
  std::size_t next_ = 1;
};

MemoryFiles& memory_files() {
  static MemoryFiles files;
  return files;
}

}  // namespace

std::unique_ptr<FrfSource> from_arrays(std::shared_ptr<const FrfArrays> arrays) {
  return std::make_unique<ArraySource>(std::move(arrays));
}

MemoryFile::MemoryFile(std::shared_ptr<const FrfArrays> arrays) {
  validate(*arrays);
  path_ = memory_files().add(std::move(arrays));
}

MemoryFile::~MemoryFile() { memory_files().remove(path_); }

std::unique_ptr<FrfSource> open_memory_file(const std::filesystem::path& path) {
  auto arrays = memory_files().find(path);
  return arrays ? from_arrays(std::move(arrays)) : nullptr;
}

}  // namespace jointid::frf
