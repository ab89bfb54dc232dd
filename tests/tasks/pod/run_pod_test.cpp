#include "tasks/pod/run_pod.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "base/control.hpp"
#include "base/error.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

/// Two standing waves of mean squares 1/2 and 1/8.
void write_waves(const std::filesystem::path& path, int samples) {
  std::ofstream file(path);
  file.precision(17);
  file << "time [s],a [m],b [m]\n";
  for (int i = 0; i < samples; ++i) {
    const double one = std::cos(2.0 * M_PI * i / 50.0), two = 0.5 * std::cos(6.0 * M_PI * i / 50.0);
    file << i << "," << 1.0 + 0.6 * one + 0.8 * two << "," << 0.8 * one - 0.6 * two << "\n";
  }
}

TEST(RunPod, FindsTheModesTellsHowFarItIsAndStops) {
  const TestFolder folder;
  write_waves(folder / "run.csv", 500);
  PodTask task;
  task.files = {folder / "run.csv"};
  std::size_t read = 0;
  ident::Control control;
  control.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
    EXPECT_EQ(stage, "reading samples");
    EXPECT_GE(done, read);
    EXPECT_EQ(total, 0u);
    read = done;
  };
  const PodResult found = run_pod(task, control);
  EXPECT_EQ(read, 500u);
  EXPECT_THAT(found.names, testing::ElementsAre("a", "b"));
  EXPECT_NEAR(found.pod.values(0), 0.5, 1e-12);
  EXPECT_NEAR(found.pod.values(1), 0.125, 1e-12);
  EXPECT_NEAR(found.pod.mean(0), 1.0, 1e-12);
  control = {};
  control.interrupted = [] { return true; };
  EXPECT_THROW(run_pod(task, control), Interrupted);
}

TEST(RunPod, ComparesARecordInMemoryWithModes) {
  const TestFolder folder;
  std::ofstream(folder / "modes.csv") << "0.8,0.6\n-0.6,0.8\n";
  const auto next = [left = 1](std::span<double> rows) mutable {
    if (left-- == 0) return std::size_t{0};
    const std::array samples = {0.6, 0.8, -0.6, -0.8, 0.4, -0.3, -0.4, 0.3};
    std::ranges::copy(samples, rows.begin());
    return samples.size() / 2;
  };
  PodTask task;
  task.compare = folder / "modes.csv";
  const PodResult found = run_pod(task, PodRecord{{"a", "b"}, {"m", "m"}, 0, oscillation::record_triangle(2, next)});
  EXPECT_NEAR(found.pod.values(0), 0.5, 1e-12);
  EXPECT_NEAR(found.assurance(0, 1), 1.0, 1e-12);
  EXPECT_NEAR(found.assurance(0, 0), 0.0, 1e-12);
  task.stiffness = folder / "modes.csv";
  EXPECT_THROW(run_pod(task), InputError);  // no mass
}

}  // namespace
}  // namespace jointid::tasks
