// What comments and free lines say of units and factors, rows of units and parts around the titles, and words of other languages.
// Accelerances of 2 − 1i and 3 + 4i m/(s²·N) at 10 and 20 Hz in every file.
#include <gmock/gmock.h>

#include <numbers>

#include "frf/csv/csv_parts.hpp"
#include "frf/csv/csv_titles.hpp"
#include "frf/text/remarks.hpp"
#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double gn = 9.80665;
const std::string two_lines = "10,2,-1\n20,3,4\n";
const std::string polar = "10,2.23606797749979,-26.56505117707799\n20,5,53.13010235415598\n";

class CsvRemarks : public FileTest {
 protected:
  static OpenOptions options(const std::string& unit = {}) {
    OpenOptions given;
    given.response = given.reference = dofs({"1:+Z"});
    given.quantity = Quantity::accelerance;
    given.unit = unit;
    return given;
  }
  FrfSet read(const std::string& content, const OpenOptions& given = options()) const {
    try {
      return load(*open(write_file("a.csv", content), given));
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what() << "\n" << content;
      return {};
    }
  }
  FrfSet expect_right(const std::string& content, double unit = 1.0, const OpenOptions& given = options()) const {
    FrfSet set = read(content, given);
    const std::array<Complex, 2> right = {Complex(2.0, -1.0), Complex(3.0, 4.0)};
    EXPECT_EQ(set.values.size(), 2U) << content;
    for (std::size_t l = 0; l < set.values.size(); ++l) {
      const double omega = 20.0 * std::numbers::pi * static_cast<double>(l + 1);
      EXPECT_LE(std::abs(set.values[l] + unit * right[l] / (omega * omega)), 1e-12 * std::abs(set.values[l])) << content;
    }
    return set;
  }
  std::string error(const std::string& content) const {
    return message_of([&] { open(write_file("a.csv", content), options()); });
  }
};

TEST_F(CsvRemarks, UnitsThatNothingReadsAreErrors) {
  for (const auto& [remark, unit] :
       {std::pair("# All values are in g/N.", "g/N"), std::pair("Exported accelerances (mm/s^2/N) of run 3", "mm/s^2/N"),
        std::pair("# FRF in g per newton.", "g per newton"), std::pair("# acceleration in g", "g"),
        std::pair("# force in lbf", "lbf"), std::pair("Channel 2,Acceleration,g", "g"), std::pair("Channel 1;Force;lbf", "lbf"),
        std::pair("# mm, N, s", "mm, N, s")}) {
    const std::string text = std::string(remark) + "\nFrequency [Hz],Real,Imag\n" + two_lines;
    EXPECT_THAT(error(text), AllOf(HasSubstr("line 1: states the unit '" + std::string(unit) + "'"), HasSubstr("--unit")))
        << remark;
    expect_right(text, 1.0, options("m/(s^2*N)"));
    expect_right(std::string(remark) + "\nFrequency [Hz],Real [g/N],Imag [g/N]\n" + two_lines, gn);
  }
  for (const char* remark : {"# force in N", "Operator,G", "# 12/24 channels", "Channel 1,Force,N", "Date,01/02/2024",
                             "# m, N, s", "# positions in mm", "Hammer tip,steel", "Range: 5 V"})
    expect_right(std::string(remark) + "\nFrequency [Hz],Real,Imag\n" + two_lines);
}

TEST_F(CsvRemarks, FactorsThatAreNotAppliedAreNoted) {
  const std::string table = "Frequency [Hz],Real [m/s^2/N],Imag [m/s^2/N]\n" + two_lines;
  for (const char* name :
       {"gain", "Sensitivity (mV/g)", "calibration", "Window correction", "Empfindlichkeit", "Verstärkung", "weight"}) {
    for (const char* before : {"# ", ""}) {
      const FrfSet set = expect_right(before + std::string(name) + ": 2.5\n" + table);
      EXPECT_THAT(set.header.doubts,
                  ElementsAre(AllOf(HasSubstr("line 1 states '" + std::string(name) + " = 2.5'"), HasSubstr("not applied"))));
    }
  }
  for (const char* line : {"# gain: 1", "# sensitivity: 100 mV/g", "# loss factor: 0.02", "# temperature: 21.5", "Averages,10"})
    EXPECT_THAT(expect_right(std::string(line) + "\n" + table).header.doubts, IsEmpty()) << line;
  for (const char* line : {"# Skalierung = 2.5", "# Faktor = 2.5"})
    EXPECT_THAT(error(std::string(line) + "\n" + table), HasSubstr("states the factor 2.5"));
}

TEST_F(CsvRemarks, UnitsAboveTheTitlesAndPartsBelowThem) {
  expect_right("Hz,g/N,g/N\nFrequency,Real,Imag\n" + two_lines, gn);
  expect_right(
      "Source File Name:\tx\n\nFrequency\tVib & Ref1 H1 Acceleration / Force\t\n\tReal\tImaginary\n[ Hz ]\t[ mm/s² / N ]\t[ "
      "mm/s² / N ]\n"
      "10\t2\t-1\n20\t3\t4\n",
      1e-3);
  OpenOptions two = options();
  two.response = dofs({"1:+Z", "2:+Z"});
  const FrfSet set = read(
      "Frequency,Point 1,,Point 2,\n,Real,Imaginary,Real,Imaginary\nHz,m/s²/N,m/s²/N,m/s²/N,m/s²/N\n10,1,2,3,4\n20,1,2,3,4\n",
      two);
  ASSERT_EQ(set.values.size(), 4U);
  EXPECT_NEAR(std::abs(set.values[1] / set.values[0]), std::sqrt(5.0), 1e-12);
}

TEST_F(CsvRemarks, TitlesOfOtherLanguages) {
  for (const char* titles :
       {"Re H11,Im H11,Coh H11", "Re(H11),Im(H11),Coh(H11)", "H11_re,H11_im,H11_coh", "Realteil,Imaginärteil,Kohärenz",
        "Reell,Imaginär,γ²", "Réel,Imaginaire,Cohérence", "Reale,Immaginario,gamma2", "Re.,Im.,Coh"}) {
    const FrfSet set = expect_right("Frequency," + std::string(titles) + "\n10,2,-1,0.5\n20,3,4,0.25\n");
    EXPECT_THAT(set.coherence, ElementsAre(0.5, 0.25)) << titles;
  }
  for (const char* titles : {"Ampl.,Ph. [deg]", "Ampiezza,Fase [gradi]", "Mag.,Phase [degrés]", "Amp,Phasenlage [Deg.]",
                             "Amplitud,Fase [grados]", "LinMag,Phase [graden]", "Mag,Phase [stopni]"})
    expect_right("Frequency," + std::string(titles) + "\n" + polar);
  expect_right("Frequenz in Hz;Betrag in m/s²/N;Phase in Grad\n10;2,23606797749979;-26,56505117707799\n20;5;53,13010235415598\n");
  expect_right("Frequency,Mag,Fase [radianti]\n10,2.23606797749979,-0.4636476090008061\n20,5,0.9272952180016122\n");
  expect_right("\"Frequency, Hz\",\"H1,2 Real, g/N\",\"H1,2 Imag, g/N\"\n" + two_lines, gn);
}

TEST(FrequencyTitles, AnyNameOverAUnitOfFrequencies) {
  for (const auto& [cell, unit] :
       {std::pair("частота [Hz]", "Hz"), std::pair("Abscissa (kHz)", "kHz"), std::pair("Pulsation [rad/s]", "rad/s"),
        std::pair("X [Hz]", "Hz"), std::pair("Kreisfrequenz", "rad/s"), std::pair("angular frequency", "rad/s")}) {
    ASSERT_TRUE(frequency_title(cell)) << cell;
    EXPECT_EQ(frequency_title(cell)->unit, unit) << cell;
  }
  for (const char* cell :
       {"Speed [rpm]", "Sample rate [Hz]", "log10(f) [Hz]", "Frequency ratio [-]", "f resolution [Hz]", "Time [s]", "Bin"})
    EXPECT_FALSE(frequency_title(cell)) << cell;
}

TEST_F(CsvRemarks, WhatATitleSaysIsNotLeftOut) {
  for (const auto& [titles, named] : {std::pair("Real,Neg Imag", "of the negative of an FRF"),
                                      std::pair("Real normalized [m/s^2/N],Imag normalized [m/s^2/N]", "normalised"),
                                      std::pair("Real,Imag (e-iwt) [m/s^2/N]", "conjugates"),
                                      std::pair("Real (x 1e-3) [m/s^2/N],Imag (x 1e-3) [m/s^2/N]", "states a factor"),
                                      std::pair("Real (milli) [m/s^2/N],Imag (milli) [m/s^2/N]", "states a factor"),
                                      std::pair("Magnitude squared,Phase [deg]", "of the square")})
    EXPECT_THAT(error("Frequency," + std::string(titles) + "\n" + two_lines), HasSubstr(named)) << titles;
  EXPECT_THAT(error("Frequency,Mag,Phase [rad]\n10,1,179\n20,1,-179\n"), HasSubstr("is it in degrees?"));
  EXPECT_EQ(read("Frequency,Mag,Phase [rad]\n10,1,3.1\n20,1,-3.1\n30,1,-7\n").values.size(), 3U);
}

/// The unit is stated, so that the numbers are read; what speaks against them is a note.
TEST_F(CsvRemarks, WordsOfFactorsAndOfOtherUnitsAreNotes) {
  const std::string table = "# unit = m/s^2/N\nfrequency_hz,Real,Imag\n" + two_lines;
  for (const auto& [remark, note] :
       {std::pair("# Gain: 20 dB", "line 1 states 'Gain: 20 dB'; the FRFs are taken as they are"),
        std::pair("# calibration factor 1.02", "states 'calibration factor 1.02'"),
        std::pair("# values are x 1e-3", "states 'values are x 1e-3'"), std::pair("# not calibrated", "states 'not calibrated'"),
        std::pair("# raw ADC counts", "raw ADC counts"), std::pair("# inverse FRF", "inverse FRF"),
        std::pair("# acceleration in g", "line 1 states the unit 'g', and the FRFs are read in 'm/s^2/N'"),
        std::pair("# force in lbf", "states the unit 'lbf'"), std::pair("# Response: V, Reference: V", "states the unit 'V'"),
        std::pair("# frequencies in rad/s", "states the unit 'rad/s' of frequencies"),
        std::pair("# f in kHz", "states the unit 'kHz'")})
    EXPECT_THAT(expect_right(std::string(remark) + "\n" + table).header.doubts, ElementsAre(HasSubstr(note))) << remark;
  for (const char* remark : {"# calibration date: 12.03.2026", "# calibration valid until 2027", "# acceleration in m/s^2",
                             "# gain 1", "# frequencies in Hz", "# sensor type 4507, serial 31234", "# not a word of numbers"})
    EXPECT_THAT(expect_right(std::string(remark) + "\n" + table).header.doubts, IsEmpty()) << remark;
  EXPECT_THAT(expect_right("# sensitivity 10 mV/N\nfrequency_hz,Real,Imag\n" + two_lines).header.doubts,
              ElementsAre("line 1 states 'sensitivity 10 mV/N', and nothing the unit of the FRFs"));
  const std::string in_g = "# acceleration in g, force in N\nfrequency_hz,Real [g/N],Imag [g/N]\n" + two_lines;
  EXPECT_THAT(expect_right(in_g, gn).header.doubts, IsEmpty());
}

}  // namespace
}  // namespace jointid::frf
