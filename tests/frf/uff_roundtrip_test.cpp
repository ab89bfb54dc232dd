#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "frf/uff/uff_file.hpp"
#include "uff_samples.hpp"

namespace jointid::frf {
namespace {

using namespace samples;
using testing::AllOf;
using testing::HasSubstr;

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

class RandomSet {
 public:
  explicit RandomSet(unsigned seed) : random_(seed) {}

  FrfSet operator()(Quantity quantity) {
    FrfSet set;
    axis(set.header.frequency_hz);
    dofs(set.header.response);
    dofs(set.header.reference);
    set.header.quantity = quantity;
    for (std::size_t i = 0; i < pick(3); ++i) {
      set.header.nodes.push_back(
          {static_cast<std::int64_t>(i) + 1, {uniform(), 1e3 * uniform(), -1e-5 * uniform()}});
    }
    set.values.resize(set.header.lines() * set.header.entries());
    for (Complex& value : set.values)
      value = Complex(uniform() - 0.5, uniform() - 0.5) * std::pow(10.0, 20.0 * uniform() - 15.0);
    if (pick(3) == 0) coherences(set);
    if (set.header.entries() > 1 && pick(2) == 0) leave_out(set, pick(set.header.entries()));
    if (quantity != Quantity::receptance && set.header.frequency_hz[0] == 0.0) {
      for (std::size_t i = 0; i < set.header.entries(); ++i) set.values[i] = {not_measured, not_measured};
    }
    return set;
  }

 private:
  double uniform() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  std::size_t pick(std::size_t count) { return random_() % count; }

  /// Even from 0 Hz, even from anywhere, or uneven.
  void axis(std::vector<double>& lines) {
    const double step = 0.01 + 10.0 * uniform();
    const std::size_t kind = pick(3);
    const double first = kind == 0 ? 0.0 : 1000.0 * uniform();
    const std::size_t count = 1 + pick(40);
    for (std::size_t i = 0; i < count; ++i) {
      lines.push_back(first + step * (static_cast<double>(i) + (kind == 2 ? 0.4 * uniform() : 0.0)));
    }
  }

  void dofs(std::vector<Dof>& dofs) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Dof dof{.node = static_cast<std::int64_t>(i == 3 ? 9'999'999'999u : pick(3)),
                    .direction = static_cast<Direction>(1 + pick(6)),
                    .sign = pick(2) == 0 ? -1 : +1};
      if ((dofs.empty() || pick(2) == 0) && find_coordinate(dofs, dof) == npos) dofs.push_back(dof);
    }
  }

  void coherences(FrfSet& set) {
    set.header.noise = NoiseRecord::coherence;
    set.header.averages = static_cast<double>(1 + pick(50));
    for (std::size_t i = 0; i < set.values.size(); ++i) set.coherence.push_back(uniform());
  }

  static void leave_out(FrfSet& set, std::size_t entry) {
    for (std::size_t i = 0; i < set.header.lines(); ++i)
      set.values[i * set.header.entries() + entry] = {not_measured, not_measured};
  }

  std::mt19937 random_;
};

/// Compares by DOF: a DOF none of whose FRFs was measured does not come back, and the order may change.
void expect_same_set(const FrfSet& written, const FrfSet& read, double tolerance) {
  ASSERT_EQ(read.header.lines(), written.header.lines());
  for (std::size_t i = 0; i < read.header.lines(); ++i) {
    EXPECT_NEAR(read.header.frequency_hz[i], written.header.frequency_hz[i], 1e-5);
  }
  for (std::size_t r = 0; r < written.header.response.size(); ++r) {
    for (std::size_t c = 0; c < written.header.reference.size(); ++c) {
      const std::size_t read_r = find_coordinate(read.header.response, written.header.response[r]);
      const std::size_t read_c = find_coordinate(read.header.reference, written.header.reference[c]);
      for (std::size_t i = 0; i < read.header.lines(); ++i) {
        const Complex expected = written.values[written.index(i, r, c)];
        if (std::isnan(expected.real())) {
          if (read_r != npos && read_c != npos) {
            EXPECT_TRUE(std::isnan(read.values[read.index(i, read_r, read_c)].real()));
          }
          continue;
        }
        ASSERT_NE(read_r, npos);
        ASSERT_NE(read_c, npos);
        EXPECT_EQ(read.header.response[read_r], written.header.response[r]);
        EXPECT_EQ(read.header.reference[read_c], written.header.reference[c]);
        const Complex value = read.values[read.index(i, read_r, read_c)];
        EXPECT_LE(std::abs(value.real() - expected.real()), tolerance * std::abs(expected.real()));
        EXPECT_LE(std::abs(value.imag() - expected.imag()), tolerance * std::abs(expected.imag()));
        if (!written.coherence.empty()) {
          EXPECT_NEAR(read.coherence[read.index(i, read_r, read_c)],
                      written.coherence[written.index(i, r, c)], tolerance);
        }
      }
    }
  }
}

bool anything_measured(const FrfSet& set) {
  return std::any_of(set.values.begin(), set.values.end(),
                     [](const Complex& value) { return !std::isnan(value.real()); });
}

TEST(UffRoundTrip, RandomSets) {
  int sets = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    for (const Quantity quantity : {Quantity::receptance, Quantity::mobility, Quantity::accelerance}) {
      const FrfSet set = RandomSet(seed)(quantity);
      if (!anything_measured(set)) continue;
      for (const bool binary : {true, false}) {
        SCOPED_TRACE(testing::Message()
                     << "seed " << seed << ", " << name(quantity) << (binary ? ", binary" : ", text"));
        const TemporaryUff file;
        write_uff(set, file, {.binary = binary, .quantity = quantity});
        const FrfSet read = load(*open_uff(file));
        EXPECT_EQ(read.header.quantity, quantity);
        EXPECT_EQ(read.header.noise, set.header.noise);
        EXPECT_EQ(read.header.averages, set.header.averages);
        ASSERT_EQ(read.header.nodes.size(), set.header.nodes.size());
        for (std::size_t i = 0; i < read.header.nodes.size(); ++i) {
          EXPECT_EQ(read.header.nodes[i].position, set.header.nodes[i].position);
        }
        expect_same_set(set, read, binary ? 1e-15 : 1e-11);
        ++sets;
      }
    }
  }
  EXPECT_GT(sets, 600);
}

FrfSet small_set() {
  FrfSet set;
  set.header.frequency_hz = {0.0, 1.0, 2.0};
  set.header.response = {Dof::parse("1:-X"), Dof::parse("2:+RZ")};
  set.header.reference = {Dof::parse("1:+X")};
  set.values = {{1.0, 0.0}, {2.0, 0.5}, {3.0, 0.0}, {4.0, 1.0}, {5.0, 0.0}, {6.0, 2.0}};
  return set;
}

TEST(UffRoundTrip, ReceptancesInBinaryAreExact) {
  const TemporaryUff file;
  write_uff(small_set(), file);
  EXPECT_EQ(load(*open_uff(file)).values, small_set().values);
}

/// A set of binary FRFs, and its file.
struct Kept {
  FrfSet set;
  TemporaryUff file;

  Kept(std::size_t lines, std::size_t responses, std::size_t references, const UffWriteOptions& options = {}) {
    for (std::size_t i = 0; i < lines; ++i) set.header.frequency_hz.push_back(10.0 + static_cast<double>(i));
    for (std::size_t i = 0; i < responses; ++i)
      set.header.response.push_back({static_cast<std::int64_t>(i) + 1, Direction::y, 1});
    set.header.reference.assign(set.header.response.begin(),
                                set.header.response.begin() + static_cast<std::ptrdiff_t>(references));
    set.values.resize(lines * responses * references);
    for (std::size_t i = 0; i < set.values.size(); ++i) set.values[i] = {static_cast<double>(i), -0.5 * static_cast<double>(i)};
    write_uff(set, file, options);
  }
  /// Whether lines of some responses come as they were written.
  bool gives(FrfSource& source, std::size_t first, std::size_t end, const std::vector<std::size_t>& responses) const {
    std::vector<std::size_t> lines(end - first), references(set.header.reference.size());
    std::iota(lines.begin(), lines.end(), first);
    std::iota(references.begin(), references.end(), std::size_t{0});
    const Block block{lines, responses, references};
    std::vector<Complex> found(block.size());
    source.read(block, found);
    std::size_t at = 0;
    for (const std::size_t line : lines) {
      for (const std::size_t r : responses) {
        for (const std::size_t c : references) {
          if (found[at++] != set.values[(line * set.header.response.size() + r) * references.size() + c]) return false;
        }
      }
    }
    return true;
  }
};

/// Text of more than 16 MB of numbers, which go through a temporary file.
TEST(UffRoundTrip, LongTextInAnyOrderIsWhatWasWritten) {
  const Kept kept(11'000, 10, 10, {.binary = false});
  const std::vector<std::size_t> some = {1, 4, 9};
  const auto source = open_uff(kept.file);
  std::mt19937_64 random(1);
  for (int i = 0; i < 40; ++i) {
    const std::size_t first = random() % 10'900, end = first + 1 + random() % 100;
    ASSERT_TRUE(kept.gives(*source, first, end, some)) << first << " to " << end;
    ASSERT_TRUE(kept.gives(*source, end, std::min<std::size_t>(end + 7, 11'000), some)) << first << " to " << end;
  }
}

/// In order, back and forth, with gaps and overlaps, of changing responses: what is read ahead never shows.
TEST(UffRoundTrip, BlocksInAnyOrderAreWhatWasWritten) {
  const Kept kept(60, 3, 2);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    const auto source = open_uff(kept.file);
    std::size_t at = 0;
    for (int i = 0; i < 60; ++i) {
      if (random() % 3 == 0 || at == 60) at = random() % 60;  // else where the last one ended
      const std::size_t end = at + 1 + random() % std::min<std::size_t>(60 - at, 9);
      const std::vector<std::size_t> all = {0, 1, 2}, one = {random() % 3};
      ASSERT_TRUE(kept.gives(*source, at, end, random() % 4 == 0 ? one : all)) << "seed " << seed << ": " << at << " to " << end;
      at = end;
    }
  }
}

/// More lines than are read ahead of so many FRFs, after and before a few.
TEST(UffRoundTrip, ManyLinesOfManyFrfsAreWhatWasWritten) {
  const Kept kept(1150, 50, 40);
  std::vector<std::size_t> all(50);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto source = open_uff(kept.file);
  EXPECT_TRUE(kept.gives(*source, 0, 1100, all));
  EXPECT_TRUE(kept.gives(*source, 1100, 1110, all));
  EXPECT_TRUE(kept.gives(*source, 0, 2, all));
  EXPECT_TRUE(kept.gives(*source, 2, 4, all));
  EXPECT_TRUE(kept.gives(*source, 4, 1150, all));
}

TEST(UffRoundTrip, ZeroHertzOfAnAcceleranceIsNotMeasured) {
  FrfSet set = small_set();
  set.values[0] = set.values[1] = {not_measured, not_measured};
  const TemporaryUff file;
  write_uff(set, file, {.binary = false, .quantity = Quantity::accelerance});
  const FrfSet read = load(*open_uff(file));
  EXPECT_TRUE(std::isnan(read.values[0].real()));
  EXPECT_NEAR(read.values[2].real(), 3.0, 1e-11);
  EXPECT_EQ(read_uff58(file, 0).values[0], Complex());
  EXPECT_THAT(error_of([&] { write_uff(set, file); }), HasSubstr("write HDF5"));
}

TEST(UffRoundTrip, PartlyMeasuredIsAnErrorThatLeavesNoFile) {
  FrfSet set = small_set();
  set.values[2] = {not_measured, 0.0};
  const TemporaryUff file;
  const std::filesystem::path path = file.path().string() + ".new";
  EXPECT_THAT(error_of([&] { write_uff(set, path); }),
              AllOf(HasSubstr("response 1:-X and reference 1:+X"), HasSubstr("1 of 3 lines"),
                    HasSubstr("write HDF5")));
  for (const auto& entry : std::filesystem::directory_iterator(path.parent_path())) {
    EXPECT_THAT(entry.path().string(), Not(HasSubstr(path.filename().string())));
  }
  EXPECT_THAT(error_of([&] { write_uff(small_set(), "/nowhere/at/all.uff"); }), HasSubstr("cannot be written"));
}

TEST(UffRoundTrip, NothingMeasured) {
  FrfSet set = small_set();
  for (Complex& value : set.values) value = {not_measured, not_measured};
  const TemporaryUff file;
  EXPECT_THAT(error_of([&] { write_uff(set, file); }), HasSubstr("no measured FRF"));
}

TEST(UffRoundTrip, EvenAxesStayEven) {
  for (const double step : {1.0, 0.390625, 1.0 / 3.0, 12.8}) {
    FrfSet set = small_set();
    set.header.response.resize(1);
    set.header.frequency_hz.clear();
    for (int i = 0; i < 2000; ++i) set.header.frequency_hz.push_back(400.0 + i * step);
    set.values.assign(2000, {1.0, 1.0});
    const TemporaryUff file;
    write_uff(set, file);
    EXPECT_LT(std::filesystem::file_size(file), 2000u * 16u + 3000u) << step;  // no abscissas
    const auto source = open_uff(file);
    EXPECT_NEAR(source->header().frequency_hz.back(), set.header.frequency_hz.back(), 1e-6 * step);
  }
}

TEST(UffRoundTrip, Summary) {
  const TemporaryUff file;
  write_uff(small_set(), file, {.binary = true, .quantity = Quantity::accelerance});
  const UffSummary summary = summarize_uff(file);
  ASSERT_EQ(summary.datasets.size(), 3u);
  EXPECT_EQ(summary.datasets[2].dataset, "58b");
  EXPECT_EQ(summary.datasets[2].count, 2u);
  const UffSummary::Function& function = summary.functions[1];
  EXPECT_EQ(function.function, "frequency response function");
  EXPECT_EQ(function.response, "2:+RZ");
  EXPECT_EQ(function.points, 3u);
  EXPECT_EQ(function.quantity, "acceleration / excitation force");
  EXPECT_EQ(function.unit, "rad/s^2 / N");
}

}  // namespace
}  // namespace jointid::frf
