#include "tasks/frf/run_frf.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "base/control.hpp"
#include "base/error.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

/// Two impacts, a file each: the response is the force, one sample later, times 2.
class RunFrf : public testing::Test {
 protected:
  RunFrf() {
    for (const char* name : {"a.csv", "b.csv"}) {
      std::ofstream file(folder_ / name);
      file << "time,hammer,a\n";
      for (int i = 0; i < 256; ++i) file << i / 256.0 << ',' << force(i) << ',' << 2.0 * force(i - 1) << '\n';
      task_.files.push_back(folder_ / name);
    }
    task_.read.channels = {records::parse_channel("hammer=1:+Z N"), records::parse_channel("a=2:+Z m/s^2")};
  }
  static double force(int sample) { return sample == 20 || sample == 22 ? 5.0 : sample == 21 ? 10.0 : 0.0; }

  TestFolder folder_;
  FrfTask task_;
};

TEST_F(RunFrf, MakesTheFrfsOfTheFiles) {
  std::vector<std::string> stages;
  ident::Control control;
  control.progress = [&](const char* stage, std::size_t, std::size_t) { stages.emplace_back(stage); };
  const FrfRun run = run_frf(task_, control);
  EXPECT_THAT(stages, testing::ElementsAre("reading", "reading", "estimating"));
  EXPECT_THAT(run.record_files, testing::ElementsAre("a.csv", "b.csv"));
  EXPECT_EQ(run.made.averages.front().kept, 2U);
  const frf::FrfSet& set = run.made.set;
  const std::size_t line = 10;
  const double omega = angular(set.header.frequency_hz[line]);
  EXPECT_NEAR(std::abs(set.values[set.index(line, 0, 0)]) * omega * omega, 2.0, 1e-9);
  EXPECT_EQ(coherences(run, 0, 0).size(), set.header.lines() - 1);  // 0 Hz has none
  EXPECT_EQ(begin_s(run, run.made.blows.front()), 0.0);
}

TEST_F(RunFrf, StopsWhenAsked) {
  ident::Control control;
  control.interrupted = [] { return true; };
  EXPECT_THROW(run_frf(task_, control), Interrupted);
}

TEST_F(RunFrf, RefusesWhatCannotBeCarriedOut) {
  EXPECT_THROW(run_frf({}), InputError);
  FrfTask shaker = task_;
  shaker.shaker = true;
  EXPECT_THROW(run_frf(shaker), InputError);
  task_.references = {frf::Dof::parse("1:+Z"), frf::Dof::parse("2:+Z"), frf::Dof::parse("3:+Z")};
  EXPECT_THROW(run_frf(task_), InputError);
}

}  // namespace
}  // namespace jointid::tasks
