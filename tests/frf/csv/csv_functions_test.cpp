// Titles and cells that other programs write of functions of FRFs: |H|, arg(H), quantities over their units, cis; columns that
// number their FRFs; UTF-16 without a mark. Accelerances of 2 − 1i and 3 + 4i m/(s²·N) at 10 and 20 Hz where nothing else is said.
#include <gmock/gmock.h>

#include <array>
#include <numbers>
#include <utility>

#include "frf/csv/csv_numbered.hpp"
#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double gravity = 9.80665;

OpenOptions points(const std::vector<std::string>& response, const std::vector<std::string>& reference) {
  OpenOptions options;
  options.response = dofs(response), options.reference = dofs(reference);
  options.quantity = Quantity::accelerance;
  return options;
}

class CsvFunctions : public FileTest {
 protected:
  FrfSet read(const std::string& content, const OpenOptions& options) const {
    try {
      return load(*open(write_file("a.csv", content), options));
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what() << "\n" << content;
      return {};
    }
  }
  void expect_right(const std::string& content, double unit = 1.0) const {
    const FrfSet set = read(content, points({"1:+Z"}, {"1:+Z"}));
    ASSERT_EQ(set.header.lines(), 2U) << content;
    const std::array<Complex, 2> right = {Complex(2.0, -1.0), Complex(3.0, 4.0)};
    for (std::size_t l = 0; l < 2; ++l) {
      const double hz = 10.0 * static_cast<double>(l + 1), omega = 2.0 * std::numbers::pi * hz;
      EXPECT_NEAR(set.header.frequency_hz[l], hz, 1e-12 * hz) << content;
      EXPECT_LE(std::abs(set.values[l] + unit * right[l] / (omega * omega)), 1e-11 * std::abs(set.values[l])) << content;
    }
  }
  std::string error(const std::string& content, const OpenOptions& options = points({"1:+Z"}, {"1:+Z"})) const {
    return message_of([&] { open(write_file("a.csv", content), options); });
  }
};

const std::string parts = "10,2,-1\n20,3,4\n", polar_numbers = "10,2.23606797749979,-26.56505117707799\n20,5,53.13010235415598\n";

TEST_F(CsvFunctions, TitlesOfPartsAsFunctions) {
  for (const char* titles : {"Re{H},Im{H}", "Re[H],Im[H]", "ℜ(H),ℑ(H)", "H_real,H_imag", "H11.re,H11.im", "re_H,im_H",
                             "Parte reale,Parte immaginaria", "Re(a/F) [m/s^2/N],Im(a/F) [m/s^2/N]", "FRF 1/2 (Real),FRF 1/2 (Imag)"})
    expect_right("Frequency [Hz]," + std::string(titles) + "\n" + parts);
  for (const char* titles : {"|H|,arg(H) [deg]", "|H11|,∠H11 [°]", "abs(H),angle(H) (deg)", "mag(H),ph(H) [deg]", "|H|,φ [°]",
                             "Modulus,Argument (deg)", "FRF (Amplitude),FRF (Phase) (deg)"})
    expect_right("Frequency [Hz]," + std::string(titles) + "\n" + polar_numbers);
  expect_right("Frequency (Hz),|1:+Z/1:+Z| [g/N],arg(1:+Z/1:+Z) [deg]\n" + polar_numbers, gravity);
  expect_right("Frequenz [Hz],Betrag [g/N],Phase [Grad]\n" + polar_numbers, gravity);
}

TEST_F(CsvFunctions, QuantitiesOverTheirUnits) {
  for (const char* axis : {"f/Hz", "f / Hz", "f in Hz", "Frequency/Hz", "Freq. in Hz", "f_Hz", "freq.Hz", "ν / Hz"})
    expect_right(std::string(axis) + ",Re H11/(g/N),Im H11/(g/N)\n" + parts, gravity);
  expect_right("f/Hz;Re{H11}/(m/(s²·N));Im{H11}/(m/(s²·N))\n10;2;-1\n20;3;4\n");
  expect_right("f/Hz;|H11|/(m/s2/N);arg(H11)/°\n10;2,23606797749979;-26,56505117707799\n20;5,0;53,13010235415598\n");
  expect_right("f/Hz;H11 Re in g/N;H11 Im in g/N\n10;2;-1\n20;3;4\n", gravity);
  expect_right("f/Hz;H11/(m/s2/N)\n10;2-1j\n20;3+4j\n");
  expect_right("ω/(rad/s);Re H;Im H\n62.83185307179586;2;-1\n125.66370614359172;3;4\n");
  EXPECT_THAT(error("f/Hz,Re(a/F)/(V/N),Im(a/F)/(V/N)\n" + parts), AllOf(HasSubstr("column 2"), HasSubstr("'V/N'")));
  EXPECT_THAT(error("f/Hz,|H|/dB,φ/°\n" + polar_numbers), HasSubstr("dB"));
  EXPECT_THAT(error("ω/Hz,Re H,Im H\n" + parts), HasSubstr("the first column is 'ω/Hz'"));
}

TEST_F(CsvFunctions, WhatIsNoFrfItselfIsRefused) {
  for (const auto& [titles, named] :
       {std::pair("Re(conj(H)),Im(conj(H))", "of the conjugate of an FRF"), std::pair("Re(1/H),Im(1/H)", "of the inverse"),
        std::pair("Re(H),-Im(H)", "'-Im'"), std::pair("log10(Real),log10(Imag)", "of the logarithm")})
    EXPECT_THAT(error("Frequency," + std::string(titles) + "\n" + parts), HasSubstr(named));
  for (const auto& [titles, named] :
       {std::pair("|H|^2,arg(H) [deg]", "'|H|^2' is not a column"), std::pair("Magnitude,Phase lag [deg]", "of the negative"),
        std::pair("|H|,arg(H)", "degrees or radians"), std::pair("|H|,arg(H) [rev]", "the unit 'rev'"),
        std::pair("Magnitude,Phase [grad]", "degrees or gon")})
    EXPECT_THAT(error("Frequency," + std::string(titles) + "\n" + polar_numbers), HasSubstr(named));
}

TEST_F(CsvFunctions, PolarAndComplexCells) {
  const std::string titles = "frequency_hz,1:+Z/1:+Z (mag∠phase)\n", first = "10,2.23606797749979", second = "\n20,5";
  for (const auto& [sign, unit] : {std::pair(" cis ", "°"), std::pair(" angle ", " deg"), std::pair(" at ", " deg"), std::pair("<", "°")})
    expect_right(titles + first + sign + "-26.56505117707799" + unit + second + sign + "53.13010235415598" + unit + "\n");
  expect_right(titles + first + "*cis(-0.4636476090008061 rad)" + second + " cis(0.9272952180016122 rad)\n");
  const FrfSet near_pi = read(titles + "10,1 cis(3.1)\n", points({"1:+Z"}, {"1:+Z"}));
  ASSERT_EQ(near_pi.values.size(), 1U);
  EXPECT_NEAR(std::arg(-near_pi.values[0]), 3.1, 1e-12);
  for (const char* open : {"10,1 cis(0.7)\n", "10,1 cis(40)\n", "10,1<0.7\n"})
    EXPECT_THAT(error(titles + open), HasSubstr("line 2, column 2: an angle does not state whether"));
  const std::string plain = "frequency_hz;1:+Z/1:+Z\n";
  expect_right(plain + "10;complex(2.0,-1.0)\n20;Complex(3.0, 4.0)\n");
  expect_right(plain + "10;np.complex128(2-1j)\n20;np.complex128(3+4j)\n");
  expect_right(plain + "10;2.*^0 - 1.*^0 I\n20;0.3*^1 + 4 I\n");
}

/// The four FRFs are 11, 12, 21 and 22 by the numbers of their titles.
TEST_F(CsvFunctions, NumberedColumnsAreOfTheFrfsThatTheySay) {
  for (const char* table : {"f/Hz,H11,H21,H12,H22\n10,11+0j,21+0j,12+0j,22+0j\n",
                            "f/Hz;H_2_2;H_1_2;H_2_1;H_1_1\n10;22+0j;12+0j;21+0j;11+0j\n",
                            "f/Hz,Re(H11),Re(H12),Re(H21),Re(H22),Im(H11),Im(H12),Im(H21),Im(H22)\n10,11,12,21,22,0,0,0,0\n"}) {
    const FrfSet set = read(table, points({"8:+X", "9:+X"}, {"8:+X", "9:+X"}));
    ASSERT_EQ(set.values.size(), 4U);
    for (std::size_t r = 0; r < 2; ++r) {
      for (std::size_t c = 0; c < 2; ++c)
        EXPECT_NEAR(-std::real(set.values[set.index(0, r, c)]) * std::pow(20.0 * std::numbers::pi, 2.0),
                    static_cast<double>(11 + 10 * r + c), 1e-9);
    }
  }
  EXPECT_THAT(error("f/Hz,Re(H11),Re(H21),Im(H21),Im(H11)\n10,1,2,3,4\n", points({"1:+X", "2:+X"}, {"1:+X"})),
              HasSubstr("the parts of H11 and H21 are in different orders"));
  EXPECT_THAT(error("f/Hz,H31,H21\n10,1+0j,2+0j\n", points({"8:+X", "9:+X"}, {"8:+X"})),
              HasSubstr("H31 … H21 do not state which FRF is of which of the DOFs"));
}

TEST(NumberedLabels, ReadByNodesOrInOrder) {
  using Place = std::pair<std::size_t, std::size_t>;
  const std::vector<Dof> up = dofs({"1:+Z", "2:+Z"}), down = dofs({"2:+Z", "1:+Z"}), other = dofs({"31:+Z", "21:+Z"});
  EXPECT_EQ(places_of_labels({"H21", "H11"}, up, dofs({"1:+Z"})), (std::vector<std::optional<Place>>{Place{1, 0}, Place{0, 0}}));
  EXPECT_EQ(places_of_labels({"H21", "H11"}, down, dofs({"1:+Z"})), std::vector<std::optional<Place>>(2));  // node or place
  EXPECT_EQ(places_of_labels({"H(21,5)", "H(31,5)"}, other, dofs({"5:+Z"})),
            (std::vector<std::optional<Place>>{Place{1, 0}, Place{0, 0}}));
  EXPECT_TRUE(places_of_labels({"H1", "H2"}, up, dofs({"1:+Z"})).empty());
  for (const char* turned : {"H1->2", "ref1 resp2", "in1out2", "Impact 1 Sensor 2", "F1A2"})
    EXPECT_EQ(places_of_labels({turned, "H11"}, up, up), (std::vector<std::optional<Place>>{Place{1, 0}, Place{0, 0}})) << turned;
  EXPECT_EQ(places_of_labels({"H3", "H2"}, up, dofs({"1:+Z"})), std::vector<std::optional<Place>>(2));
  for (const auto& [first, second] : {std::pair("H10", "H00"), std::pair("2|1", "1|1"), std::pair("2 1", "1 1")})
    EXPECT_EQ(places_of_labels({first, second}, up, up), (std::vector<std::optional<Place>>{Place{1, 0}, Place{0, 0}})) << first;
}

TEST_F(CsvFunctions, FactorsOfTitlesAreErrors) {
  EXPECT_THAT(error("Frequency [Hz],Real x1000 [g/N],Imag x1000 [g/N]\n10,1,2\n20,3,4\n", points({"1:+X"}, {"1:+X"})),
              HasSubstr("'Real x1000 [g/N]' states a factor, which is not applied"));
}

/// H(f_s − f) = H*(f), whose upper half is no FRF.
TEST_F(CsvFunctions, SpectraFromZeroToTheSamplingRateAreErrors) {
  const auto table = [](bool from_zero, bool mirrored) {
    constexpr int lines = 40;
    std::string text = "Frequency [Hz],1:+X/1:+X re [m/N],1:+X/1:+X im [m/N]\n";
    for (int k = from_zero ? 0 : 1; k < lines; ++k) {
      const int of = mirrored && 2 * k > lines ? lines - k : k;
      const std::complex<double> value = 1.0 / std::complex<double>(64.0 - of * of, of);
      text += std::to_string(k) + "," + std::to_string(value.real()) + "," + std::to_string(of == k ? value.imag() : -value.imag()) + "\n";
    }
    return text;
  };
  for (const bool from_zero : {true, false}) {
    EXPECT_THAT(message_of([&] { open(write_file("m.csv", table(from_zero, true))); }), HasSubstr("export the lines up to half"));
    EXPECT_NO_THROW(open(write_file("m.csv", table(from_zero, false))));
  }
}

TEST_F(CsvFunctions, Utf16WithoutAMark) {
  const std::string table = "Frequency [Hz];Re(H) [m/s^2/N];Im(H) [m/s^2/N]\r\n10;2,0;-1,0\r\n20;3,0;4,0\r\n";
  for (const bool little : {true, false}) {
    std::string wide;
    for (const char c : table) wide += little ? std::string{c, '\0'} : std::string{'\0', c};
    expect_right(wide);
    expect_right(wide + std::string(64, '\0'));
  }
}

}  // namespace
}  // namespace jointid::frf
