#include "laws/task/shared_trials.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <limits>
#include <map>
#include <mutex>
#include <stdexcept>

#include "base/control.hpp"
#include "base/error.hpp"
#include "tests/ident/thread_team.hpp"

namespace jointid::laws {
namespace {

using testing::HasSubstr;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// With numbers of all bits, some of which are none.
LawTrial some_trial(std::size_t number) {
  const double value = 1.0 / (3.0 + static_cast<double>(number));
  LawTrial out;
  out.trial = number;
  out.status = "ok";
  out.laws = "bilinear + ren";
  out.usable = number % 3 != 0;
  out.chi_square = 10.0 * value;
  if (out.usable) out.values = {{value, -value, 1e300 * value}, {none, none, none}};
  return out;
}

/// A study of 20 trials by a team of three.
class SharedTrials : public testing::Test {
 protected:
  using Told = std::vector<std::optional<std::vector<LawTrial>>>;

  LawTrial made(std::size_t number) {
    const std::scoped_lock lock(mutex_);
    ++times_[number];
    return some_trial(number);
  }

  /// `change` makes the options of each member its own.
  std::vector<std::exception_ptr> run(const std::function<LawTrial(std::size_t member, std::size_t trial)>& make,
                                      const std::function<void(std::size_t member, LawStudyOptions&)>& change) {
    return ident::ThreadTeam(3).run([&](ident::Team& member) {
      LawStudyOptions options = {.trials = 20, .threads = 2};
      change(member.rank(), options);
      told_[member.rank()] =
          trials_made_together([&](std::size_t trial) { return make(member.rank(), trial); }, 2, options, member);
    });
  }

  std::mutex mutex_;
  std::map<std::size_t, int> times_;
  Told told_{3};
};

TEST_F(SharedTrials, AreMadeOnceEachAndToldByTheLeader) {
  std::map<std::size_t, int> told;
  std::size_t last = 0;
  const auto thrown = run([&](std::size_t, std::size_t trial) { return made(trial); },
                          [&](std::size_t member, LawStudyOptions& options) {
                            if (member != 0) return;
                            options.known = {some_trial(4), some_trial(5), some_trial(11), some_trial(99)};
                            options.made = [&](const LawTrial& trial) { ++told[trial.trial]; };
                            options.progress = [&](std::size_t done, std::size_t total) {
                              EXPECT_EQ(done, last == 0 ? 4u : last + 1);
                              EXPECT_EQ(total, 20u);
                              last = done;
                            };
                          });
  for (const std::exception_ptr& each : thrown) EXPECT_FALSE(each);
  EXPECT_FALSE(told_[1] || told_[2]);
  ASSERT_TRUE(told_[0]);
  ASSERT_EQ(told_[0]->size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    const LawTrial &found = (*told_[0])[i], expected = some_trial(i);
    const bool was_known = i == 4 || i == 5 || i == 11;
    EXPECT_EQ(times_[i], was_known ? 0 : 1);
    EXPECT_EQ(told[i], was_known ? 0 : 1);
    EXPECT_EQ(line_of(found, 2), line_of(expected, 2));
    EXPECT_EQ(found.chi_square, expected.chi_square);
  }
  EXPECT_EQ(last, 20u);
}

TEST_F(SharedTrials, FailureOfAnotherProcessEndsAll) {
  const auto thrown = run(
      [&](std::size_t member, std::size_t trial) {
        if (member == 2) throw std::runtime_error("no memory left");
        return made(trial);
      },
      [](std::size_t, LawStudyOptions&) {});
  EXPECT_FALSE(thrown[1] || thrown[2]);
  ASSERT_TRUE(thrown[0]);
  try {
    std::rethrow_exception(thrown[0]);
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no memory left"));
  }
  EXPECT_FALSE(told_[0]);
}

TEST_F(SharedTrials, WhatTheLeaderCannotKeepEndsAll) {
  const auto thrown = run([&](std::size_t, std::size_t trial) { return made(trial); },
                          [](std::size_t, LawStudyOptions& options) {
                            options.made = [](const LawTrial&) { throw std::runtime_error("disk full"); };
                          });
  EXPECT_FALSE(thrown[1] || thrown[2]);
  ASSERT_TRUE(thrown[0]);
  EXPECT_THROW(std::rethrow_exception(thrown[0]), std::runtime_error);
}

TEST_F(SharedTrials, InterruptionIsToldByTheLeader) {
  std::atomic<std::size_t> done = 0;
  const auto thrown = run([&](std::size_t, std::size_t trial) { return made(trial); },
                          [&](std::size_t, LawStudyOptions& options) {
                            options.interrupted = [&] { return done >= 2; };
                            options.progress = [&](std::size_t so_far, std::size_t) { done = so_far; };
                          });
  EXPECT_FALSE(thrown[1] || thrown[2]);
  ASSERT_TRUE(thrown[0]);
  EXPECT_THROW(std::rethrow_exception(thrown[0]), Interrupted);
  EXPECT_FALSE(told_[0]);
}

}  // namespace
}  // namespace jointid::laws
