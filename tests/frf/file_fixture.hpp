#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "frf/set/frf_source.hpp"
#include "tests/test_folder.hpp"

namespace jointid::frf {

/// With a folder of its own.
class FileTest : public ::testing::Test {
 protected:
  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  std::filesystem::path write_file(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

  std::size_t files_in_folder() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

  TestFolder folder_;
};

/// Lets files grow to `bytes` only, as a full disk does, while it lives.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit small{bytes, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() { ::setrlimit(RLIMIT_FSIZE, &old_); }

 private:
  rlimit old_{};
};

/// Message of the InputError that `act` throws, or a text that no test expects.
template <class Act>
std::string message_of(Act&& act, ErrorKind kind = ErrorKind::data) {
  try {
    act();
  } catch (const InputError& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    return error.what();
  }
  return "nothing was thrown";
}

inline std::vector<Dof> dofs(const std::vector<std::string>& names) {
  std::vector<Dof> out;
  for (const std::string& name : names) out.push_back(Dof::parse(name));
  return out;
}

/// A set of random size with random signs and directions, about one entry in ten not measured, and 0 Hz as
/// its first line when `from_zero`.
inline FrfSet random_set(std::mt19937& random, Quantity quantity, NoiseRecord noise, bool from_zero = false) {
  std::uniform_int_distribution<int> extent(1, 7);
  std::normal_distribution<double> normal;
  std::bernoulli_distribution missing(0.1);
  FrfSet set;
  FrfHeader& header = set.header;
  header.quantity = quantity;
  header.noise = noise;
  header.averages = noise == NoiseRecord::coherence ? 10.0 : 0.0;
  const auto some_dofs = [&] {
    std::vector<Dof> out;
    for (int i = extent(random); i > 0; --i) {
      out.push_back(
          {i * 1000 + 7, static_cast<Direction>(1 + extent(random) % 6), extent(random) % 2 ? 1 : -1});
    }
    return out;
  };
  for (int i = 0, lines = 3 * extent(random); i < lines; ++i)
    header.frequency_hz.push_back(12.5 * (from_zero ? i : i + 1));
  header.response = some_dofs();
  header.reference = some_dofs();
  header.nodes = {{1, {0.0, 0.5, -1.25}}, {9'999'999'999, {1.0, 2.0, 3.0}}};
  const std::size_t size = header.lines() * header.entries();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < size; ++i) {
    const bool gap = missing(random);
    set.values.push_back(gap ? Complex{nan, nan} : Complex{1e-6 * normal(random), 1e-6 * normal(random)});
    if (noise == NoiseRecord::variance) {
      set.variance.push_back({std::exp(normal(random)) * 1e-14, std::exp(normal(random)) * 1e-15});
    }
    if (noise == NoiseRecord::coherence) set.coherence.push_back(1.0 / (1.0 + std::exp(normal(random))));
  }
  return set;
}

/// Equal to `relative` of the magnitude, or both not measured.
inline bool near(Complex a, Complex b, double relative) {
  if (std::isnan(a.real()) || std::isnan(b.real())) return std::isnan(a.real()) && std::isnan(b.real());
  return std::abs(a - b) <= relative * std::abs(b);
}

/// Everything of two sets is the same, values and noise to `relative`. Lines at 0 Hz of a mobility or an
/// accelerance read as not measured.
inline void expect_same(const FrfSet& read, const FrfSet& written, double relative) {
  const FrfHeader& a = read.header;
  const FrfHeader& b = written.header;
  EXPECT_EQ(a.frequency_hz, b.frequency_hz);
  EXPECT_EQ(a.response, b.response);
  EXPECT_EQ(a.reference, b.reference);
  EXPECT_EQ(a.quantity, b.quantity);
  EXPECT_EQ(a.noise, b.noise);
  EXPECT_EQ(a.averages, b.averages);
  EXPECT_EQ(read.coherence, written.coherence);
  ASSERT_EQ(read.values.size(), written.values.size());
  ASSERT_EQ(read.variance.size(), written.variance.size());
  for (std::size_t i = 0; i < read.values.size(); ++i) {
    const bool lost = b.quantity != Quantity::receptance && b.frequency_hz[i / b.entries()] == 0.0;
    const Complex nan{std::numeric_limits<double>::quiet_NaN(), 0.0};
    EXPECT_TRUE(near(read.values[i], lost ? nan : written.values[i], relative)) << "value " << i;
    if (read.variance.empty()) continue;
    EXPECT_TRUE(near(read.variance[i], lost ? nan : written.variance[i], relative)) << "variance " << i;
  }
}

inline constexpr Quantity all_quantities[] = {Quantity::receptance, Quantity::mobility,
                                              Quantity::accelerance};
inline constexpr NoiseRecord all_noise_records[] = {NoiseRecord::none, NoiseRecord::variance,
                                                    NoiseRecord::coherence};

}  // namespace jointid::frf
