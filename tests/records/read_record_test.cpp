#include "records/file/read_record.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "tests/require.hpp"
#include "tests/test_folder.hpp"

namespace jointid::records {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class RecordFile : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  static std::string message(const std::filesystem::path& path, const RecordOptions& options) {
    try {
      read_records(path, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing was thrown";
  }

  TestFolder folder_;
};

RecordOptions force_and_g(const std::string& force = "2", const std::string& motion = "3") {
  return {{parse_channel(force + "=1:+Z kN"), parse_channel(motion + "=4:-Z g")}, {}, {}};
}

void expect_the_record(const std::vector<Record>& records) {
  ASSERT_EQ(records.size(), 1u);
  const Record& record = records[0];
  EXPECT_EQ(record.rate_hz, 1000.0);
  ASSERT_EQ(record.channels.size(), 2u);
  EXPECT_EQ(record.channels[0].kind, ChannelKind::force);
  EXPECT_EQ(record.channels[0].dof, frf::Dof::parse("1:+Z"));
  EXPECT_THAT(record.channels[0].samples, ElementsAre(0.0, 5000.0, 1000.0));
  EXPECT_EQ(record.channels[1].kind, ChannelKind::acceleration);
  EXPECT_EQ(record.channels[1].dof, frf::Dof::parse("4:-Z"));
  EXPECT_THAT(record.channels[1].samples, ElementsAre(0.0, 9.80665, -2.0 * 9.80665));
}

TEST_F(RecordFile, ColumnsOfTextBecomeChannelsInSiUnits) {
  expect_the_record(read_records(write("a.csv", "time,F,a\n0,0,0\n0.001,5,1\n0.002,1,-2\n"), force_and_g()));
  expect_the_record(read_records(write("b.csv", "t (s);F;a\n0;0;0\n0,001;5;1\n0,002;1;-2\n"), force_and_g("F", "a")));
  RecordOptions rate = force_and_g("1", "2");
  rate.rate_hz = 1000.0;
  expect_the_record(read_records(write("c.txt", "% no times\n0 0\n5 1\n1 -2\n"), rate));
}

TEST_F(RecordFile, WhatIsMissingOrWrongIsSaidWithWhatToDo) {
  const auto path = write("a.csv", "time,F,a\n0,0,0\n0.001,5,1\n0.002,1,-2\n");
  EXPECT_THAT(message(path, {}),
              HasSubstr("has columns time, F, a and does not state what they measured; name each, e.g. --channel"));
  EXPECT_THAT(message(path, force_and_g("2", "x")), HasSubstr("there is no column 'x'; the columns are time, F, a"));
  EXPECT_THAT(message(write("b.csv", "s,F,a\n0,0,0\n1,5,1\n"), force_and_g()),
              HasSubstr("does not state when its samples were taken; give --rate"));
  EXPECT_THAT(message(write("c.csv", "t,F,a\n0,0,0\n1,5,1\n3,5,1\n"), force_and_g()),
              HasSubstr("column t: the times are not even: sample 2"));
  EXPECT_THAT(message(write("d.csv", "t,F,a\n1,0,0\n0,5,1\n"), force_and_g()), HasSubstr("the times do not rise"));
  EXPECT_THAT(message(folder_ / "none.csv", {}), HasSubstr("there is no such file"));
}

TEST_F(RecordFile, RatesAreTheRoundNumbersThatTimesOfSingleOrDoublePrecisionMean) {
  std::string text = "t,F,a\n";
  for (int i = 0; i < 200; ++i) text += std::to_string(static_cast<float>(i) / 51.2F) + ",1,1\n";
  EXPECT_EQ(read_records(write("a.csv", text), force_and_g())[0].rate_hz, 51.2);
}

TEST_F(RecordFile, TheUnitOfTheFileIsEnough) {
  RecordOptions options;
  options.channels = {parse_channel("2=1:+Z"), parse_channel("3=4:-Z")};
  expect_the_record(read_records(write("a.csv", "time [ms],F [kN],a [g]\n0,0,0\n1,5,1\n2,1,-2\n"), options));
  EXPECT_THAT(message(write("b.csv", "time,F [N],a\n0,0,0\n1,5,1\n2,1,-2\n"), options),
              HasSubstr("column a: the file states no unit of it; give it, e.g. 3=4:-Z N, or m/s^2"));
  EXPECT_THAT(message(write("c.csv", "time,F [V],a [g]\n0,0,0\n1,5,1\n2,1,-2\n"), options),
              HasSubstr("column F: 'V' is no unit of a force or a motion at 1:+Z; give factor and unit, e.g. 2=1:+Z 22.4 N"));
}

TEST_F(RecordFile, TablesOfSeveralPlotsHaveOneColumnOfTimes) {
  const auto plots = [](const std::string& shift) {
    return "Time 0 [ms],F [kN],Time 1 [s],a [g]\n0,0," + shift + "0,0\n1,5," + shift + "1,1\n2,1," + shift + "2,-2\n";
  };
  RecordOptions options;
  options.channels = {parse_channel("F=1:+Z"), parse_channel("a=4:-Z")};
  expect_the_record(read_records(write("a.csv", plots("0.00")), options));
  EXPECT_THAT(message(write("b.csv", plots("0.01")), options),
              HasSubstr("columns Time 0 and Time 1 are times that differ by up to 0.01 s, and channels are behind both"));
  options.channels.pop_back();
  EXPECT_EQ(read_records(write("c.csv", plots("0.01")), options).front().rate_hz, 1000.0) << "one channel has one";
  options.channels = {parse_channel("F=1:+Z"), parse_channel("a=4:-Z")};
  expect_the_record(read_records(write("d.csv", "timestamp,time [ms],F [kN],a [g]\n9,0,0,0\n10,1,5,1\n11,2,1,-2\n"),
                                 [&] {
                                   RecordOptions named = options;
                                   named.time = "2";
                                   return named;
                                 }()));
}

TEST_F(RecordFile, ARateOrAStepBesideTheColumns) {
  const auto file_with = [&](const std::string& name, const std::vector<std::pair<std::string, double>>& numbers) {
    const auto path = folder_ / name;
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const auto put = [&](const std::string& of, const std::vector<double>& values) {
      const hsize_t count = values.size();
      const hid_t space = H5Screate_simple(1, &count, nullptr);
      const hid_t set = H5Dcreate2(file, of.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
      H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
      H5Dclose(set);
      H5Sclose(space);
    };
    put("F", {0.0, 5.0, 1.0});
    put("a", {0.0, 1.0, -2.0});
    for (const auto& [of, value] : numbers) put(of, {value});
    H5Fclose(file);
    return path;
  };
  expect_the_record(read_records(file_with("fs.h5", {{"Fs", 1000.0}}), force_and_g("F", "a")));
  expect_the_record(read_records(file_with("dt.h5", {{"dt", 0.001}}), force_and_g("F", "a")));
  expect_the_record(read_records(file_with("both.h5", {{"sample_rate", 1000.0}, {"time_step", 0.001}}), force_and_g("F", "a")));
  EXPECT_THAT(message(file_with("two.h5", {{"Fs", 1000.0}, {"dt", 0.002}}), force_and_g("F", "a")),
              HasSubstr("dt states 500 samples per second, and another number of the file 1000"));
  RecordOptions other = force_and_g("F", "a");
  other.rate_hz = 2000.0;
  EXPECT_THAT(message(file_with("other.h5", {{"Fs", 1000.0}}), other), HasSubstr("states 1000 samples per second, --rate"));
  EXPECT_THAT(message(file_with("none.h5", {{"gain", 1000.0}}), force_and_g("F", "a")), HasSubstr("does not state when"));
}

TEST(GivenChannel, IsColumnDofFactorAndUnit) {
  const GivenChannel channel = parse_channel("chan 2=12:-RY 0.5 rad/s^2");
  EXPECT_EQ(channel.column, "chan 2");
  EXPECT_EQ(channel.dof, frf::Dof::parse("12:-RY"));
  EXPECT_EQ(channel.factor, 0.5);
  const auto message = [](const std::string& text) {
    try {
      parse_channel(text);
    } catch (const InputError& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      return std::string(error.what());
    }
    return std::string("nothing was thrown");
  };
  EXPECT_THAT(message("4:+Z N"), HasSubstr("has no column before ="));
  EXPECT_THAT(message("2="), HasSubstr("has 0 words after =, not DOF and unit"));
  EXPECT_THAT(message("2=4:+Z 1 N m"), HasSubstr("has 4 words after =, not DOF and unit"));
  EXPECT_EQ(parse_channel("2=4:+Z").unit, "") << "that of the file";
  EXPECT_THAT(message("2=4:+Z V"), HasSubstr("'V' is no unit of a force or a motion at 4:+Z"));
  EXPECT_THAT(message("2=4:+RZ m/s^2"), HasSubstr("'m/s^2' is no unit of a force or a motion at 4:+RZ"));
  EXPECT_THAT(message("2=4:+Z 0 N"), HasSubstr("'0' is no factor"));
  EXPECT_THAT(message("2=Z N"), HasSubstr("Z"));
}

TEST_F(RecordFile, DatasetsOfHdf5InGroupsToo) {
  const hid_t file = H5Fcreate((folder_ / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t group = H5Gcreate2(file, "run", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const auto put = [](hid_t where, const char* name, std::vector<hsize_t> dims, const std::vector<double>& numbers) {
    const hid_t space = H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr);
    const hid_t dataset = H5Dcreate2(where, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    H5Dclose(dataset);
    H5Sclose(space);
  };
  put(file, "time", {3}, {0.0, 0.001, 0.002});
  put(group, "signals", {3, 2}, {0, 0, 5, 1, 1, -2});
  H5Gclose(group);
  H5Fclose(file);
  expect_the_record(read_records(folder_ / "a.h5", force_and_g("run.signals(1)", "run.signals(2)")));
}

/// A group that holds itself twenty times: what it says is found, and no more than a limited number of its names.
TEST_F(RecordFile, GroupsThatHoldThemselvesComeToAnEnd) {
  const hid_t file = H5Fcreate((folder_ / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t group = H5Gcreate2(file, "run", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  for (int i = 0; i < 20; ++i)
    H5Lcreate_hard(file, "run", group, ("again" + std::to_string(i)).c_str(), H5P_DEFAULT, H5P_DEFAULT);
  H5Gclose(group);
  H5Fclose(file);
  EXPECT_THAT(message(folder_ / "a.h5", force_and_g()), HasSubstr("has no real vector or matrix"));
}

/// A dataset 58 as text, one time response.
std::string uff58(int node, int direction, int type, const std::string& unit, const std::vector<double>& samples,
                  double step = 0.001) {
  char line[200];
  std::string out = "    -1\n    58\nNONE\nNONE\nNONE\nNONE\nNONE\n";
  std::snprintf(line, sizeof line, "%5d%10d%5d%10d %10s%10d%4d %10s%10d%4d\n", 1, 0, 0, 0, "NONE", node, direction, "NONE", 0, 0);
  out += line;
  std::snprintf(line, sizeof line, "%10d%10zu%10d%13.5e%13.5e%13.5e\n", 4, samples.size(), 1, 0.0, step, 0.0);
  out += line;
  std::snprintf(line, sizeof line, "%10d%5d%5d%5d %-20s %-20s\n", 17, 0, 0, 0, "Time", "s");
  out += line;
  std::snprintf(line, sizeof line, "%10d%5d%5d%5d %-20s %-20s\n", type, 0, 0, 0, "Signal", unit.c_str());
  out += line;
  std::snprintf(line, sizeof line, "%10d%5d%5d%5d %-20s %-20s\n", 0, 0, 0, 0, "NONE", "NONE");
  out += std::string(line) + line;
  for (const double sample : samples) {
    std::snprintf(line, sizeof line, "%20.12e\n", sample);
    out += line;
  }
  return out + "    -1\n";
}

const std::string uff_units =
    "    -1\n   164\n         9user: mm (kilonewton)        2\n"
    "  1.00000000000000000D+03  1.00000000000000000D-03  1.00000000000000000D+00\n"
    "  2.73149999999999977D+02\n    -1\n";

TEST_F(RecordFile, TimeDataOfUffWithDofsUnitsAndRuns) {
  const std::string force = uff58(1, 3, 13, "kN", {0, 5, 1}), motion = uff58(4, -3, 12, "g", {0, 1, -2});
  expect_the_record(read_records(write("a.uff", force + motion), {}));
  const auto runs = read_records(write("b.uff", force + motion + force + motion + motion), {});
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(runs[1].channels.size(), 2u);
  EXPECT_EQ(runs[2].channels.size(), 1u);
}

TEST_F(RecordFile, UffUnitsWithoutALabelAreThoseOfDataset164) {
  const auto records =
      read_records(write("a.uff", uff_units + uff58(1, 3, 13, "NONE", {0, 5, 1}) + uff58(4, 3, 12, "NONE", {0, 1, -2})), {});
  EXPECT_THAT(records[0].channels[0].samples, ElementsAre(0.0, 5000.0, 1000.0));
  EXPECT_THAT(records[0].channels[1].samples, ElementsAre(0.0, 0.001, -0.002));
  std::string si = uff_units;
  si.replace(si.find("         9"), 10, "         1");
  EXPECT_THAT(message(write("b.uff", si + uff58(1, 3, 13, "NONE", {0, 5, 1})), {}),
              HasSubstr("dataset 164 has units code 1, m and N, whose factors are 1 and 1, and the factors 1000 and 0.001"));
}

TEST_F(RecordFile, UffThatDoesNotFitIsSaid) {
  const std::string force = uff58(1, 3, 13, "N", {0, 5, 1});
  EXPECT_THAT(message(write("a.uff", force + uff58(4, 3, 12, "g", {0, 1})), {}),
              HasSubstr("2 samples at 1000 Hz, the channels before have 3 at 1000 Hz"));
  EXPECT_THAT(message(write("b.uff", force + uff58(4, 3, 12, "g", {0, 1, 1}, 0.01)), {}), HasSubstr("3 samples at 100 Hz"));
  EXPECT_THAT(message(write("c.uff", uff58(1, 3, 15, "Pa", {0, 1})), {}),
              HasSubstr("data type 15 in 'Pa' is no force or motion"));
  EXPECT_THAT(message(write("d.uff", uff58(1, 0, 13, "N", {0, 1})), {}), HasSubstr("response node 1 has no direction"));
  for (std::size_t keep = 200; keep + 8 < force.size(); keep += 31) {
    EXPECT_THAT(message(write("e.uff", force.substr(0, keep)), {}), HasSubstr("e.uff")) << keep;
  }
}

TEST_F(RecordFile, MeasuredRecordsOfOthers) {
  const std::filesystem::path data = JOINTID_EXTERNAL_DATA;
  if (!std::filesystem::exists(data)) JOINTID_SKIP("no measured data at " << data);
  const auto hammer = read_records(data / "hammer-repeats/measurements_2.npy",
                                   {{parse_channel("2=1:+Z N"), parse_channel("3=2:+Z m/s^2")}, "1", std::nullopt});
  EXPECT_EQ(hammer[0].rate_hz, 25600.0);
  EXPECT_EQ(hammer[0].samples(), 25600u);
  EXPECT_NEAR(hammer[0].channels[0].samples[21], 83.66679278, 1e-8);
  RecordOptions channels{
      {parse_channel("Time_chan_1=1:+Z N"), parse_channel("Time_chan_2=1:+Z m/s^2")}, "Time_domain", std::nullopt};
  // Its times were summed up in single precision and end 0.16 of a step late.
  EXPECT_THAT(message(data / "siso-coherence/case1.mat", channels),
              HasSubstr("column Time_domain: the times are not even: sample 279"));
  channels.rate_hz = 1280.0;
  const auto shaker = read_records(data / "siso-coherence/case1.mat", channels);
  EXPECT_EQ(shaker[0].rate_hz, 1280.0);
  EXPECT_EQ(shaker[0].samples(), 4096u);
  EXPECT_THAT(message(data / "uff/Sample_UFF58_ascii.uff", {}), HasSubstr("data type 21 in 'Pa' is no force or motion"));
  EXPECT_THAT(message(data / "uff/time-history-not-all-columns-filled.uff", {}), HasSubstr("response node 0 has no direction"));
}

}  // namespace
}  // namespace jointid::records
