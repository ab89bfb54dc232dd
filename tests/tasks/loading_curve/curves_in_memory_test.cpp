#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "base/control.hpp"
#include "base/error.hpp"
#include "tasks/loading_curve/loading_curve_fit.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

/// A joint of 10 N/µm that slips at 150 N.
friction::Record record() {
  friction::Record out;
  for (int i = 1; i <= 40; ++i) {
    out.displacement.push_back(1e-6 * i);
    out.force.push_back(std::min(1e7 * out.displacement.back(), 150.0) + 0.25 * std::sin(2.0 * i));
  }
  return out;
}

LoadingCurveData curves() {
  LoadingCurveData data;
  data.curves = {friction::loading_curve("rig", record())};
  return data;
}

LoadingCurveTask laws(std::vector<std::string> names) {
  LoadingCurveTask task;
  task.laws = std::move(names);
  return task;
}

TEST(CurvesInMemory, AreFittedAsThoseOfAFile) {
  const TestFolder folder;
  {
    std::ofstream file(folder / "rig.csv");
    file.precision(17);
    file << "displacement [m],force [N]\n";
    for (std::size_t i = 0; i < record().force.size(); ++i) file << record().displacement[i] << ',' << record().force[i] << '\n';
  }
  LoadingCurveTask task = laws({"bilinear", "spring"});
  const LoadingCurveResult in_memory = fit_loading_curves(curves(), task);
  task.files = {folder / "rig.csv"};
  const LoadingCurveResult of_file = fit_loading_curves(task);
  ASSERT_EQ(in_memory.fits.size(), 2U);
  EXPECT_EQ(in_memory.fits.front().law, "bilinear");
  EXPECT_EQ(in_memory.title, "");
  EXPECT_EQ(of_file.title, "rig.csv");
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(in_memory.fits[i].aic, of_file.fits[i].aic);
  EXPECT_NEAR(in_memory.fits.front().curves.front().limit.value, 150.0, 1.0);
  EXPECT_NEAR(in_memory.fits.front().curves.front().stiffness.value, 1e7, 1e5);
}

TEST(CurvesInMemory, TellEveryLawAndStopWhenAsked) {
  std::vector<std::string> stages;
  std::size_t kept = 0;
  FittingWatch watch;
  watch.progress = [&](const std::string& stage) { stages.push_back(stage); };
  watch.so_far = [&](const LoadingCurveResult& result) { kept = result.fits.size(); };
  watch.interrupted = [&] { return kept == 1; };
  EXPECT_THROW(fit_loading_curves(curves(), laws({"bilinear", "spring"}), watch), Interrupted);
  EXPECT_THAT(stages, testing::ElementsAre("fitting bilinear"));
}

TEST(CurvesInMemory, ThatCannotBeFittedAreRefused) {
  EXPECT_THROW(fit_loading_curves(LoadingCurveData(), laws({"bilinear"})), InputError);
  LoadingCurveData wrong = curves();
  wrong.curves.front().value.pop_back();
  EXPECT_THROW(fit_loading_curves(wrong, laws({"bilinear"})), InputError);
  EXPECT_THROW(fit_loading_curves(curves(), laws({"renn"})), InputError);
}

/// The same curve in mm, as three files that state it and two that do not say so where it counts.
TEST(CurvesOfFiles, StateTheirUnitsOrAreRefused) {
  const TestFolder folder;
  const auto read = [&](const std::string& above, double scale) {
    std::ofstream file(folder / "rig.csv");
    file << above;
    const friction::Record si = record();
    for (std::size_t i = 0; i < si.force.size(); ++i) file << scale * si.displacement[i] << ',' << si.force[i] << '\n';
    file.close();
    LoadingCurveTask task;
    task.files = {folder / "rig.csv"};
    return read_curves(task);
  };
  for (const char* titles : {"u_mm,F_N\n", "Weg [mm],Kraft [N]\n", "Extension,Load\n(mm),(N)\n"})
    EXPECT_NEAR(read(titles, 1e3).curves.at(0).u.back(), 4e-5, 1e-10) << titles;
  for (const char* titles : {"# units: mm, N\nu,F\n", "# displacement in mm\nu,F\n"}) {
    try {
      read(titles, 1e3);
      ADD_FAILURE() << titles;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("states no unit, and line 1 states 'mm'")) << titles;
    }
  }
  try {
    read("# load cell sensitivity 10 mV/N\nu,F\n", 1.0);
    ADD_FAILURE() << "numbers of a sensor";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("states no unit, and line 1 states 'load cell sensitivity 10 mV/N'"));
  }
  EXPECT_NEAR(read("# load cell sensitivity 10 mV/N\nu [mm],F [N]\n", 1e3).curves.at(0).u.back(), 4e-5, 1e-10);
}

TEST(CurvesOfFiles, ThatDoNotBeginAtRestAreNoted) {
  const TestFolder folder;
  {
    std::ofstream file(folder / "rig.csv");
    file << "u [mm],F [N]\n";
    for (int i = 0; i < 20; ++i) file << 1.0 + 0.01 * i << ',' << 20 + i << '\n';
  }
  LoadingCurveTask task;
  task.files = {folder / "rig.csv"};
  const LoadingCurveData data = read_curves(task);
  ASSERT_EQ(data.notes.size(), 1u);
  EXPECT_THAT(data.notes[0], testing::HasSubstr("A loading curve begins at rest, at 0"));
}

}  // namespace
}  // namespace jointid::tasks
