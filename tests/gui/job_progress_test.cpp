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
  progress.show_stage("lines", 0.25);
  EXPECT_EQ(progress.value(), 250);
  EXPECT_EQ(progress.format().toStdString(), "lines %p %");
  progress.show_stage("planning", -1.0);
  EXPECT_EQ(progress.maximum(), 0);
  progress.set_busy(false);
  EXPECT_TRUE(progress.isHidden());
}

}  // namespace
}  // namespace jointid::gui
