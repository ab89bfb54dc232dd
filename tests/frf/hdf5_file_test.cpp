#include "frf/hdf5/hdf5_file.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <memory>
#include <numeric>
#include <string>

#include "file_fixture.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "tests/require.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;
using Hdf5File = FileTest;

std::vector<std::size_t> all(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

/// Some of 0 … count − 1, shuffled (or in order).
std::vector<std::size_t> some(std::mt19937& random, std::size_t count, bool ordered) {
  std::vector<std::size_t> indices = all(count);
  std::shuffle(indices.begin(), indices.end(), random);
  indices.resize(std::uniform_int_distribution<std::size_t>(1, count)(random));
  if (ordered) std::sort(indices.begin(), indices.end());
  return indices;
}

/// Reads random blocks of `source` and compares them bit by bit with the whole set.
void expect_blocks_of(const FrfSet& set, FrfSource& source, std::mt19937& random) {
  for (int trial = 0; trial < 10; ++trial) {
    const auto lines = some(random, set.header.lines(), true);
    const auto responses = some(random, set.header.response.size(), trial % 2 == 0);
    const auto references = some(random, set.header.reference.size(), trial % 2 == 0);
    const Block block{lines, responses, references};
    auto whole = from_memory(set);
    std::vector<Complex> expected(block.size());
    std::vector<Complex> got(block.size());
    whole->read(block, expected);
    source.read(block, got);
    for (std::size_t i = 0; i < got.size(); ++i) EXPECT_TRUE(near(got[i], expected[i], 0.0));
    if (set.header.noise == NoiseRecord::coherence) {
      std::vector<double> coherence(block.size());
      std::vector<double> expected_coherence(block.size());
      whole->read_coherence(block, expected_coherence);
      source.read_coherence(block, coherence);
      EXPECT_EQ(coherence, expected_coherence);
    }
  }
}

TEST_F(Hdf5File, KeepsTheAxesOfNodes) {
  std::mt19937 random(3);
  FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::none);
  set.header.nodes[0].axes = Axes{{{0.6, 0.8, 0.0}, {-0.8, 0.6, 0.0}, {0.0, 0.0, 1.0}}};
  write_hdf5(set, path("a.h5"));
  const FrfSet read = load(*open_hdf5(path("a.h5")));
  EXPECT_EQ(read.header.nodes[0].axes, set.header.nodes[0].axes);
  EXPECT_FALSE(read.header.nodes[1].axes);
}

TEST_F(Hdf5File, RoundTripsEveryQuantityAndNoiseRecord) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 5; ++trial) {
    for (const Quantity quantity : all_quantities) {
      for (const NoiseRecord noise : all_noise_records) {
        const FrfSet set = random_set(random, quantity, noise, trial % 2 == 0);
        write_hdf5(set, path("a.h5"),
                   {.lines_per_chunk = static_cast<std::size_t>(trial), .compression = trial});
        const FrfSet read = load(*open_hdf5(path("a.h5")));
        expect_same(read, set, quantity == Quantity::receptance ? 0.0 : 1e-15);
        ASSERT_EQ(read.header.nodes.size(), 2u);
        EXPECT_EQ(read.header.nodes[1].id, 9'999'999'999);
        EXPECT_EQ(read.header.nodes[0].position, set.header.nodes[0].position);
      }
    }
  }
}

TEST_F(Hdf5File, BlocksAreThePartsOfTheWhole) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const FrfSet set = random_set(random, all_quantities[trial % 3], all_noise_records[trial % 2 * 2]);
    write_hdf5(set, path("a.h5"),
               {.lines_per_chunk = static_cast<std::size_t>(trial % 5), .compression = trial % 3});
    const auto source = open_hdf5(path("a.h5"));
    const FrfSet whole = load(*source);
    expect_blocks_of(whole, *source, random);
  }
}

TEST_F(Hdf5File, BlocksOfRowsFarApartAreRight) {
  std::mt19937 random(3);
  FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::none);
  set.header.frequency_hz = {1.0, 2.0, 3.0};
  set.header.response.clear();
  set.header.reference.clear();
  for (int i = 1; i <= 90; ++i) set.header.response.push_back({i, Direction::y, 1});
  for (int i = 1; i <= 200; ++i) set.header.reference.push_back({i, Direction::x, 1});
  set.values.resize(set.header.lines() * set.header.entries());
  for (std::size_t i = 0; i < set.values.size(); ++i) set.values[i] = {static_cast<double>(i), -1.0};
  write_hdf5(set, path("a.h5"));
  const auto source = open_hdf5(path("a.h5"));
  expect_blocks_of(set, *source, random);
  const std::vector<std::size_t> lines = {0, 2};
  const std::vector<std::size_t> responses = {89, 0, 45};
  const std::vector<std::size_t> references = {199, 3};
  std::vector<Complex> got(12);
  source->read({lines, responses, references}, got);
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_EQ(got[i], set.values[set.index(lines[i / 6], responses[i / 2 % 3], references[i % 2])]);
  }
}

TEST_F(Hdf5File, CountsWhatItHandsOut) {
  std::mt19937 random(4);
  const FrfSet set = random_set(random, Quantity::mobility, NoiseRecord::none);
  write_hdf5(set, path("a.h5"));
  const auto source = open_hdf5(path("a.h5"));
  EXPECT_EQ(source->count().calls, 0u);
  const std::vector<std::size_t> first = {0};
  const std::vector<std::size_t> two = {0, 1};
  std::vector<Complex> out(2);
  source->read({two, first, first}, out);
  EXPECT_EQ(source->count().calls, 1u);
  EXPECT_EQ(source->count().lines, 2u);
  EXPECT_EQ(source->count().entries, 2u);
}

TEST_F(Hdf5File, TheStoredQuantityIsAnOption) {
  std::mt19937 random(5);
  FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::variance);
  write_hdf5(set, path("a.h5"), {.quantity = Quantity::mobility});
  set.header.quantity = Quantity::mobility;
  expect_same(load(*open_hdf5(path("a.h5"))), set, 1e-15);
}

TEST_F(Hdf5File, ASetIsWrittenLineByLine) {
  std::mt19937 random(6);
  const FrfSet set = random_set(random, Quantity::accelerance, NoiseRecord::variance);
  Hdf5Writer writer(path("a.h5"), set.header, {.lines_per_chunk = 2, .compression = 1});
  EXPECT_EQ(writer.lines_per_chunk(), 2u);
  const std::size_t entries = set.header.entries();
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    writer.write_lines(line, 1, std::span(set.values).subspan(line * entries, entries),
                       std::span(set.variance).subspan(line * entries, entries));
  }
  EXPECT_FALSE(std::filesystem::exists(path("a.h5")));
  writer.finish();
  EXPECT_EQ(files_in_folder(), 1u);
  expect_same(load(*open_hdf5(path("a.h5"))), set, 1e-15);
}

TEST_F(Hdf5File, AnUnfinishedWriterLeavesTheOldFile) {
  std::mt19937 random(7);
  const FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::none);
  write_file("a.h5", "old");
  {
    Hdf5Writer writer(path("a.h5"), set.header);
    EXPECT_EQ(files_in_folder(), 2u);
    EXPECT_THAT(message_of([&] { writer.finish(); }), HasSubstr("line 1 was never written"));
  }
  EXPECT_EQ(files_in_folder(), 1u);
  EXPECT_EQ(std::filesystem::file_size(path("a.h5")), 3u);
}

TEST_F(Hdf5File, WhereNothingCanBeWrittenIsAnError) {
  std::mt19937 random(8);
  const FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::none);
  EXPECT_THAT(message_of([&] { write_hdf5(set, path("none/a.h5")); }),
              HasSubstr("none/a.h5: cannot be written: No such file or directory"));
  EXPECT_THAT(message_of([&] { write_hdf5(set, path("a.h5"), {.compression = 10}); }, ErrorKind::usage),
              HasSubstr("10 is not a deflate level"));
}

TEST_F(Hdf5File, AFullDiskIsAnErrorThatLeavesNothing) {
  std::mt19937 random(9);
  FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::none);
  set.header.frequency_hz = {1.0, 2.0};
  for (int i = 1; i <= 200; ++i) set.header.response.push_back({i, Direction::x, 1});
  set.values.assign(2 * set.header.entries(), {1.0, 2.0});
  for (const rlim_t room : {1u, 500u, 1000u, 2000u, 3000u, 4000u, 5000u, 8000u}) {
    const SmallDisk disk(room);
    for (const int compression : {0, 1}) {
      EXPECT_THAT(message_of([&] { write_hdf5(set, path("a.h5"), {.compression = compression}); }),
                  HasSubstr("a.h5: cannot be written: File too large"));
    }
  }
  EXPECT_EQ(files_in_folder(), 0u);
}

TEST_F(Hdf5File, ReadsTheGoldenFiles) {
  const std::filesystem::path golden = std::filesystem::path(JOINTID_EXTERNAL_DATA) / "../golden";
  if (!std::filesystem::exists(golden)) JOINTID_SKIP("no golden files at " << golden);
  const FrfSet set = load(*open_hdf5(golden / "caseA1_clean_assembly.h5"));
  EXPECT_EQ(set.header.lines(), 31u);
  EXPECT_EQ(set.header.response.size(), 14u);
  EXPECT_EQ(set.header.response[1].name(), "2:+RZ");
  EXPECT_EQ(set.header.frequency_hz[3], 460.0);
  EXPECT_EQ(set.values[set.index(3, 2, 5)], Complex(5.540885422404904e-07, -9.93700313252685e-10));
  for (std::size_t r = 0; r < 14; ++r) {
    for (std::size_t c = 0; c < 14; ++c) {
      EXPECT_TRUE(near(set.values[set.index(3, r, c)], set.values[set.index(3, c, r)], 1e-6));
    }
  }
}

double resident_megabytes() {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024.0;
  }
  return 0.0;
}

/// HDF5 takes half a megabyte for a file that is open: those of FRFs alone are closed there, and read on.
TEST_F(Hdf5File, ManyOpenFilesTakeLittleMemory) {
  constexpr std::size_t files = 120;
  std::mt19937 random(5);
  const FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::variance);
  for (std::size_t f = 0; f < files; ++f) write_hdf5(set, path("part" + std::to_string(f) + ".h5"));
  std::vector<std::unique_ptr<FrfSource>> sources = {};
  sources.push_back(open_hdf5(path("part0.h5")));
  const double before = resident_megabytes();
  for (std::size_t f = 1; f < files; ++f) sources.push_back(open_hdf5(path("part" + std::to_string(f) + ".h5")));
#ifndef __SANITIZE_ADDRESS__  // which keeps what is freed
  EXPECT_LT(resident_megabytes() - before, 0.25 * static_cast<double>(files));
#else
  EXPECT_GT(before, 0.0);
#endif
  for (std::size_t f = 0; f < files; f += 17) expect_blocks_of(set, *sources[f], random);
}

/// Of a file that another took the place of, what was opened is read.
TEST_F(Hdf5File, IsReadOnWhenAnotherTakesItsPlace) {
  std::mt19937 random(6);
  const FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::none);
  write_hdf5(set, path("a.h5"));
  const auto source = open_hdf5(path("a.h5"));
  write_hdf5(random_set(random, Quantity::receptance, NoiseRecord::none), path("a.h5"));
  expect_blocks_of(set, *source, random);
}

}  // namespace
}  // namespace jointid::frf
