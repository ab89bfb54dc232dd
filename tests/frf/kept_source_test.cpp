#include "frf/set/kept_source.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "file_fixture.hpp"

namespace jointid::frf {
namespace {

/// A set in memory that counts what it is asked for, and whether anything twice.
class Counted final : public FrfSource {
 public:
  struct Count {
    std::set<std::tuple<int, std::size_t, std::size_t, std::size_t>> asked;
    std::size_t again = 0;
  };

  Counted(FrfSet set, Count& count) : source_(from_memory(std::move(set))), count_(count) { header_ = source_->header(); }

 private:
  void note(int what, const Block& block) {
    for (const std::size_t l : block.lines) {
      for (const std::size_t r : block.responses) {
        for (const std::size_t c : block.references) count_.again += count_.asked.emplace(what, l, r, c).second ? 0U : 1U;
      }
    }
  }
  void do_read(const Block& block, std::span<Complex> out) override {
    note(0, block);
    source_->read(block, out);
  }
  void do_read_variance(const Block& block, std::span<Complex> out) override {
    note(1, block);
    source_->read_variance(block, out);
  }
  void do_read_coherence(const Block& block, std::span<double> out) override {
    note(2, block);
    source_->read_coherence(block, out);
  }

  std::unique_ptr<FrfSource> source_;
  Count& count_;
};

/// Some of n indices, in ascending or any order.
std::vector<std::size_t> some_of(std::size_t n, std::mt19937& random, bool ascending) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < n; ++i) {
    if (random() % 3 != 0) all.push_back(i);
  }
  if (!ascending) std::ranges::shuffle(all, random);
  return all;
}

template <class T>
void expect_equal(const std::vector<T>& a, const std::vector<T>& b) {
  ASSERT_EQ(a.size(), b.size());
  const bool equal = a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;  // NaN included
  EXPECT_TRUE(equal);
}

/// What two sources answer to twenty random blocks each.
void expect_same_answers(FrfSource& kept, FrfSource& direct, std::mt19937& random) {
  const FrfHeader& header = direct.header();
  for (int block = 0; block < 20; ++block) {
    const auto lines = some_of(header.lines(), random, true);
    const auto responses = some_of(header.response.size(), random, false),
               references = some_of(header.reference.size(), random, false);
    const Block asked{lines, responses, references};
    std::vector<Complex> a(asked.size()), b(asked.size());
    kept.read(asked, a);
    direct.read(asked, b);
    expect_equal(a, b);
    if (header.noise == NoiseRecord::variance) {
      kept.read_variance(asked, a);
      direct.read_variance(asked, b);
      expect_equal(a, b);
    } else if (header.noise == NoiseRecord::coherence) {
      std::vector<double> x(asked.size()), y(asked.size());
      kept.read_coherence(asked, x);
      direct.read_coherence(asked, y);
      expect_equal(x, y);
    }
  }
}

TEST(KeptSource, AnswersAsTheFileAndAsksItOnce) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    for (const NoiseRecord noise : all_noise_records) {
      const FrfSet set = random_set(random, Quantity::receptance, noise);
      const auto direct = from_memory(set);
      Counted::Count count;
      KeptSource kept(std::make_unique<Counted>(set, count));
      kept.keep(1U << 20);
      expect_same_answers(kept, *direct, random);
      EXPECT_GT(count.asked.size(), 0u);
      EXPECT_EQ(count.again, 0u);
    }
  }
}

TEST(KeptSource, WithoutRoomItAsksAgainAndAnswersTheSame) {
  std::mt19937 random(6);
  std::size_t again = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const FrfSet set = random_set(random, Quantity::receptance, NoiseRecord::variance);
    const auto direct = from_memory(set);
    Counted::Count count;
    KeptSource kept(std::make_unique<Counted>(set, count));
    if (trial % 2 == 0) kept.keep(random() % 500);
    expect_same_answers(kept, *direct, random);
    again += count.again;
  }
  EXPECT_GT(again, 0u);
}

}  // namespace
}  // namespace jointid::frf
