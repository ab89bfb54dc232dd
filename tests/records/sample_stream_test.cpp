#include "records/file/open_samples.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "frf/file/columns.hpp"
#include "records/file/read_series.hpp"
#include "tests/test_folder.hpp"

namespace jointid::records {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::filesystem::path write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

/// All rows, read `step` rows at a time; missing samples as -999.
std::vector<double> rows_of(SampleStream& stream, std::size_t step) {
  const std::size_t width = stream.channels().size();
  std::vector<double> block(step * width), out;
  for (std::size_t count = stream.read(block); count > 0; count = stream.read(block)) {
    EXPECT_LE(count, step);
    for (std::size_t i = 0; i < count * width; ++i) out.push_back(std::isnan(block[i]) ? -999.0 : block[i]);
  }
  return out;
}

/// However many parts and rows at a time, the file is the same.
void expect_rows(const std::filesystem::path& path, const std::vector<std::string>& channels,
                 const std::vector<double>& expected) {
  for (const std::size_t parts : {1u, 2u, 3u, 7u}) {
    for (const std::size_t step : {1u, 2u, 5u, 1000u}) {
      std::vector<double> all;
      for (std::size_t part = 0; part < parts; ++part) {
        const auto stream = open_samples(path, {channels, part, parts});
        const std::vector<double> rows = rows_of(*stream, step);
        all.insert(all.end(), rows.begin(), rows.end());
      }
      EXPECT_EQ(all, expected) << path << ", " << parts << " parts, " << step << " rows at a time";
    }
  }
}

std::string message(const std::filesystem::path& path, const std::vector<std::string>& channels = {}) {
  try {
    rows_of(*open_samples(path, {channels, 0, 1}), 3);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SampleStream, ReadsTextLineByLine) {
  const TestFolder folder;
  const auto plain = write(folder / "a.csv", "# rig\ntime [s],a [N],b [m]\n0,1,2\n0.1,,4e-1\n\n% rest\n0.2,5,nan\n0.3, +6 ,7\n");
  expect_rows(plain, {}, {1, 2, -999, 0.4, 5, -999, 6, 7});
  expect_rows(plain, {"b", "1"}, {2, 0, 0.4, 0.1, -999, 0.2, 7, 0.3});
  const auto stream = open_samples(plain);
  EXPECT_EQ(stream->channels()[0].name, "a");
  EXPECT_EQ(stream->channels()[1].unit, "m");
  EXPECT_EQ(stream->time_column(), "time");
  expect_rows(write(folder / "b.txt", "1 2\r\n3\t 4\r\n 5 6"), {}, {1, 2, 3, 4, 5, 6});
  expect_rows(write(folder / "c.csv", "x;y\n1,5;2\n;3\n"), {}, {1.5, 2, -999, 3});
  EXPECT_THAT(message(write(folder / "d.csv", "x,y\n1,2\n3\n")), HasSubstr("byte 8: has 1 cells"));
  EXPECT_THAT(message(write(folder / "e.csv", "x,y\n1,2\n3,a\n")), HasSubstr("column 2: 'a' is not a number"));
  EXPECT_THAT(message(write(folder / "f.csv", "# nothing\n")), HasSubstr("holds no numbers"));
  EXPECT_THAT(message(plain, {"absent"}), HasSubstr("there is no column 'absent'"));
  EXPECT_THAT(message(write(folder / "g.csv", "time\n1\n")), HasSubstr("no channel beside the time"));
}

/// Lines longer than what is read at once, and many of them: the same as the whole file in memory.
TEST(SampleStream, OfALongTextIsTheTable) {
  const TestFolder folder;
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i < 3000; ++i) {
    for (int k = 0; k < 40; ++k) text << (k > 0 ? "," : "") << std::sin(0.37 * i + k);
    text << "\n";
  }
  const auto path = write(folder / "a.csv", text.str());
  const frf::Columns table = frf::read_columns(path);
  std::vector<double> expected;
  for (std::size_t i = 0; i < 3000; ++i) {
    for (const auto& column : table.columns) expected.push_back(column.values[i]);
  }
  expect_rows(path, {}, expected);
}

/// A time response of a universal file, as text or as binary doubles.
std::string uff58(int node, int type, const std::string& unit, const std::vector<double>& samples, bool binary) {
  char line[200];
  std::string text = "    -1\n";
  std::snprintf(line, sizeof line, "    58%s\n",
                binary ? "b     1     2          11         100     0     0           0           0" : "");
  text += line;
  for (int k = 0; k < 5; ++k) text += "NONE\n";
  std::snprintf(line, sizeof line, "%5d%10d%5d%10d %-10s%10d%4d %-10s%10d%4d\n", 1, 0, 0, 0, "NONE", node, 3, "NONE", 0, 0);
  text += line;
  std::snprintf(line, sizeof line, "%10d%10d%10d%13.5E%13.5E%13.5E\n", 4, static_cast<int>(samples.size()), 1, 0.0, 0.01, 0.0);
  text += line;
  for (const auto& [kind, label] : {std::pair{17, std::string("s")}, std::pair{type, unit}, std::pair{0, std::string("NONE")},
                                    std::pair{0, std::string("NONE")}}) {
    std::snprintf(line, sizeof line, "%10d%5d%5d%5d %-20s %-20s\n", kind, 0, 0, 0, "NONE", label.c_str());
    text += line;
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (binary) {
      const auto bytes = std::bit_cast<std::array<char, 8>>(samples[i]);
      text.append(bytes.data(), bytes.size());
      continue;
    }
    std::snprintf(line, sizeof line, "%20.11E%s", samples[i], i % 4 == 3 || i + 1 == samples.size() ? "\n" : "");
    text += line;
  }
  return text + (binary ? "\n" : "") + "    -1\n";
}

/// The same of a channel without direction, with a first identification line.
std::string scalar58(const std::string& title, const std::string& unit, const std::vector<double>& samples) {
  std::string text = uff58(0, 3, unit, samples, false);
  text.replace(text.find("NONE"), 4, title);
  return text.replace(text.find("         0   3"), 14, "         0   0");
}

/// Proper orthogonal modes and strain gauges take any quantity, in its own unit.
TEST(SampleStream, ReadsStrainsAndPressuresOfUff) {
  const TestFolder folder;
  const std::string run = scalar58("gauge 1", "um/m", {1, 2}) + scalar58("gauge 2", "um/m", {3, 4}) +
                          uff58(4, 15, "Pa", {5, 6}, true) + uff58(4, 8, "mm", {7, 8}, true);
  const auto path = write(folder / "a.uff", run);
  expect_rows(path, {}, {1, 3, 5, 0.007, 2, 4, 6, 0.008});
  expect_rows(path, {"gauge 2"}, {3, 4});
  const auto stream = open_samples(write(folder / "b.uff", run + run));
  EXPECT_EQ(rows_of(*stream, 2), (std::vector<double>{1, 3, 5, 0.007, 2, 4, 6, 0.008, 1, 3, 5, 0.007, 2, 4, 6, 0.008}));
  const char* units[] = {"um/m", "um/m", "Pa", "m"};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(stream->channels()[k].unit, units[k]);
}

TEST(SampleStream, ReadsTimeDataOfUffInSiUnitsRunAfterRun) {
  const TestFolder folder;
  for (const bool binary : {false, true}) {
    const std::string force = uff58(1, 13, "kN", {1, 2, 3, 4, 5}, binary),
                      motion = uff58(4, 12, "m/s^2", {6, 7, 8, 9, 10}, binary);
    const auto path = write(folder / "a.uff", force + motion);
    expect_rows(path, {}, {1000, 6, 2000, 7, 3000, 8, 4000, 9, 5000, 10});
    expect_rows(path, {"2"}, {6, 7, 8, 9, 10});
    const auto stream = open_samples(path);
    EXPECT_EQ(stream->channels()[0].unit, "N");
    EXPECT_EQ(stream->channels()[1].unit, "m/s^2");
    EXPECT_EQ(stream->rate_hz(), 100.0);
    // Channels of unequal length, and a second run.
    const auto two = write(folder / "b.uff", force + uff58(4, 12, "m/s^2", {6, 7}, binary) + force + motion);
    const auto runs = open_samples(two);
    EXPECT_EQ(runs->cut(), 3u);
    EXPECT_EQ(rows_of(*runs, 3), (std::vector<double>{1000, 6, 2000, 7, 1000, 6, 2000, 7, 3000, 8, 4000, 9, 5000, 10}));
    EXPECT_THAT(message(write(folder / "c.uff", force + motion + force)), HasSubstr("is not in all runs"));
  }
}

TEST(SampleStream, ReadsHdf5InParts) {
  const TestFolder folder;
  const hid_t file = H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const auto put = [&](const char* name, std::vector<hsize_t> dims, const std::vector<double>& numbers) {
    const hid_t space = H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr);
    const hid_t dataset = H5Dcreate2(file, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    H5Dclose(dataset);
    H5Sclose(space);
  };
  put("by_sample", {5, 2}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  put("by_channel", {2, 5}, {1, 3, 5, 7, 9, 2, 4, 6, 8, 10});
  put("short", {4}, {11, 12, 13, 14});
  put("time", {5}, {0, 0.5, 1, 1.5, 2});
  H5Fclose(file);
  for (const std::string name : {"by_sample", "by_channel"})
    expect_rows(folder / "a.h5", {name + "(1)", name + "(2)"}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  expect_rows(folder / "a.h5", {"short", "by_sample(2)"}, {11, 2, 12, 4, 13, 6, 14, 8});
  const auto stream = open_samples(folder / "a.h5", {{"short", "time"}, 0, 1});
  EXPECT_EQ(stream->cut(), 1u);
  EXPECT_EQ(open_samples(folder / "a.h5")->channels().size(), 5u);
  const SeriesRecord record = read_series(folder / "a.h5", {{"by_sample(2)"}, {}, 3});
  EXPECT_EQ(record.rate_hz, 2.0);
  EXPECT_TRUE(record.is_cut);
  EXPECT_THAT(record.samples[0], ElementsAre(2, 4, 6));
}

TEST(Series, AsksForTheRateWhereNothingSaysIt) {
  const TestFolder folder;
  const auto path = write(folder / "a.csv", "x\n1\n2\n3\n");
  EXPECT_EQ(read_series(path, {{}, 8.0, 0}).rate_hz, 8.0);
  EXPECT_THROW(read_series(path, {}), InputError);
  EXPECT_THROW(read_series(write(folder / "b.csv", "time,x\n0,1\n1,2\n9,3\n"), {}), InputError);
  EXPECT_EQ(read_series(write(folder / "c.csv", "time,x\n0,1\n0.25,2\n0.5,3\n"), {}).rate_hz, 4.0);
}

}  // namespace
}  // namespace jointid::records
