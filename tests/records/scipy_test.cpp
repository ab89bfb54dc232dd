#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <span>

#include "records/estimate/measured_frfs.hpp"
#include "records/file/read_record.hpp"
#include "scipy_reference.hpp"
#include "tests/require.hpp"

namespace jointid::records {
namespace {

const std::filesystem::path data = JOINTID_EXTERNAL_DATA;

std::vector<Record> hammer_records() {
  std::vector<Record> out;
  for (int k = 1; k <= 5; ++k) {
    RecordOptions options{{parse_channel("2=1:+Z N"), parse_channel("3=2:+Z m")}, "1", std::nullopt};
    out.push_back(read_records(data / ("hammer-repeats/measurements_" + std::to_string(k) + ".npy"), options).front());
  }
  return out;
}

Record shaker_record() {
  return read_records(data / "siso-coherence/case1.mat",
                      {{parse_channel("Time_chan_1=1:+Z N"), parse_channel("Time_chan_2=2:+Z m")}, {}, 1280.0})
      .front();
}

/// Read as displacements, so that nothing is converted.
void expect_reference(const std::vector<Record>& records, FrfOptions options, std::span<const ReferenceLine> reference) {
  options.estimator = Estimator::h1;
  const MeasuredFrfs h1 = make_frfs(records, options);
  options.estimator = Estimator::h2;
  const MeasuredFrfs h2 = make_frfs(records, options);
  options.estimator = Estimator::hv;
  const MeasuredFrfs hv = make_frfs(records, options);
  for (const ReferenceLine& line : reference) {
    EXPECT_NEAR(h1.set.header.frequency_hz[line.line], line.hz, 1e-12 * line.hz);
    EXPECT_LE(std::abs(h1.set.values[line.line] - line.h1), 1e-12 * std::abs(line.h1)) << line.hz;
    EXPECT_LE(std::abs(h2.set.values[line.line] - line.h2), 1e-12 * std::abs(line.h2)) << line.hz;
    EXPECT_NEAR(h1.coherence[line.line], line.coherence, 1e-12);
    const double size = std::sqrt(std::abs(line.h1) * std::abs(line.h2));
    EXPECT_LE(std::abs(hv.set.values[line.line] - std::polar(size, std::arg(line.h1))), 1e-12 * size) << line.hz;
  }
}

class Scipy : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(data)) JOINTID_SKIP("no measured data at " << data);
  }
};

TEST_F(Scipy, HammerRepeatsGiveItsEstimatesAndCoherence) { expect_reference(hammer_records(), {}, hammer_reference); }

TEST_F(Scipy, WelchSegmentsGiveItsEstimatesAndCoherence) {
  FrfOptions options;
  options.segments = {.block_s = 1024 / 1280.0};
  options.remove_mean = true;
  expect_reference({shaker_record()}, options, shaker_reference);
}

/// All lines of the shaker's record by the definition of the transform, in long double.
TEST_F(Scipy, AllLinesAreThoseOfTheDefinition) {
  const Record record = shaker_record();
  FrfOptions options;
  options.segments = {.block_s = 512 / 1280.0, .overlap = 0.0};
  const MeasuredFrfs made = make_frfs({&record, 1}, options);
  constexpr std::size_t n = 512;
  std::vector<std::complex<long double>> turn;
  for (std::size_t k = 0; k < n; ++k)
    turn.push_back(std::polar(1.0L, -2.0L * std::numbers::pi_v<long double> * static_cast<long double>(k) / n));
  const auto spectrum = [&](const std::vector<double>& x, std::size_t first, std::size_t line) {
    std::complex<long double> sum = 0.0L;
    for (std::size_t t = 0; t < n; ++t)
      sum += (0.5L - 0.5L * turn[t].real()) * static_cast<long double>(x[first + t]) * turn[t * line % n];
    return sum;
  };
  for (std::size_t line = 0; line <= n / 2; ++line) {
    long double ff = 0.0L, xx = 0.0L;
    std::complex<long double> xf = 0.0L;
    for (std::size_t first = 0; first + n <= record.samples(); first += n) {
      const auto f = spectrum(record.channels[0].samples, first, line), x = spectrum(record.channels[1].samples, first, line);
      ff += std::norm(f);
      xx += std::norm(x);
      xf += x * std::conj(f);
    }
    const Complex h1(xf / ff);
    EXPECT_LE(std::abs(made.set.values[line] - h1), 1e-12 * std::abs(h1)) << line;
    EXPECT_NEAR(made.coherence[line], static_cast<double>(std::norm(xf) / (ff * xx)), 1e-12);
  }
}

}  // namespace
}  // namespace jointid::records
