#include "frf/noise/repeats.hpp"

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "frf/set/frf_system.hpp"

namespace jointid::frf {
namespace {

using Runs = std::vector<std::unique_ptr<FrfSource>>;

[[noreturn]] void refuse(const FrfHeader& header, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = header.file,
                    .place = "repeats",
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

bool same_axis(const std::vector<double>& one, const std::vector<double>& two) {
  if (one.size() != two.size()) return false;
  const std::vector<std::size_t> partner = match_lines(one, two);
  for (std::size_t line = 0; line < one.size(); ++line) {
    if (partner[line] != line) return false;
  }
  return true;
}

void require_same(const FrfHeader& first, const FrfHeader& other) {
  const auto differ = [&](const std::string& what) {
    refuse(other, what + " differ from those of " + first.file, "repeats measure the same FRFs: name other tests as files of their own");
  };
  if (!same_axis(first.frequency_hz, other.frequency_hz)) {
    differ("its lines, " + range_text(other.frequency_hz) + ",");
  }
  if (first.response != other.response) differ("its response DOFs");
  if (first.reference != other.reference) differ("its reference DOFs");
  if (first.quantity != other.quantity) differ("its FRFs, of quantity " + name(other.quantity) + ",");
}

/// Mean and sum of squared deviations of what was measured, entry by entry (Welford 1962).
struct Scatter {
  std::vector<double> count;
  std::vector<Complex> mean, squares;

  explicit Scatter(std::size_t size) : count(size, 0.0), mean(size), squares(size) {}

  void add(std::span<const Complex> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isnan(values[i].real()) || std::isnan(values[i].imag())) continue;
      count[i] += 1.0;
      const Complex before = values[i] - mean[i];
      mean[i] += before / count[i];
      const Complex after = values[i] - mean[i];
      squares[i] += Complex(before.real() * after.real(), before.imag() * after.imag());
    }
  }
};

class Repeats final : public FrfSource {
 public:
  explicit Repeats(Runs runs) : runs_(std::move(runs)) {
    header_ = runs_.front()->header();
    header_.file += " and " + std::to_string(runs_.size() - 1) + (runs_.size() == 2 ? " repeat" : " repeats");
    header_.noise = NoiseRecord::variance;
    header_.averages = 0.0;
    header_.repeats = runs_.size();
  }

 private:
  Scatter scatter(const Block& block) {
    Scatter all(block.size());
    std::vector<Complex> values(block.size());
    for (const auto& run : runs_) {
      run->read(block, values);
      all.add(values);
    }
    return all;
  }

  void do_read(const Block& block, std::span<Complex> out) override {
    const Scatter all = scatter(block);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = all.count[i] > 0.0 ? all.mean[i] : Complex(nan, nan);
  }

  void do_read_variance(const Block& block, std::span<Complex> out) override {
    const Scatter all = scatter(block);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double n = all.count[i];
      out[i] = n > 1.0 ? all.squares[i] / (n * (n - 1.0)) : Complex(nan, nan);
    }
  }

  void do_read_coherence(const Block&, std::span<double> out) override {
    std::fill(out.begin(), out.end(), std::numeric_limits<double>::quiet_NaN());
  }

  Runs runs_;
};

}  // namespace

std::unique_ptr<FrfSource> mean_of_repeats(Runs runs) {
  if (runs.size() < 2) {
    refuse(runs.empty() ? FrfHeader() : runs.front()->header(), "one run has no scatter", "give two or more");
  }
  for (std::size_t i = 1; i < runs.size(); ++i) require_same(runs.front()->header(), runs[i]->header());
  return std::make_unique<Repeats>(std::move(runs));
}

}  // namespace jointid::frf
