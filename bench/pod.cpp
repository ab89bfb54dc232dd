// Proper orthogonal decomposition of a record of 64 channels, 1,000,000 samples (quick: 50,000) by the streamed QR, beside
// reading such a record from text, and the memory of it. Promised: values to 1e-12 of those that the record was made of,
// decomposing at most as long as reading (both together twice the time of reading), memory below 100 MB however long the record.
#include "series/pod/pod.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "base/temporary_file.hpp"
#include "bench/bench.hpp"
#include "frf/file/columns.hpp"

namespace {

using namespace jointid;
using namespace jointid::series;

constexpr std::size_t channels = 64;

/// Ten standing waves of whole numbers of turns, made block by block.
class Waves {
 public:
  explicit Waves(std::size_t samples) : samples_(samples), shapes_(at(10), at(channels)) {
    for (std::size_t k = 0; k < channels; ++k) {
      for (std::size_t w = 0; w < 10; ++w) {  // a discrete cosine basis: orthonormal
        shapes_(at(w), at(k)) = std::sqrt(2.0 / channels) * std::cos(std::numbers::pi * (static_cast<double>(k) + 0.5) *
                                                                     static_cast<double>(w + 1) / channels);
      }
    }
  }
  std::size_t operator()(Samples& block) {
    const std::size_t count = std::min(static_cast<std::size_t>(block.rows()), samples_ - next_);
    Samples waves(at(count), at(10));
    for (std::size_t i = 0; i < count; ++i) {
      const double turns = static_cast<double>(next_ + i) / static_cast<double>(samples_);
      for (std::size_t w = 0; w < 10; ++w) {
        waves(at(i), at(w)) =
            std::pow(0.3, static_cast<double>(w)) * std::cos(2.0 * std::numbers::pi * static_cast<double>(w + 3) * turns);
      }
    }
    block.topRows(at(count)) = waves * shapes_;
    next_ += count;
    return count;
  }

 private:
  std::size_t samples_, next_ = 0;
  Samples shapes_;
};

double reading_seconds(std::size_t samples) {
  const TemporaryFile text(std::filesystem::temp_directory_path() / "jointid-bench-pod.csv");  // never committed
  Samples block(at(samples), at(channels));
  Waves waves(samples);
  waves(block);
  {
    std::ofstream file(text.path());
    for (Eigen::Index i = 0; i < block.rows(); ++i) {
      std::string line;
      for (std::size_t k = 0; k < channels; ++k) line += fmt::format("{}{}", k > 0 ? "," : "", block(i, at(k)));
      file << line << "\n";
    }
  }
  std::size_t columns = 0;
  const double seconds = bench::seconds([&] { columns = frf::read_columns(text.path()).columns.size(); });
  return columns == channels ? seconds : std::nan("");
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t samples = line.count(0, 1'000'000, 50'000), part = std::min<std::size_t>(samples, 20'000);
  Pod found;
  Waves waves(samples), again(samples);
  Samples block(4096, at(channels));
  const double making = bench::seconds([&] {
    while (again(block) > 0) {
    }
  });
  const double all = bench::seconds([&] { found = pod(record_triangle(channels, [&](Samples& b) { return waves(b); })); });
  const double memory = bench::peak_megabytes();
  double worst = 0.0;
  for (int w = 0; w < 10; ++w) worst = std::max(worst, std::abs(found.values(w) - 0.5 * std::pow(0.09, w)));
  const double per_sample = (all - making) / static_cast<double>(samples);
  const double reading = reading_seconds(part) / static_cast<double>(part);
  fmt::print("{} samples of {} channels: decomposed in {:.2f} s, {:.2f} us a sample; peak {:.0f} MB\n", samples, channels,
             all - making, 1e6 * per_sample, memory);
  fmt::print("reading text: {:.2f} us a sample; reading and decomposing {:.2f} times reading\n", 1e6 * reading,
             1.0 + per_sample / reading);
  fmt::print("largest error of a value: {:.1e}\n", worst);
  promises.at_most("values less the true ones", worst, 1e-12);
  promises.at_most("memory, MB", memory, 100.0);
  promises.speed_at_most("reading and decomposing, times reading", 1.0 + per_sample / reading, 2.0);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SAMPLES]", measure); }
