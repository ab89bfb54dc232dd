#include "frf/set/unit_label.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "file_fixture.hpp"
#include "frf/set/units.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

struct Label {
  std::string text;
  double si;
  int length, time, force;
};

// By the definitions of the units: international foot and pound, standard gravity.
constexpr double g = 9.80665, inch = 25.4e-3, foot = 12 * 25.4e-3, lbf = 0.45359237 * 9.80665, minute = 60.0,
                 degree = 0.017453292519943295;

const std::vector<Label> accelerations = {
    {"m/s^2", 1, 1, -2, 0},
    {"M/S^2", 1, 1, -2, 0},
    {"m/s2", 1, 1, -2, 0},
    {"M/S2", 1, 1, -2, 0},
    {"m/s**2", 1, 1, -2, 0},
    {"m/s²", 1, 1, -2, 0},
    {"m/s\xB2", 1, 1, -2, 0},
    {"m/s\xFD", 1, 1, -2, 0},
    {"mm/sý", 1e-3, 1, -2, 0},
    {"m/sÂ²", 1, 1, -2, 0},
    {"m/sec^2", 1, 1, -2, 0},
    {"m/sec2", 1, 1, -2, 0},
    {"m/sec/sec", 1, 1, -2, 0},
    {"m/s/s", 1, 1, -2, 0},
    {"m/ss", 1, 1, -2, 0},
    {"m.s-2", 1, 1, -2, 0},
    {"m·s⁻²", 1, 1, -2, 0},
    {"m s^-2", 1, 1, -2, 0},
    {"m s-2", 1, 1, -2, 0},
    {"m*s^-2", 1, 1, -2, 0},
    {"m/(s^2)", 1, 1, -2, 0},
    {"m/s^{2}", 1, 1, -2, 0},
    {"m/s^(2)", 1, 1, -2, 0},
    {"[m/s^2]", 1, 1, -2, 0},
    {"(m/s²)", 1, 1, -2, 0},
    {"m / s ^ 2", 1, 1, -2, 0},
    {"\"m/s^2\"", 1, 1, -2, 0},
    {"  m/s^2   ", 1, 1, -2, 0},
    {std::string("m/s^2\0\0\0\0", 9), 1, 1, -2, 0},
    {std::string("g\0s^2 left over", 15), g, 1, -2, 0},
    {"m per s squared", 1, 1, -2, 0},
    {"meters per second squared", 1, 1, -2, 0},
    {"metre/second^2", 1, 1, -2, 0},
    {"Meter/Sec-Sq", 1, 1, -2, 0},
    {"mm/s^2", 1e-3, 1, -2, 0},
    {"mm/sec^2", 1e-3, 1, -2, 0},
    {"MM/SEC^2", 1e-3, 1, -2, 0},
    {"mm/s/s", 1e-3, 1, -2, 0},
    {"cm/s^2", 1e-2, 1, -2, 0},
    {"um/s^2", 1e-6, 1, -2, 0},
    {"µm/s²", 1e-6, 1, -2, 0},
    {"\xB5m/s\xB2", 1e-6, 1, -2, 0},
    {"μm/s²", 1e-6, 1, -2, 0},
    {"in/s^2", inch, 1, -2, 0},
    {"IN/S^2", inch, 1, -2, 0},
    {"in/s/s", inch, 1, -2, 0},
    {"in./s^2", inch, 1, -2, 0},
    {"in/sec^2", inch, 1, -2, 0},
    {"inch/sec^2", inch, 1, -2, 0},
    {"inches/s^2", inch, 1, -2, 0},
    {"in/sec.^2", inch, 1, -2, 0},
    {"ft/s^2", foot, 1, -2, 0},
    {"FT/SEC^2", foot, 1, -2, 0},
    {"feet/second^2", foot, 1, -2, 0},
    {"mil/s^2", inch * 1e-3, 1, -2, 0},
    {"g (0-pk)", g, 1, -2, 0},
    {"g 0-pk", g, 1, -2, 0},
    {"m/s^2, rms", 1, 1, -2, 0},
    {"m/s^2 (0-Peak)", 1, 1, -2, 0},
    {"milli-g", g * 1e-3, 1, -2, 0},
    {"micro-g", g * 1e-6, 1, -2, 0},
    {"g0", g, 1, -2, 0},
    {"ms-2", 1, 1, -2, 0},
    {"ms⁻²", 1, 1, -2, 0},
    {"mms^-2", 1e-3, 1, -2, 0},
    {"g", g, 1, -2, 0},
    {"G", g, 1, -2, 0},
    {"gn", g, 1, -2, 0},
    {"g_n", g, 1, -2, 0},
    {"g's", g, 1, -2, 0},
    {"G's", g, 1, -2, 0},
    {"gs", g, 1, -2, 0},
    {"GS", g, 1, -2, 0},
    {"g's rms", g, 1, -2, 0},
    {"g rms", g, 1, -2, 0},
    {"G RMS", g, 1, -2, 0},
    {"grms", g, 1, -2, 0},
    {"gRMS", g, 1, -2, 0},
    {"g_rms", g, 1, -2, 0},
    {"g(rms)", g, 1, -2, 0},
    {"g-rms", g, 1, -2, 0},
    {"g pk", g, 1, -2, 0},
    {"gpk", g, 1, -2, 0},
    {"G Peak", g, 1, -2, 0},
    {"g pk-pk", g, 1, -2, 0},
    {"g p-p", g, 1, -2, 0},
    {"gravity", g, 1, -2, 0},
    {"grav", g, 1, -2, 0},
    {"gee", g, 1, -2, 0},
    {"'g'", g, 1, -2, 0},
    {"mg", 1e-3 * g, 1, -2, 0},
    {"mgn", 1e-3 * g, 1, -2, 0},
    {"µg", 1e-6 * g, 1, -2, 0},
    {"Gal", 1e-2, 1, -2, 0},
    {"m/s²eff", 1, 1, -2, 0},
};

const std::vector<Label> motions = {
    {"m", 1, 1, 0, 0},
    {"M", 1, 1, 0, 0},
    {"meter", 1, 1, 0, 0},
    {"Metres", 1, 1, 0, 0},
    {"mm", 1e-3, 1, 0, 0},
    {"MM", 1e-3, 1, 0, 0},
    {"millimeter", 1e-3, 1, 0, 0},
    {"cm", 1e-2, 1, 0, 0},
    {"um", 1e-6, 1, 0, 0},
    {"micron", 1e-6, 1, 0, 0},
    {"Micrometers", 1e-6, 1, 0, 0},
    {"nm", 1e-9, 1, 0, 0},
    {"in", inch, 1, 0, 0},
    {"IN", inch, 1, 0, 0},
    {"inch", inch, 1, 0, 0},
    {"Inches", inch, 1, 0, 0},
    {"mil", 1e-3 * inch, 1, 0, 0},
    {"mils pk-pk", 1e-3 * inch, 1, 0, 0},
    {"thou", 1e-3 * inch, 1, 0, 0},
    {"ft", foot, 1, 0, 0},
    {"foot", foot, 1, 0, 0},
    {"m/s", 1, 1, -1, 0},
    {"M/SEC", 1, 1, -1, 0},
    {"mm/s", 1e-3, 1, -1, 0},
    {"mm/sec rms", 1e-3, 1, -1, 0},
    {"mm/s RMS", 1e-3, 1, -1, 0},
    {"in/s", inch, 1, -1, 0},
    {"IPS", inch, 1, -1, 0},
    {"ips pk", inch, 1, -1, 0},
    {"cm/sec", 1e-2, 1, -1, 0},
    {"ft/min", foot / minute, 1, -1, 0},
    {"rad", 1, 0, 0, 0},
    {"mrad", 1e-3, 0, 0, 0},
    {"deg", degree, 0, 0, 0},
    {"°", degree, 0, 0, 0},
    {"\xB0/s", degree, 0, -1, 0},
    {"rad/s", 1, 0, -1, 0},
    {"rad/sec^2", 1, 0, -2, 0},
    {"RAD/S/S", 1, 0, -2, 0},
    {"deg/s²", degree, 0, -2, 0},
};

const std::vector<Label> forces = {
    {"lb-f", lbf, 0, 0, 1},
    {"lb_f", lbf, 0, 0, 1},
    {"LB(F)", lbf, 0, 0, 1},
    {"lb f", lbf, 0, 0, 1},
    {"kg-f", g, 0, 0, 1},
    {"N", 1, 0, 0, 1},
    {"n", 1, 0, 0, 1},
    {"Newton", 1, 0, 0, 1},
    {"NEWTONS", 1, 0, 0, 1},
    {"N rms", 1, 0, 0, 1},
    {"Nrms", 1, 0, 0, 1},
    {"N pk", 1, 0, 0, 1},
    {std::string("N\0\0\0", 4), 1, 0, 0, 1},
    {"mN", 1e-3, 0, 0, 1},
    {"nN", 1e-9, 0, 0, 1},
    {"MN", 1e6, 0, 0, 1},
    {"kN", 1e3, 0, 0, 1},
    {"KN", 1e3, 0, 0, 1},
    {"kn", 1e3, 0, 0, 1},
    {"daN", 10, 0, 0, 1},
    {"DAN", 10, 0, 0, 1},
    {"dan", 10, 0, 0, 1},
    {"µN", 1e-6, 0, 0, 1},
    {"lbf", lbf, 0, 0, 1},
    {"LBF", lbf, 0, 0, 1},
    {"Lbf", lbf, 0, 0, 1},
    {"lb", lbf, 0, 0, 1},
    {"LB", lbf, 0, 0, 1},
    {"lb.", lbf, 0, 0, 1},
    {"lbs", lbf, 0, 0, 1},
    {"LBS", lbf, 0, 0, 1},
    {"pounds", lbf, 0, 0, 1},
    {"pound-force", lbf, 0, 0, 1},
    {"kip", 1000 * lbf, 0, 0, 1},
    {"KIPS", 1000 * lbf, 0, 0, 1},
    {"klbf", 1000 * lbf, 0, 0, 1},
    {"ozf", lbf / 16, 0, 0, 1},
    {"oz", lbf / 16, 0, 0, 1},
    {"kgf", g, 0, 0, 1},
    {"KGF", g, 0, 0, 1},
    {"kp", g, 0, 0, 1},
    {"Kilopond", g, 0, 0, 1},
    {"gf", 1e-3 * g, 0, 0, 1},
    {"dyn", 1e-5, 0, 0, 1},
    {"dynes", 1e-5, 0, 0, 1},
    {"pdl", 0.45359237 * foot, 0, 0, 1},
    {"kg*m/s^2", 1, 0, 0, 1},
    {"Nm", 1, 1, 0, 1},
    {"N-m", 1, 1, 0, 1},
    {"N.m", 1, 1, 0, 1},
    {"N*mm", 1e-3, 1, 0, 1},
    {"lbf-in", lbf* inch, 1, 0, 1},
    {"in-lb", lbf* inch, 1, 0, 1},
    {"ft-lbf", lbf* foot, 1, 0, 1},
    {"FT-LBS", lbf* foot, 1, 0, 1},
};

const std::vector<Label> ratios = {
    {"m/N", 1, 1, 0, -1},
    {"mm/N", 1e-3, 1, 0, -1},
    {"(mm)/(N)", 1e-3, 1, 0, -1},
    {"in/lbf", inch / lbf, 1, 0, -1},
    {"IN/LB", inch / lbf, 1, 0, -1},
    {"mil/lbf", 1e-3 * inch / lbf, 1, 0, -1},
    {"um/N", 1e-6, 1, 0, -1},
    {"mm/kN", 1e-6, 1, 0, -1},
    {"m/s/N", 1, 1, -1, -1},
    {"(mm/s)/N", 1e-3, 1, -1, -1},
    {"in/s/lbf", inch / lbf, 1, -1, -1},
    {"g/N", g, 1, -2, -1},
    {"G/N", g, 1, -2, -1},
    {"g/lbf", g / lbf, 1, -2, -1},
    {"G/LBF", g / lbf, 1, -2, -1},
    {"g rms/lbf rms", g / lbf, 1, -2, -1},
    {"g rms/N", g, 1, -2, -1},
    {"g/kN", 1e-3 * g, 1, -2, -1},
    {"(m/s²)/N", 1, 1, -2, -1},
    {"(M/S^2)/N", 1, 1, -2, -1},
    {"[m/s²]/[N]", 1, 1, -2, -1},
    {"m/s^2/N", 1, 1, -2, -1},
    {"m/(s^2*N)", 1, 1, -2, -1},
    {"m/(s^2 N)", 1, 1, -2, -1},
    {"(m/s^2) / N", 1, 1, -2, -1},
    {"mm·s⁻²·N⁻¹", 1e-3, 1, -2, -1},
    {"g*N/N^2", g, 1, -2, -1},
    {"mm/s^2/mN", 1, 1, -2, -1},
    {"in/s^2/lb", inch / lbf, 1, -2, -1},
    {"1/kg", 1, 1, -2, -1},
    {"1/lbm", 1 / 0.45359237, 1, -2, -1},
    {"s/kg", 1, 1, -1, -1},
    {"m/Ns", 1, 1, -1, -1},
    {"m/(Ns)", 1, 1, -1, -1},
    {"mm/(N s)", 1e-3, 1, -1, -1},
    {"m/Nsec", 1, 1, -1, -1},
    {"rad/Nm", 1, -1, 0, -1},
    {"rad/(N*m)", 1, -1, 0, -1},
};

/// Not understood, whatever stands for them.
const std::vector<std::string> refused = {
    "(H) (m/s^2/N)",
    "",
    " ",
    "NONE",
    "none",
    "V",
    "mV",
    "Volts",
    "V/N",
    "V/V",
    "mV/g",
    "g/V",
    "counts",
    "COUNTS",
    "cnt",
    "EU",
    "eu/N",
    "dB",
    "dB/N",
    "dB re 1",
    "Pa",
    "kPa",
    "Pa/N",
    "psi",
    "µε",
    "ue",
    "uE",
    "strain",
    "%",
    "pC",
    "A",
    "mA",
    "W",
    "K",
    "degC",
    "T",
    "10 N",
    "100 g",
    "1e-3 m",
    "10^-6 m/N",
    "2*m/N",
    "m//N",
    "m/N)",
    "(m/N",
    "m^/N",
    "m^99/N",
    "m 2/N",
    "m/s?",
    "mn",
    "Mn",
    "NM",
    "nM",
    "Nn",
    "NN",
    "nn",
    "m/NS",
    "NS",
    "nS",
    "NSEC",
    "GN",
    "g/GN",
    "Mm",
    "Mm/N",
    "Mm/s^2",
    "Mg",
    "Mg/N",
    "Ms",
    "Mrad",
    "mHZ",
    "Mhz",
    "MNm",
    "mNm",
    "mhz",
    "MHZ",
    "MM/MN",
    "M/S^2/MN",
    "g rms/N pk",
    "mm pk-pk/N rms",
    "tonf",
    "ton",
    "xyz",
    "m/s^2.5",
    "m/s^",
    "/N",
    "N/A",
    "n/a",
    "m/s^2,N",
    "-",
    "?",
    "#",
    "unknown",
    "r/min/N",
    "m-",
    "m/-s",
    std::string("\0\0\0", 3),
};

void expect_understood(const std::vector<Label>& labels) {
  for (const Label& each : labels) {
    const auto unit = parse_unit(each.text);
    ASSERT_TRUE(unit) << each.text << ": " << unit_hint(each.text);
    EXPECT_NEAR(unit->si / each.si, 1.0, 1e-14) << each.text;
    EXPECT_TRUE(unit->same_dimension({1.0, each.length, each.time, each.force})) << each.text;
    EXPECT_EQ(unit_hint(each.text), "") << each.text;
  }
}

TEST(UnitLabels, TwoHundredHaveTheirFactors) {
  EXPECT_GE(accelerations.size() + motions.size() + forces.size() + ratios.size(), 200u);
  expect_understood(accelerations);
  expect_understood(motions);
  expect_understood(forces);
  expect_understood(ratios);
}

TEST(UnitLabels, WhatIsNoUnitIsRefused) {
  for (const std::string& label : refused) EXPECT_FALSE(parse_unit(label)) << label;
}

TEST(UnitLabels, AmplitudesAreKeptBesideTheFactor) {
  EXPECT_EQ(parse_unit("g rms")->amplitude, Amplitude::rms);
  EXPECT_EQ(parse_unit("mm/s eff")->amplitude, Amplitude::rms);
  EXPECT_EQ(parse_unit("mil pk-pk")->amplitude, Amplitude::peak_to_peak);
  EXPECT_EQ(parse_unit("Npk")->amplitude, Amplitude::peak);
  EXPECT_EQ(parse_unit("g")->amplitude, Amplitude::unstated);
  EXPECT_EQ(unit_hint("g rms/N pk"), "it mixes rms values and peaks");
}

TEST(UnitLabels, OnlyBlankAndNoneStateNothing) {
  for (const std::string& label : {std::string(), std::string("  "), std::string("NONE"), std::string(" None "),
                                   std::string("\0\0", 2), std::string("NONE\0\0", 6)})
    EXPECT_TRUE(states_no_unit(label)) << label;
  for (const char* label : {"V", "-", "1", "EU", "unknown"}) EXPECT_FALSE(states_no_unit(label)) << label;
}

TEST(UnitLabels, TimesInSeconds) {
  const std::vector<std::pair<std::string, double>> labels = {
      {"s", 1},       {"S", 1},        {"sec", 1},     {"Sec.", 1},    {"SECONDS", 1}, {"seconds", 1},  {"ms", 1e-3},
      {"msec", 1e-3}, {"MSEC", 1e-3},  {"mSec", 1e-3}, {"us", 1e-6},   {"µs", 1e-6},   {"\xB5s", 1e-6}, {"usec", 1e-6},
      {"min", 60},    {"minutes", 60}, {"h", 3600},    {"[ms]", 1e-3}, {"(s)", 1},     {"ns", 1e-9},    {"Milliseconds", 1e-3}};
  for (const auto& [label, factor] : labels) EXPECT_DOUBLE_EQ(seconds_per(label).value_or(0.0), factor) << label;
  for (const char* label : {"", "NONE", "  "}) EXPECT_FALSE(seconds_per(label)) << label;
  for (const char* label : {"m", "Hz", "samples", "V", "1", "date"})
    EXPECT_THAT(message_of([&] { seconds_per(label); }),
                HasSubstr(std::string("'") + label + "' is no unit of time that is known"))
        << label;
}

TEST(UnitLabels, FrequenciesInHertz) {
  const double pi = 3.14159265358979323846;
  const std::vector<std::pair<std::string, double>> labels = {{"Hz", 1},
                                                              {"hz", 1},
                                                              {"HZ", 1},
                                                              {"Hertz", 1},
                                                              {"cps", 1},
                                                              {"c/s", 1},
                                                              {"cycles/sec", 1},
                                                              {"kHz", 1e3},
                                                              {"KHz", 1e3},
                                                              {"KHZ", 1e3},
                                                              {"khz", 1e3},
                                                              {"mHz", 1e-3},
                                                              {"MHz", 1e6},
                                                              {"rpm", 1.0 / 60},
                                                              {"RPM", 1.0 / 60},
                                                              {"cpm", 1.0 / 60},
                                                              {"1/min", 1.0 / 60},
                                                              {"min^-1", 1.0 / 60},
                                                              {"r/min", 1.0 / 60},
                                                              {"rev/min", 1.0 / 60},
                                                              {"cycles per minute", 1.0 / 60},
                                                              {"rad/s", 0.5 / pi},
                                                              {"rad/sec", 0.5 / pi},
                                                              {"RAD/SEC", 0.5 / pi},
                                                              {"radians/second", 0.5 / pi},
                                                              {"rad·s⁻¹", 0.5 / pi},
                                                              {"krad/s", 500 / pi},
                                                              {"deg/s", 1.0 / 360},
                                                              {"rev/s", 1},
                                                              {"[Hz]", 1}};
  for (const auto& [label, factor] : labels) EXPECT_NEAR(hertz_per(label).value_or(0.0) / factor, 1.0, 1e-15) << label;
  EXPECT_EQ(hertz_per("kHz"), 1000.0);
  for (const char* label : {"", "NONE", "none"}) EXPECT_FALSE(hertz_per(label)) << label;
  for (const char* label : {"s", "1/s", "order", "MHZ", "mhz", "1/m", "Octave", "V"})
    EXPECT_THAT(message_of([&] { hertz_per(label); }),
                HasSubstr(std::string("'") + label + "' is no unit of frequency that is known"))
        << label;
}

TEST(UnitLabels, AnUnknownOneGetsAProposalOrAReason) {
  const std::vector<std::pair<std::string, std::string>> hints = {{"mm/sce^2", ""},
                                                                  {"mm/secs", ""},
                                                                  {"Newtn", "did you mean 'newton'?"},
                                                                  {"metr/s", "did you mean 'meter/s'?"},
                                                                  {"m/s?", "did you mean 'm/s^2'?"},
                                                                  {"?m/s", "did you mean 'um/s'?"},
                                                                  {"lbff", "did you mean 'lbf'?"},
                                                                  {"V", "V is a voltage"},
                                                                  {"mV/N", "mV is a voltage"},
                                                                  {"Pa/N", "Pa is a pressure"},
                                                                  {"ue", "ue is a strain"},
                                                                  {"counts", "counts is the reading of a converter"},
                                                                  {"Nn", "'Nn' is not 'nN': small and capital letters count"},
                                                                  {"Mm/s", "'Mm' is not 'mm': small and capital letters count"},
                                                                  {"mn", "mN may be mN or MN where case was lost"},
                                                                  {"MM/MN", "MN may be MN or mN where case was lost"}};
  for (const auto& [label, hint] : hints) EXPECT_EQ(unit_hint(label), hint) << label;
  EXPECT_THAT(message_of([] { si_factor("V/N", Quantity::receptance); }),
              HasSubstr("unknown unit 'V/N'; write m/N, or another product of m cm mm"));
  EXPECT_THAT(message_of([] { si_factor("V/N", Quantity::receptance); }), HasSubstr("V is a voltage"));
  EXPECT_THAT(message_of([] { si_factor("mm/Newtn", Quantity::receptance); }),
              HasSubstr("did you mean 'mm/newton'? Or write m/N"));
}

TEST(UnitLabels, AreShownInOneLineAndInUtf8) {
  EXPECT_EQ(shown_label(" m/s\xB2\0\0"), "m/s²");
  EXPECT_EQ(shown_label(std::string(200, 'x')), std::string(64, 'x') + "…");
  const std::string message = message_of([] { si_factor("m\n\x1A\x1B[31mN", Quantity::receptance); });
  EXPECT_THAT(message, HasSubstr("unknown unit 'm\\n\\x1A\\x1B[31mN'"));
}

}  // namespace
}  // namespace jointid::frf
