// `jointid frf` as a user runs it: blows in a text file, what it tells and writes.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/random.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "frf/set/frf_source.hpp"
#include "input_folder.hpp"
#include "run_command.hpp"

namespace jointid::cli {
namespace {

using testing::HasSubstr;

constexpr double sampling_hz = 512.0;
constexpr std::size_t blow_samples = 512;

/// Accelerations of two points after blows, each 1 s after the other, that a mode at 40 Hz follows; the hammer's signal has
/// noise, and blow `twice` a second pulse.
std::string blows(std::size_t count, std::size_t twice = 99) {
  std::string text = "time (s),hammer,a,b\n";
  for (std::size_t k = 0; k < count; ++k) {
    const std::complex<double> step = std::exp(std::complex<double>(-6.0, 2.0 * std::numbers::pi * 40.0) / sampling_hz);
    std::complex<double> state = 0.0;
    for (std::size_t t = 0; t < blow_samples; ++t) {
      const auto pulse = [&](std::size_t at) { return t >= at && t < at + 3 ? 20.0 + 2.0 * static_cast<double>(k) : 0.0; };
      const double force = pulse(10) + (k == twice ? pulse(60) : 0.0);
      state = step * state + force;
      const auto noise = normal_numbers({3, k}, t);
      text += fmt::format("{:.10f},{:.10g},{:.10g},{:.10g}\n", static_cast<double>(k * blow_samples + t) / sampling_hz,
                          force + 0.05 * noise[0], 0.3 * state.imag() + 0.001 * noise[1], -0.1 * state.imag() + 0.01 * noise[1]);
    }
  }
  return text;
}

std::vector<std::string> frf(const std::vector<std::string>& more) {
  std::vector<std::string> words = {"frf",       "blows.csv", "--channel", "hammer=1:+Z N", "--channel",    "a=4:+Z m/s^2",
                                    "--channel", "b=5:-Z g",  "--block",   "0.95",          "--pretrigger", "0.01"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

class FrfCommand : public testing::Test {
 protected:
  FrfCommand() { folder_.write("blows.csv", blows(5, 2)); }
  InputFolder folder_;
};

TEST_F(FrfCommand, TellsOfBlowsAveragesAndCoherence) {
  const Outcome outcome = run_command(folder_.path(), frf({}));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::ContainsRegex("3 +blows.csv +2\\.00[0-9]+ +[0-9.]+ +rejected: double impact: [0-9.]+ ms"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("1:\\+Z +4 +5 +4"));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("5:-Z / 1:\\+Z +0\\.[0-9]+"));
  EXPECT_THAT(outcome.out, HasSubstr("H1, 244 lines from 0 to "));
}

TEST_F(FrfCommand, WritesCovariancesThatInfoConvertAndOthersRead) {
  Outcome outcome = run_command(folder_.path(), frf({"--output", "new.h5"}));
  EXPECT_THAT(outcome.out, HasSubstr("wrote new.h5: accelerance with variances and covariances")) << outcome.err;
  EXPECT_THAT(run_command(folder_.path(), {"info", "new.h5"}).out,
              HasSubstr("variance of real and imaginary part, covariance between responses"));
  EXPECT_EQ(run_command(folder_.path(), {"convert", "new.h5", "again.h5"}).code, 0);
  const frf::FrfSet first = frf::load_with_covariance(*frf::open(folder_.path("new.h5")));
  const frf::FrfSet again = frf::load_with_covariance(*frf::open(folder_.path("again.h5")));
  ASSERT_EQ(first.covariance.size(), first.header.lines() * 3);
  for (std::size_t i = 3; i < first.covariance.size(); ++i)
    EXPECT_NEAR(std::abs(again.covariance[i] / first.covariance[i] - 1.0), 0.0, 1e-14);
  outcome = run_command(folder_.path(), {"convert", "new.h5", "new.csv"});
  EXPECT_THAT(outcome.out, HasSubstr("without their covariances, which HDF5 alone holds"));
  EXPECT_THAT(run_command(folder_.path(), frf({"--output", "other.mat"})).out,
              HasSubstr("without covariances, which HDF5 alone holds"));
}

/// Covariances of low rank stay so, and are pairs where these are smaller.
TEST_F(FrfCommand, ConvertKeepsAFactorOfCovariances) {
  frf::FrfSet set;
  set.header.frequency_hz = {10.0, 20.0};
  for (int node = 1; node <= 6; ++node) set.header.response.push_back(frf::Dof::parse(std::to_string(node) + ":+Z"));
  set.header.reference = {frf::Dof::parse("1:+Z")};
  set.header.noise = frf::NoiseRecord::variance;
  set.values.assign(12, {1e-6, 2e-6});
  set.variance.assign(12, {2.5e-17, 2.5e-17});
  set.factor = {.rank = 2, .rows = std::vector<Complex>(24, {1e-9, 2e-9}), .diagonal = std::vector<double>(12, 4e-17)};
  frf::write_hdf5(set, folder_.path("factor.h5"));
  EXPECT_EQ(run_command(folder_.path(), {"convert", "factor.h5", "again.h5"}).code, 0);
  EXPECT_THAT(run_command(folder_.path(), {"info", "again.h5"}).out,
              HasSubstr("variance of real and imaginary part, covariance between responses of rank 2 plus a diagonal"));
  const frf::FrfSet again = frf::load_with_covariance(*frf::open(folder_.path("again.h5")));
  EXPECT_EQ(again.factor.rows, set.factor.rows);
  EXPECT_EQ(again.factor.diagonal, set.factor.diagonal);
}

TEST_F(FrfCommand, WindowsEstimatorsAndVariancesAreOptions) {
  const Outcome outcome = run_command(
      folder_.path(),
      frf({"--force-window", "0.02",     "--exponential", "0.2",       "--estimator", "hv",     "--variances", "scatter",
           "--reject",       "1,5",      "--remove-mean", "--highest", "100",         "--json", "-",           "--csv",
           "new.csv",        "--report", "new.html",      "--output",  "new.h5"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["estimator"], "Hv");
  EXPECT_EQ(json["references"][0]["kept"], 2);
  EXPECT_EQ(json["stretches"][0]["reason"], "by the user");
  EXPECT_EQ(json["covariances"], true);
  EXPECT_LE(json["range_hz"][1], 100.0);
  EXPECT_EQ(json["frfs"].size(), 2u);
  EXPECT_THAT(folder_.text("new.csv"), HasSubstr("number,file,from_s,force_n,kept,reason\n1,blows.csv,"));
  EXPECT_THAT(folder_.text("new.html"), HasSubstr("jointid frf"));
}

TEST_F(FrfCommand, FilesMayHaveReferencesOfTheirOwn) {
  std::filesystem::copy(folder_.path("blows.csv"), folder_.path("more.csv"));
  std::vector<std::string> words = frf({"--reference", "1:+Z,7:+Z", "--output", "new.h5"});
  words.insert(words.begin() + 2, "more.csv");
  EXPECT_EQ(run_command(folder_.path(), words).code, 0);
  EXPECT_EQ(frf::names(frf::open(folder_.path("new.h5"))->header().reference), (std::vector<std::string>{"1:+Z", "7:+Z"}));
  words[words.size() - 3] = "1:+Z,7:+Z,8:+Z";
  EXPECT_THAT(run_command(folder_.path(), words).err,
              HasSubstr("--reference: 3 DOFs for 2 files; give one for all files, or one each"));
}

TEST_F(FrfCommand, FilesMayStandBehindTheOptions) {
  std::vector<std::string> words = frf({});
  words.erase(words.begin() + 1);
  words.push_back("blows.csv");
  words.insert(words.begin() + 1, {"--reject", "1"});
  EXPECT_EQ(run_command(folder_.path(), words).code, 0);
  EXPECT_EQ(run_command(folder_.path(), {"frf", "--channel", "hammer=1:+Z N", "--channel", "a=4:+Z g", "blows.csv"}).code,
            3);  // two blows
}

TEST_F(FrfCommand, TwoShakersAtOnceAreTwoReferences) {
  std::string text = "t,f,g,x\n";
  for (std::size_t t = 0; t < 1024; ++t) {
    const auto f = normal_numbers({8, 0}, t);
    text += fmt::format("{:.10f},{:.10g},{:.10g},{:.10g}\n", static_cast<double>(t) / 512.0, f[0], f[1], f[0] - 0.5 * f[1]);
  }
  folder_.write("two.csv", text);
  const Outcome outcome = run_command(folder_.path(), {"frf", "two.csv", "--shaker", "--block", "0.25", "--channel", "f=1:+Z N",
                                                       "--channel", "g=2:+Z N", "--channel", "x=3:+Z m", "--output", "new.h5"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::ContainsRegex("3:\\+Z / 2:\\+Z +1.0000 +1.0000 +1.0000"));
  EXPECT_THAT(
      run_command(folder_.path(), {"frf", "two.csv", "--channel", "f=1:+Z N", "--channel", "g=2:+Z N", "--channel", "x=3:+Z m"})
          .err,
      HasSubstr("has two forces, f and g; name the channels of one force; several at once are for segments, with --shaker"));
}

TEST_F(FrfCommand, WhatIsWrongIsSaidInOneLine) {
  const auto says = [&](const std::vector<std::string>& more, int code) {
    const Outcome outcome = run_command(folder_.path(), frf(more));
    EXPECT_EQ(outcome.code, code);
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    return outcome.err;
  };
  EXPECT_THAT(says({"--estimator", "h4"}, 2), HasSubstr("--estimator: 'h4' is no estimator"));
  EXPECT_THAT(says({"--window", "flat"}, 2), HasSubstr("--window: 'flat' is no window of segments"));
  EXPECT_THAT(says({"--channel", "c=9:+Z V"}, 2), HasSubstr("'V' is no unit of a force or a motion"));
  EXPECT_THAT(says({"--channel", "c=9:+Z N"}, 3), HasSubstr("there is no column 'c'; the columns are time, hammer, a, b"));
  EXPECT_THAT(says({"--trigger", "2"}, 2), HasSubstr("trigger: 2 is no share between 0 and 1"));
  EXPECT_THAT(says({"--reject", "9"}, 2), HasSubstr("there is no segment 9 of 5"));
  EXPECT_THAT(says({"--output", "new.xls"}, 2), HasSubstr("new.xls: 'xls' is no format of FRF files"));
  EXPECT_THAT(says({"--shaker", "--overlap", "1"}, 2), HasSubstr("overlap: 1 is not from 0 to below 1"));
  EXPECT_THAT(run_command(folder_.path(), {"frf", "a.h5"}).err, HasSubstr("a.h5: "));
  EXPECT_THAT(run_command(folder_.path(), {"frf", "absent.npy"}).err, HasSubstr("absent.npy: there is no such file"));
  EXPECT_THAT(run_command(folder_.path(), {"frf", "blows.csv", "--shaker"}).err,
              HasSubstr("--shaker: states no length of the segments"));
}

}  // namespace
}  // namespace jointid::cli
