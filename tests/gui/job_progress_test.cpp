#include "gui/look/job_progress.hpp"

#include <gtest/gtest.h>

namespace jointid::gui {
namespace {

TEST(TimeLeft, IsThatOfThePaceSinceTheStageBegan) {
  TimeLeft left;
  EXPECT_FALSE(left.note("reading", 0.2, 0.0));
  EXPECT_FALSE(left.note("reading", 0.3, 0.1));  // too early to tell
  const auto seconds = left.note("reading", 0.4, 2.0);
  ASSERT_TRUE(seconds);
  EXPECT_DOUBLE_EQ(*seconds, 6.0);  // a fifth took 2 s, three fifths are left
}

TEST(TimeLeft, BeginsAnewWithAStageAndWhenTheShareFalls) {
  TimeLeft left;
  left.note("reading", 0.0, 0.0);
  EXPECT_TRUE(left.note("reading", 0.5, 10.0));
  EXPECT_FALSE(left.note("solving", 0.6, 11.0));
  EXPECT_FALSE(left.note("solving", 0.1, 12.0));
  EXPECT_FALSE(left.note("solving", 0.1, 20.0));  // nothing was done since
  EXPECT_DOUBLE_EQ(left.note("solving", 0.4, 15.0).value_or(0.0), 6.0);
}

TEST(TimeLeft, IsNotKnownWithoutAShare) {
  TimeLeft left;
  EXPECT_FALSE(left.note("planning", -1.0, 0.0));
  EXPECT_FALSE(left.note("planning", -1.0, 10.0));
}

TEST(WholeShare, IsThatOfTheStageWithoutSteps) {
  WholeShare whole;
  EXPECT_EQ(whole.note("reading", 0.5).share, 0.5);
  EXPECT_EQ(whole.note("reading", 0.25).share, 0.25);
  EXPECT_FALSE(whole.note("reading", 0.5).is_whole);
}

TEST(WholeShare, CountsStepsAndNeverFalls) {
  WholeShare whole;
  whole.begin({1, 3, 0.0, 0.2});
  EXPECT_EQ(whole.note("planning", -1.0).share, 0.0);
  whole.begin({2, 3, 0.2, 0.8, 3});
  EXPECT_DOUBLE_EQ(whole.note("iteration 1", 0.5).share, 0.3);
  EXPECT_DOUBLE_EQ(whole.note("iteration 2", 0.0).share, 0.4);
  EXPECT_DOUBLE_EQ(whole.note("iteration 2", 0.5).share, 0.5);
  const JobShare again = whole.note("iteration 2", 0.0);  // the third pass
  EXPECT_DOUBLE_EQ(again.share, 0.6);
  EXPECT_EQ(again.number, 2U);
  EXPECT_EQ(again.of, 3U);
  EXPECT_TRUE(again.is_whole);
  EXPECT_LE(whole.note("one more than was expected", 0.9).share, 0.8);
  whole.begin({3, 3, 0.8, 1.0});
  EXPECT_DOUBLE_EQ(whole.note("regenerating", 1.0).share, 1.0);
}

TEST(WholeShare, CountsThePassesOfASingleStep) {
  WholeShare whole;
  whole.begin({1, 1, 0.0, 1.0, 4});
  whole.note("1 N", 0.5);
  const JobShare second = whole.note("10 N", 0.5);
  EXPECT_DOUBLE_EQ(second.share, 0.375);
  EXPECT_EQ(second.number, 2U);
  EXPECT_EQ(second.of, 4U);
}

TEST(DurationText, HasTheUnitThatFits) {
  EXPECT_EQ(duration_text(0.2).toStdString(), "1 s");
  EXPECT_EQ(duration_text(89.0).toStdString(), "89 s");
  EXPECT_EQ(duration_text(289.1).toStdString(), "4 min 50 s");
  EXPECT_EQ(duration_text(600.0).toStdString(), "10 min");
  EXPECT_EQ(duration_text(9000.0).toStdString(), "2.5 h");
}

TEST(JobProgress, ShowsStageAndShareWhileSomethingRuns) {
  JobProgress progress("p");
  EXPECT_TRUE(progress.isHidden());
  progress.set_busy(true);
  EXPECT_FALSE(progress.isHidden());
  progress.show_share({"lines", 0.25});
  EXPECT_EQ(progress.value(), 250);
  EXPECT_EQ(progress.format().toStdString(), "lines %p %");
  progress.show_share({"planning", -1.0});
  EXPECT_EQ(progress.format().toStdString(), "planning …");
  EXPECT_GT(progress.maximum(), 0) << "a bar without a range draws no text";
  progress.show_share({"lines", 0.5, 2, 4, true});
  EXPECT_EQ(progress.format().toStdString(), "2 of 4: lines %p %");
  progress.set_busy(false);
  EXPECT_TRUE(progress.isHidden());
}

}  // namespace
}  // namespace jointid::gui
