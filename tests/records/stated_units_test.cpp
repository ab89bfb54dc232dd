// What files state of their times and units, and what is given beside it: understood, or an error that names it.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>

#include "base/error.hpp"
#include "records/estimate/measured_frfs.hpp"
#include "records/file/open_samples.hpp"
#include "records/file/read_record.hpp"
#include "records/file/read_series.hpp"
#include "records/file/time_title.hpp"
#include "tests/test_folder.hpp"

namespace jointid::records {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double stated_rate = 1024.0;
constexpr std::size_t stated_samples = 1024;

/// A mass of 2 kg on a spring, 50 Hz, ζ = 0.02: 12.5 m/s^2/N there.
Complex accelerance(double hz) {
  const double ratio = hz / 50.0;
  return -ratio * ratio / 2.0 / Complex(1.0 - ratio * ratio, 0.04 * ratio);
}

/// Periodic force and acceleration of three lines, so that H is exact on them; the acceleration begins `late` seconds after.
std::pair<std::vector<double>, std::vector<double>> record_of(double late = 0.0) {
  std::vector<double> force(stated_samples), motion(stated_samples);
  for (std::size_t i = 0; i < stated_samples; ++i) {
    for (const double hz : {30.0, 50.0, 90.0}) {
      const double t = static_cast<double>(i) / stated_rate;
      const auto at = [&](double when) { return std::polar(1.0, 2.0 * std::numbers::pi * hz * when); };
      force[i] += at(t).real();
      motion[i] += (accelerance(hz) * at(t + late)).real();
    }
  }
  return {force, motion};
}

class StatedUnits : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  /// A table of times in `per_second` parts of a second, force and acceleration over `scale`.
  std::filesystem::path table(const std::string& titles, double per_second = 1.0, double scale = 1.0,
                              char separator = ',') const {
    const auto [force, motion] = record_of();
    std::string text = titles + "\n";
    char line[120];
    for (std::size_t i = 0; i < stated_samples; ++i) {
      std::snprintf(line, sizeof line, "%.12g%c%.12g%c%.12g\n", static_cast<double>(i) / stated_rate * per_second, separator,
                    force[i], separator, motion[i] / scale);
      text += line;
    }
    return write("table.csv", text);
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

RecordOptions channels(const std::vector<std::string>& texts, std::optional<double> rate_hz = {}) {
  RecordOptions options;
  for (const std::string& text : texts) options.channels.push_back(parse_channel(text));
  options.rate_hz = rate_hz;
  return options;
}

const RecordOptions plain = channels({"2=1:+Z N", "3=2:+Z m/s^2"});

void expect_lines(const std::vector<Record>& records, Complex factor_at_50 = 1.0) {
  FrfOptions options;
  options.keep_faulty = true;  // a force that never rests
  const MeasuredFrfs made = make_frfs(records, options);
  ASSERT_EQ(made.set.header.lines(), 513u);
  EXPECT_EQ(made.set.header.frequency_hz[50], 50.0);
  const double omega = 2.0 * std::numbers::pi * 50.0;
  EXPECT_LT(std::abs(-omega * omega * made.set.values[50] / (factor_at_50 * accelerance(50.0)) - 1.0), 1e-6);
}

TEST_F(StatedUnits, TimesInAnyUnitGiveTheSameLines) {
  struct Title {
    const char* text;
    double per_second;
  };
  for (const Title& title : {Title{"time (ms)", 1e3},
                             {"Time [us]", 1e6},
                             {"t [µs]", 1e6},
                             {"t (\xB5s)", 1e6},
                             {"Time_ms", 1e3},
                             {"TimeMs", 1e3},
                             {"time in ms", 1e3},
                             {"t/us", 1e6},
                             {"time, msec", 1e3},
                             {"Zeit [ms]", 1e3},
                             {"時間 [ms]", 1e3},
                             {"msec", 1e3},
                             {"time [sec]", 1.0},
                             {"time (s)", 1.0},
                             {"Time", 1.0},
                             {"t", 1.0},
                             {"elapsed time [min]", 1.0 / 60.0},
                             {"time [NONE]", 1.0},
                             {"Time (MILLISECONDS)", 1e3},
                             {"sec", 1.0},
                             {"time_s", 1.0},
                             {"x", 1.0}}) {
    const bool comma = std::string(title.text).find(',') != std::string::npos;
    SCOPED_TRACE(title.text);
    expect_lines(read_records(
        table(std::string(title.text) + (comma ? "\tforce\tacc" : ",force,acc"), title.per_second, 1.0, comma ? '\t' : ','),
        plain));
  }
}

TEST_F(StatedUnits, AUnitOfTimesThatIsNotUnderstoodIsAnErrorOrTheRateIsGiven) {
  for (const char* title : {"time (samples)", "Time [V]", "time [hh:mm:ss]", "time_samples", "Time index", "time [-]",
                            "date time", "t [m]", "time (parsec)"}) {
    SCOPED_TRACE(title);
    const auto path = table(std::string(title) + ",force,acc", 1e3);
    RecordOptions named = plain;
    named.time = "1";
    EXPECT_THAT(message(path, named),
                AllOf(HasSubstr("table.csv: column "), HasSubstr("is no unit of a time that is known"), HasSubstr("--rate")));
    named.rate_hz = stated_rate;
    expect_lines(read_records(path, named));
  }
}

TEST_F(StatedUnits, RowsOfUnitsAndSeparatorsOfSpreadsheets) {
  expect_lines(read_records(table("sep=;\nTime;Channel A;Channel B\n(ms);(N);(m/s²)", 1e3, 1.0, ';'), plain));
  EXPECT_THAT(message(table("Time,Channel A,Channel B\n(ms),(V),(g)", 1e3), plain),
              HasSubstr("column Channel A: the file states V, and N is given"));
  EXPECT_THAT(message(table("Time,Channel A,Channel B\nfoo,N,g", 1e3), plain), HasSubstr("'foo' is no unit of a time"));
}

TEST_F(StatedUnits, DecimalCommasBetweenTabs) {
  const auto read = [&](const std::string& text) { return read_records(write("a.txt", text), plain)[0]; };
  const Record record = read("t\tF\ta\n0,000\t1,5\t2\n0,001\t-2,5\t3\n");
  EXPECT_EQ(record.rate_hz, 1000.0);
  EXPECT_EQ(record.channels[0].samples[1], -2.5);
  EXPECT_THAT(message(write("b.txt", "t\tF\ta\n0.000\t1,234\t2\n0.001\t2\t3\n"), plain), HasSubstr("decimal points and commas"));
}

TEST_F(StatedUnits, AGivenRateMayNotContradictTheTimes) {
  const auto path = table("time (ms),force,acc", 1e3);
  EXPECT_THAT(message(path, channels({"2=1:+Z N", "3=2:+Z m/s^2"}, 2048.0)), HasSubstr("states 1024 samples per second"));
  expect_lines(read_records(path, channels({"2=1:+Z N", "3=2:+Z m/s^2"}, 1024.0)));
  // Numbers of samples are no times.
  EXPECT_EQ(read_records(write("n.csv", "t,F,a\n1,1,2\n2,3,4\n3,5,6\n"), channels({"F=1:+Z N", "a=2:+Z g"}, 512.0))[0].rate_hz,
            512.0);
}

TEST_F(StatedUnits, UnitsOfTitlesAndGivenOnesAgree) {
  const auto error = [&](const std::string& titles, const std::string& force, const std::string& motion) {
    return message(table(titles), channels({"2=1:+Z " + force, "3=2:+Z " + motion}));
  };
  const std::string fine = "nothing was thrown";
  EXPECT_EQ(error("t,force [N],acc (m/s^2)", "N", "m/s²"), fine);
  EXPECT_EQ(error("t,force [lbf],acc (G)", "LBF", "gn"), fine);
  EXPECT_EQ(error("t,force (hammer),acc (left)", "N", "g"), fine);
  EXPECT_EQ(error("t,force [kN],acc [g]", "1000 N", "9.81 m/s^2"), fine);
  EXPECT_EQ(error("t,force [N],acc [g]", "1.02 N", "0.98 g"), fine);
  EXPECT_EQ(error("t,force [V],acc [mV]", "22.4 N", "0.1 g"), fine);
  EXPECT_THAT(error("t,force [N],acc [g]", "N", "m/s^2"),
              HasSubstr("column acc: the file states g, and m/s^2 is given; give the unit that"));
  EXPECT_THAT(error("t,force [lbf],acc", "N", "m/s^2"), HasSubstr("column force: the file states lbf, and N is given"));
  EXPECT_THAT(error("t,force [N],acc [mm]", "N", "m/s^2"), HasSubstr("the file states mm, and m/s^2 is given"));
  EXPECT_THAT(error("t,force [V],acc", "N", "m/s^2"),
              AllOf(HasSubstr("the file states V, and N is given"), HasSubstr("give the factor")));
}

TEST_F(StatedUnits, OneColumnIsNotTwoChannels) {
  const auto same = folder_ / "same.csv";
  std::filesystem::rename(table("time,ch,ch"), same);
  const auto differs = table("time,a,b");
  EXPECT_THAT(message(same, channels({"ch=1:+Z N", "ch=2:+Z m/s^2"})),
              HasSubstr("the name 'ch' is above 2 columns; give the number"));
  EXPECT_THAT(message(differs, channels({"2=1:+Z N", "2=2:+Z m/s^2"})), HasSubstr("'2=' and '2=' are one column, a"));
  EXPECT_THAT(message(differs, channels({"a=1:+Z N", "2=2:+Z m/s^2"})), HasSubstr("'a=' and '2=' are one column, a"));
  EXPECT_THAT(message(differs, channels({"A=1:+Z N", "a=2:+Z m/s^2"})), HasSubstr("are one column, a"));
  EXPECT_THAT(message(differs, channels({"1=1:+Z N", "b=2:+Z m/s^2"})), HasSubstr("column time holds the times"));
  expect_lines(read_records(same, plain));
  const auto streamed = [&](const std::vector<std::string>& names) {
    try {
      open_samples(differs, {names, 0, 1});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing was thrown");
  };
  EXPECT_THAT(streamed({"a", "2"}), HasSubstr("'a' and '2' are one column"));
  EXPECT_EQ(streamed({"a", "3"}), "nothing was thrown");
}

/// A dataset 58 as text: what a time record of another program may say.
struct Uff {
  int node = 1, direction = 3, type = 12;
  std::string unit = "m/s^2", title = "NONE", abscissa = "s";
  double first = 0.0, step = 1.0 / stated_rate;

  std::string text(const std::vector<double>& values) const {
    char line[200];
    std::string out = "    -1\n    58\n" + title + "\nNONE\nNONE\nNONE\nNONE\n";
    std::snprintf(line, sizeof line, "%5d%10d%5d%10d %10s%10d%4d %10s%10d%4d\n", 1, 0, 0, 0, "NONE", node, direction, "NONE", 0,
                  0);
    out += line;
    std::snprintf(line, sizeof line, "%10d%10zu%10d%13.5e%13.5e%13.5e\n", 4, values.size(), 1, first, step, 0.0);
    out += line;
    const std::pair<int, std::string> axes[] = {{17, abscissa}, {type, unit}, {0, "NONE"}, {0, "NONE"}};
    for (const auto& [kind, label] : axes) {
      std::snprintf(line, sizeof line, "%10d%5d%5d%5d %-20s %-20s\n", kind, 0, 0, 0, "NONE", label.c_str());
      out += line;
    }
    for (const double value : values) {
      std::snprintf(line, sizeof line, "%20.12e\n", value);
      out += line;
    }
    return out + "    -1\n";
  }
};

const Uff force_n{.node = 1, .type = 13, .unit = "N"}, motion_si{.node = 2};

TEST_F(StatedUnits, LabelsOfUffRecords) {
  const auto record = record_of();
  const std::vector<double>& force = record.first;
  const std::vector<double>& motion = record.second;
  const auto scaled = [](std::vector<double> values, double by) {
    for (double& value : values) value *= by;
    return values;
  };
  expect_lines(read_records(write("a.uff", Uff{.type = 13, .unit = "LBF"}.text(scaled(force, 1.0 / 4.4482216152605)) +
                                               Uff{.node = 2, .unit = "G"}.text(scaled(motion, 1.0 / 9.80665))),
                            {}));
  Uff late_force = force_n, late_motion = motion_si;
  late_force.abscissa = late_motion.abscissa = "msec", late_force.step = late_motion.step = 1e3 / stated_rate;
  expect_lines(read_records(write("b.uff", late_force.text(force) + late_motion.text(motion)), {}));
  const auto error = [&](const Uff& one, const RecordOptions& options = {}) {
    return message(write("c.uff", force_n.text(force) + one.text(motion)), options);
  };
  EXPECT_THAT(error({.node = 2, .unit = "V"}),
              AllOf(HasSubstr("record 9"), HasSubstr("data type 12 in 'V' is no force or motion at 2:+Z (V is a voltage)")));
  EXPECT_THAT(error({.node = 2, .unit = "m/s"}),
              HasSubstr("data type 12, which is acceleration, in 'm/s' is no force or motion"));
  EXPECT_THAT(error({.node = 2, .unit = "wibble"}), HasSubstr("'wibble' is no force or motion"));
  EXPECT_THAT(error({.node = 2, .abscissa = "parsec"}), AllOf(HasSubstr("record 8"), HasSubstr("parsec"), HasSubstr("--rate")));
  // Calibrated by the user.
  expect_lines(read_records(write("d.uff", force_n.text(force) + Uff{.node = 2, .unit = "V"}.text(scaled(motion, 0.1))),
                            channels({"1=1:+Z N", "2=2:+Z 10 m/s^2"})));
}

TEST_F(StatedUnits, OptionsApplyToUffThatDoesNotStateAsMuch) {
  const auto [force, motion] = record_of();
  // Without a step.
  Uff stepless_force = force_n, stepless = motion_si;
  stepless_force.step = stepless.step = 0.0;
  const auto step0 = write("step0.uff", stepless_force.text(force) + stepless.text(motion));
  EXPECT_THAT(message(step0, {}), HasSubstr("states no step of the abscissa; give the samples per second by --rate"));
  expect_lines(read_records(step0, {{}, {}, stated_rate}));
  EXPECT_EQ(read_series(step0, {{}, stated_rate, 0}).rate_hz, stated_rate);
  EXPECT_THROW(read_series(step0, {}), InputError);
  // Without directions.
  const auto scalar = write("scalar.uff", Uff{.node = 1, .direction = 0, .type = 13, .unit = "N", .title = "hammer"}.text(force) +
                                              Uff{.node = 2, .direction = 0, .title = "acc"}.text(motion));
  EXPECT_THAT(message(scalar, {}), HasSubstr("has no direction; give its place and unit, e.g. --channel"));
  expect_lines(read_records(scalar, channels({"1=1:+Z N", "2=2:+Z m/s^2"})));
  expect_lines(read_records(scalar, channels({"Hammer=1:+Z N", "acc=2:+Z m/s^2"})));
  EXPECT_THAT(message(scalar, channels({"1=1:+Z N", "2=2:+Z g"})), HasSubstr("states acceleration in m/s^2, and g is given"));
  EXPECT_THAT(message(scalar, channels({"1=1:+Z N", "hammer=2:+Z N"})), HasSubstr("are one column"));
  // What the file states stays.
  const auto full = write("full.uff", force_n.text(force) + motion_si.text(motion));
  expect_lines(read_records(full, channels({"1=1:+Z N", "2=2:+Z m/s^2"})));
  EXPECT_EQ(read_records(full, channels({"2=2:+Z m/s^2"}))[0].channels.size(), 1u);
  EXPECT_THAT(message(full, channels({"1=1:+Z N", "2=5:+X m/s^2"})), HasSubstr("states 2:+Z, and 5:+X is given"));
  EXPECT_THAT(message(full, channels({"1=1:+Z N", "2=2:+Z m"})), HasSubstr("states acceleration in m/s^2, and m is given"));
  EXPECT_THAT(message(full, {{}, {}, 2048.0}), HasSubstr("states 1024 samples per second"));
  expect_lines(read_records(full, {{}, {}, stated_rate}));
  EXPECT_THAT(message(full, {{}, "time", {}}), HasSubstr("leave out --time"));
}

TEST_F(StatedUnits, ChannelsThatBeginLaterHaveThePhasesOfTheirTimes) {
  constexpr double late = 0.01;
  Uff second = motion_si;
  second.first = late;
  // Told as if both had begun together, H is exp(-i omega late) of it in truth.
  const auto [force, motion] = record_of();
  const auto told = read_records(write("a.uff", force_n.text(force) + second.text(motion)), {});
  EXPECT_NEAR(told[0].channels[1].start_s, late, 1e-12);
  expect_lines(told, std::polar(1.0, -2.0 * std::numbers::pi * 50.0 * late));
  // Sampled at its own times, H is that of the structure.
  const auto [again, moved] = record_of(late);
  expect_lines(read_records(write("b.uff", force_n.text(again) + second.text(moved)), {}));
  // Both late alike: nothing changes.
  Uff first = force_n;
  first.first = late;
  const auto alike = read_records(write("c.uff", first.text(force) + second.text(motion)), {});
  EXPECT_FALSE(has_delays(alike[0]));
  expect_lines(alike);
}

TEST_F(StatedUnits, SegmentsOfLateChannelsAreOfOneTime) {
  constexpr double late = 20.4 / stated_rate;
  const auto [force, motion] = record_of(late);
  Uff second = motion_si;
  second.first = late;
  const auto records = read_records(write("a.uff", force_n.text(force) + second.text(motion)), {});
  const Record aligned = from_common_start(records[0]);
  EXPECT_EQ(aligned.samples(), stated_samples - 20);
  EXPECT_NEAR(aligned.channels[1].start_s * stated_rate, 0.4, 1e-4);
  FrfOptions options;
  options.keep_faulty = true;
  options.segments = SegmentOptions{0.5, 0.0, frf::Window::rectangular};
  const MeasuredFrfs made = make_frfs(records, options);
  const double omega = 2.0 * std::numbers::pi * 50.0;
  EXPECT_LT(std::abs(-omega * omega * made.set.values[25] / accelerance(50.0) - 1.0), 1e-4);
}

/// A row of a stream is an instant.
TEST_F(StatedUnits, StreamsLeaveOutWhatBeginsEarlierOrRefuse) {
  Uff second = motion_si;
  second.first = 2.0 / stated_rate;
  const auto path = write("a.uff", force_n.text({1, 2, 3, 4, 5}) + second.text({6, 7, 8, 9, 10}));
  const SeriesRecord record = read_series(path, {});
  EXPECT_THAT(record.samples[0], ::testing::ElementsAre(3, 4, 5));
  EXPECT_THAT(record.samples[1], ::testing::ElementsAre(6, 7, 8));
  second.first = 2.5 / stated_rate;
  EXPECT_THROW(open_samples(write("b.uff", force_n.text({1, 2, 3, 4, 5}) + second.text({6, 7, 8, 9, 10}))), InputError);
}

TEST_F(StatedUnits, SeriesTakeTheUnitOfTheirTimes) {
  EXPECT_EQ(read_series(table("time (ms),force,acc", 1e3), {}).rate_hz, stated_rate);
  EXPECT_EQ(read_series(table("Time_us,force,acc", 1e6), {}).rate_hz, stated_rate);
  EXPECT_EQ(open_samples(table("Time_us,force,acc", 1e6))->channels().size(), 2u);
  EXPECT_THROW(read_series(table("time (samples),force,acc", 1e6), {}), InputError);
  EXPECT_EQ(read_series(table("time (samples),force,acc", 1e6), {{}, stated_rate, 0}).rate_hz, stated_rate);
  EXPECT_THROW(read_series(table("time (ms),force,acc", 1e3), {{}, 2.0 * stated_rate, 0}), InputError);
}

TEST_F(StatedUnits, TemperaturesAndTorquesAreNoTimes) {
  EXPECT_FALSE(is_time_column({"T", "N*m", {}}));
  EXPECT_FALSE(is_time_column({"T", "V", {}}));
  EXPECT_FALSE(is_time_column({"time rate", "", {}}));
  EXPECT_TRUE(is_time_column({"T", "", {}}));
}

/// A sensor's sensitivity beside numbers whose unit nothing states: these may be volts.
TEST_F(StatedUnits, SensitivitiesThatNothingAppliesAreErrors) {
  for (const char* remark : {"# sensitivity: 20 mV/N, 100 mV/g", "# Sensitivity 10 mV/N", "# not calibrated", "# gain 10",
                             "Empfindlichkeit 22.4 pC/N"}) {
    const std::string titles = remark + std::string("\ntime [s],F,a");
    EXPECT_THAT(message(table(titles), plain),
                AllOf(HasSubstr("column F: states no unit, and line 1 states '"), HasSubstr("of volts give factor and unit")))
        << remark;
    EXPECT_EQ(message(table(titles), channels({"2=1:+Z 10 N", "3=2:+Z 10 m/s^2"})), "nothing was thrown") << remark;
    EXPECT_EQ(message(table(remark + std::string("\ntime [s],F [N],a [m/s^2]")), plain), "nothing was thrown") << remark;
  }
  for (const char* remark : {"# calibration date: 12.03.2026", "# sensitivity 10 mV/N (applied)"})
    EXPECT_EQ(message(table(remark + std::string("\ntime [s],F,a")), plain), "nothing was thrown") << remark;
}

TEST_F(StatedUnits, ATableThatBreaksOffInANumberIsAnError) {
  std::string text = "time [s],F,a\n";
  for (int i = 0; i < 8; ++i) text += "0.0" + std::to_string(i) + "00000,1.250000,-2.000" + std::to_string(i) + "00\n";
  EXPECT_EQ(message(write("whole.csv", text.substr(0, text.size() - 1)), plain), "nothing was thrown");
  EXPECT_THAT(message(write("cut.csv", text.substr(0, text.size() - 4)), plain), HasSubstr("the last line has no end"));
}

}  // namespace
}  // namespace jointid::records
