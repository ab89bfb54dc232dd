#include <gmock/gmock.h>

#include <cmath>

#include "report/text/words.hpp"
#include "tasks/equivalent.hpp"
#include "tasks/study/run_study.hpp"

namespace jointid::cli {
namespace {

using testing::HasSubstr;

tasks::LevelJoint level(double stiffness, double damping, double deviation) {
  tasks::LevelJoint out;
  out.joint.stiffness = stiffness;
  out.joint.damping = damping;
  out.joint.deviation = deviation;
  return out;
}

TEST(EquivalentVerdict, IsDoubtfulWhereNoSpringAndDamperAreWithinTheErrors) {
  EXPECT_EQ(tasks::equivalent_status({level(1e6, 1e5, 2e4), level(9e5, -1e4, 2e4)}), "ok");  // negative within its interval
  EXPECT_EQ(tasks::equivalent_status({level(1e6, 1e5, 2e4), level(-1e5, 1e5, 2e4)}), "doubtful");
  EXPECT_EQ(tasks::equivalent_status({level(1e6, -1e5, 2e4)}), "doubtful");
  EXPECT_THAT(tasks::equivalent_doubt({level(1e6, 1e5, 2e4), level(1e6, -1e5, 2e4)}), HasSubstr("at 1 of 2 levels"));
}

TEST(EquivalentVerdict, IsDoubtfulWhereMostLevelsDoNotTellTheDamping) {
  EXPECT_EQ(tasks::equivalent_doubt({level(1e6, 1e4, 3e4), level(1e6, 5e4, 3e4)}), "");
  EXPECT_THAT(tasks::equivalent_doubt({level(1e6, 1e4, 3e4), level(1e6, 2e4, 3e4)}), HasSubstr("damping is not known"));
  tasks::LevelJoint open = level(1e6, 1e5, 1.0);
  open.joint.settled = false;
  EXPECT_EQ(tasks::equivalent_status({open}), "not_usable");
}

TEST(StudyVerdict, AMatrixThatIsOffByMoreThanItselfIsSaid) {
  study::StudyStatistics statistics;
  statistics.trials = statistics.usable = 100;
  statistics.quality.resize(2);
  statistics.quality[0].matrix = "stiffness";
  statistics.quality[0].rms_over_trials = 0.05;
  statistics.quality[1].matrix = "hysteretic_damping";
  statistics.quality[1].rms_over_trials = 0.4;
  EXPECT_EQ(tasks::study_doubt(statistics), "");
  statistics.quality[1].rms_over_trials = 3.0;
  EXPECT_EQ(tasks::study_doubt(statistics),
            "hysteretic damping is off by 300 % rms over the trials: one solution does not determine it");
}

TEST(StudyVerdict, WithoutATruthTheScatterTells) {
  study::StudyStatistics statistics;
  statistics.unknowns.resize(3);
  for (auto& unknown : statistics.unknowns) {
    unknown.mean = 1.0;
    unknown.std_deviation = 0.1;
  }
  EXPECT_EQ(tasks::study_doubt(statistics), "");
  statistics.unknowns[0].std_deviation = statistics.unknowns[1].std_deviation = 2.0;
  EXPECT_THAT(tasks::study_doubt(statistics), HasSubstr("2 of 3 unknowns"));
}

TEST(ChiSquareText, SaysHowManyLinesAreSetAside) {
  ident::ChiSquare chi{.value = 90.0, .degrees_of_freedom = 100.0, .outlying_lines = 1, .by_line = {1.0, 0.9, 1.1, 500.0, NAN}};
  EXPECT_EQ(report::chi_square_text(chi), "90 / 100 = 0.9, 1 outlier lines set aside");
  chi.outlying_lines = 2;  // of four: too many to be set aside
  EXPECT_EQ(report::chi_square_text(chi), "90 / 100 = 0.9");
  chi.outlying_lines = 0;
  EXPECT_EQ(report::chi_square_text(chi), "90 / 100 = 0.9");
}

}  // namespace
}  // namespace jointid::cli
