#include <gmock/gmock.h>

#include <cmath>

#include "base/control.hpp"
#include "base/error.hpp"
#include "tasks/series/align.hpp"
#include "tasks/series/contact.hpp"
#include "tasks/series/delay.hpp"
#include "tasks/series/strain.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

using testing::ElementsAre;

/// A record in memory of functions of the number of the sample.
records::SeriesRecord record_of(double rate_hz, std::size_t samples, const std::vector<std::function<double(double)>>& channels) {
  records::SeriesRecord record;
  record.rate_hz = rate_hz;
  for (const auto& of : channels) {
    record.channels.push_back({std::string(1, static_cast<char>('a' + record.samples.size())), "m"});
    std::vector<double>& x = record.samples.emplace_back();
    for (std::size_t i = 0; i < samples; ++i) x.push_back(of(static_cast<double>(i)));
  }
  return record;
}

ident::Control stops_at_once() {
  ident::Control control;
  control.interrupted = [] { return true; };
  return control;
}

TEST(RunAlign, FindsTheDelayOfARecordInMemory) {
  const double hz = 12.0, late = 0.0031, rate = 2000.0;
  const auto motion = [&](double t) { return std::sin(2.0 * M_PI * hz * t); };
  const auto record = record_of(
      rate, 2000, {[&](double i) { return motion(i / rate); }, [&](double i) { return 0.4 * motion(i / rate - late); }});
  AlignTask task;
  task.reference = "a";
  task.frequency_hz = hz;
  std::vector<std::size_t> done;
  ident::Control control;
  control.progress = [&](const char*, std::size_t channels, std::size_t total) {
    done.push_back(channels);
    EXPECT_EQ(total, 2u);
  };
  const AlignResult found = run_align(task, record, control);
  EXPECT_THAT(done, ElementsAre(0u, 1u));
  EXPECT_NEAR(found.channels[1].delay, late, 1e-9);
  EXPECT_NEAR(found.channels[1].amplitude, 0.4, 1e-9);
  const std::vector<double> b = aligned(found, 1);
  for (std::size_t i = 100; i < 1900; ++i) EXPECT_NEAR(b[i], 0.4 * motion(static_cast<double>(i) / rate), 1e-4);
  EXPECT_THROW(run_align(task, record, stops_at_once()), Interrupted);
}

TEST(RunContact, FindsTheLawOfARecordInMemory) {
  const auto speed = [](double i) { return i < 40 ? 0.0 : 0.002 * (i - 39); };
  const auto force = [&](double i) { return 2.0 * (i < 40 ? 0.5 * i / 40.0 : 0.3 + 0.2 * std::exp(-4.0 * speed(i))); };
  const records::SeriesRecord record = record_of(100.0, 400, {speed, force});
  ContactTask task;
  task.load = 2.0;
  task.stick_speed = 0.001;
  const ContactResult found = run_contact(task, record);
  EXPECT_TRUE(found.law.falls);
  EXPECT_NEAR(found.law.kinetic, 0.3, 1e-6);
  EXPECT_NEAR(found.law.decay, 4.0, 1e-4);
  task.load = 0.0;  // a third channel is the normal load
  EXPECT_THROW(run_contact(task, record), InputError);
}

TEST(RunDelay, TellsItsToolsAndStopsBetweenThem) {
  const auto record = record_of(100.0, 1000, {[](double i) { return std::sin(0.1 * i) + 0.3 * std::sin(0.1414 * i); }});
  DelayTask task;
  task.most_dimension = 3;
  task.steps = 20;
  std::vector<std::string> stages;
  ident::Control control;
  control.progress = [&](const std::string& stage, std::size_t, std::size_t) { stages.push_back(stage); };
  const DelayResult found = run_delay(task, record, control);
  EXPECT_EQ(found.samples, 1000u);
  EXPECT_EQ(found.channel, "a");
  EXPECT_THAT(stages, ElementsAre("mutual information", "false neighbours", "correlation dimension", "exponent by Rosenstein",
                                  "exponent by Kantz", "recurrences"));
  EXPECT_THROW(run_delay(task, record, stops_at_once()), Interrupted);
}

TEST(RunStrain, GivesTheDisplacementsOfBlocks) {
  const TestFolder folder;
  StrainTask task;
  task.file = folder / "strain.csv";
  task.length = 0.4, task.thickness = 0.001, task.gauges = {0.05, 0.15};
  std::ofstream(task.file) << "a,b\n1e-6,0\n0,2e-6\n";
  const StrainResult found = run_strain(task);
  EXPECT_THAT(found.task.points, ElementsAre(0.4));
  EXPECT_EQ(found.task.shapes, 2u);
  Eigen::MatrixXd all;
  EXPECT_EQ(find_displacements(found, *open_gauges(task), [&](const Eigen::MatrixXd& block) { all = block; }), 2u);
  ASSERT_EQ(all.rows(), 2);
  EXPECT_DOUBLE_EQ(all(0, 0), 1e-6 * found.map.matrix(0, 0));
  EXPECT_DOUBLE_EQ(all(1, 0), 2e-6 * found.map.matrix(0, 1));
  EXPECT_EQ(first_displacements(found, 1).displacements, all.topRows(1));
  EXPECT_THROW(find_displacements(found, *open_gauges(task), {}, stops_at_once()), Interrupted);
}

}  // namespace
}  // namespace jointid::tasks
