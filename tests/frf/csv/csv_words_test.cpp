// Titles of tables in more of the words that other programs use. Accelerances of 2 − 1i and 3 + 4i m/(s²·N) at 10 and 20 Hz.
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

class CsvWords : public FileTest {
 protected:
  static OpenOptions given(const std::vector<std::string>& response = {"1:+Z"}, const std::vector<std::string>& reference = {"1:+Z"}) {
    OpenOptions options;
    options.response = dofs(response), options.reference = dofs(reference);
    options.quantity = Quantity::accelerance;
    return options;
  }
  static std::string numbers(double step) {
    return std::to_string(10.0 * step) + ",2,-1\n" + std::to_string(20.0 * step) + ",3,4\n";
  }
  void expect_right(const std::string& content, double unit = 1.0) const {
    try {
      const FrfSet set = load(*open(write_file("a.csv", content), given()));
      ASSERT_EQ(set.header.lines(), 2U) << content;
      const std::array<Complex, 2> right = {Complex(2.0, -1.0), Complex(3.0, 4.0)};
      for (std::size_t l = 0; l < 2; ++l) {
        const double hz = 10.0 * static_cast<double>(l + 1), omega = 2.0 * std::numbers::pi * hz;
        EXPECT_NEAR(set.header.frequency_hz[l], hz, 1e-6 * hz) << content;
        EXPECT_LE(std::abs(set.values[l] + unit * right[l] / (omega * omega)), 1e-5 * std::abs(set.values[l])) << content;
      }
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what() << "\n" << content;
    }
  }
  std::string error(const std::string& content, const OpenOptions& options = given()) const {
    return message_of([&] { open(write_file("a.csv", content), options); });
  }
};

TEST_F(CsvWords, OfFrequencies) {
  constexpr double turn = 2.0 * std::numbers::pi;
  for (const auto& [title, step] : std::to_array<std::pair<const char*, double>>(
           {{"f", 1.0}, {"fHz", 1.0}, {"f_Hz", 1.0}, {"FreqHz", 1.0}, {"fkHz", 1e-3},
            {"Frequency - Hz", 1.0}, {"Frequency_Hz_", 1.0}, {"周波数［Hz］", 1.0}, {"频率（kHz）", 1e-3}, {"omega_rad_s", turn},
            {"w_rad_per_s", turn},
            {"Kreisfrequenz [1/s]", turn}, {"Pulsation [s^-1]", turn}, {"omega", turn}, {"Omega [Hz]", 1.0}}))
    expect_right(std::string(title) + ",Re,Im\n" + numbers(step));
  for (const char* title : {"w", "W", "F", "om", "f/fn", "log f [Hz]", "Frequency ratio", "Frequency [1/s]", "omega_hz"})
    EXPECT_NE(error(std::string(title) + ",Re,Im\n" + numbers(1.0)), "") << title;
}

TEST_F(CsvWords, OfParts) {
  for (const char* titles :
       {"H_r,H_i", "H_R,H_I", "Hr,Hi", "H11_r,H11_i", "ReFRF,ImFRF", "ReH11,ImH11", "reH,imH", "HReal,HImag", "RealPart,ImagPart",
        "FRFre,FRFim", "realH,imaginaryH", "Re FRF,Im FRF", "实部,虚部", "Reëel,Imaginair", "Parte real,Parte imaginária"})
    expect_right("f [Hz]," + std::string(titles) + "\n" + numbers(1.0));
  for (const char* titles : {"H_r,G_i", "sensor,sensoi", "H_r,Im", "Pr,Qi"})
    EXPECT_THAT(error("f [Hz]," + std::string(titles) + "\n" + numbers(1.0)), HasSubstr("line 1, column 2")) << titles;
  const std::string polar = "10,2.2360680,-26.565051\n20,5,53.130102\n";
  for (const char* titles : {"Magnitud,Angle [deg]", "振幅,位相 [度]", "幅值,相位（deg）"})
    expect_right("f [Hz]," + std::string(titles) + "\n" + polar);
}

TEST_F(CsvWords, PairsAreOfTheFrfsThatTheirNumbersSay) {
  const FrfSet set = load(*open(write_file("a.csv", "f [Hz],ReH21,ReH11,ImH21,ImH11\n10,5,2,6,-1\n20,7,3,8,4\n"), given({"1:+Z", "2:+Z"})));
  EXPECT_NEAR(set.values[0].real() / set.values[0].imag(), -2.0, 1e-9);
  EXPECT_NEAR(set.values[1].real() / set.values[1].imag(), 5.0 / 6.0, 1e-9);
}

TEST_F(CsvWords, RowsOfTypes) {
  for (const char* row : {"DT_DOUBLE,DT_DOUBLE,DT_DOUBLE", "DT_DOUBLE,DT_FLOAT,DT_FLOAT", "double,double,double",
                          "(float64),(float64),(float64)", "REAL*8,REAL*8,REAL*8"}) {
    expect_right("Frequency [Hz],Real [g/N],Imag [g/N]\n" + std::string(row) + "\n" + numbers(1.0), 9.80665);
    expect_right("Frequency,Real,Imag\nHz,g/N,g/N\n" + std::string(row) + "\n" + numbers(1.0), 9.80665);
    expect_right("Frequency,Real,Imag\n" + std::string(row) + "\nkHz,g/N,g/N\n" + numbers(1e-3), 9.80665);
  }
  std::string tabs = "Frequency,Real,Imag\nHz,g/N,g/N\nDT_DOUBLE,DT_DOUBLE,DT_DOUBLE\n" + numbers(1.0);
  std::ranges::replace(tabs, ',', '\t');
  expect_right(tabs, 9.80665);
  EXPECT_THAT(error("Frequency,Real,Imag\ndouble,text,double\n" + numbers(1.0)), HasSubstr("double"));
}

TEST_F(CsvWords, OfWhatIsNoMotionOverForce) {
  for (const char* title : {"Dynamic stiffness Re,Dynamic stiffness Im", "Impedance real,Impedance imag",
                            "Apparent mass Re,Apparent mass Im", "Impedanz Re,Impedanz Im", "Transmissibility Re,Transmissibility Im",
                            "Cross spectrum Re,Cross spectrum Im"})
    EXPECT_THAT(error("f [Hz]," + std::string(title) + "\n" + numbers(1.0)),
                AllOf(HasSubstr("line 1, column 2"), HasSubstr("no FRF of motion over force"), HasSubstr("rename the column")))
        << title;
  EXPECT_THAT(error("f [Hz],Mag,Phase inverted [deg]\n" + numbers(1.0)), HasSubstr("is of the negative of an FRF"));
  for (const char* unit : {"V/V", "N/m", "%", "kg"}) {
    OpenOptions open_quantity = given();
    open_quantity.quantity.reset();
    EXPECT_THAT(error("f [Hz],Real [" + std::string(unit) + "],Imag [" + unit + "]\n" + numbers(1.0), open_quantity),
                AllOf(HasSubstr("line 1, column 2"), HasSubstr(unit)))
        << unit;
  }
}

TEST_F(CsvWords, DofsInsideLabels) {
  OpenOptions open_dofs = given();
  open_dofs.response.clear(), open_dofs.reference.clear();
  for (const char* label : {"FRF 2:+Z/1:-X", "H1(2:+Z,1:-X)", "FRF Point2:+Z/Point1:-X", "2:+Z/1:-X"}) {
    const std::string title = std::string(label), text = "f [Hz];" + title + " Re;" + title + " Im\n10;2;-1\n20;3;4\n";
    const FrfSet set = load(*open(write_file("a.csv", text), open_dofs));
    EXPECT_EQ(set.header.response, dofs({"2:+Z"})) << label;
    EXPECT_EQ(set.header.reference, dofs({"1:-X"})) << label;
  }
  for (const char* label : {"Ref 2:+Z/Resp 1:-X", "2:+Z 1:-X", "2:+Z/1:-X/3:+Z", "a/2:+Z,1:-X", "2:+Z-1:-X", "2:+Z/1:-Xy"})
    EXPECT_EQ(dofs_in(label), "") << label;
  expect_right("f [Hz],M#1 1Z:1Z Real,M#1 1Z:1Z Imag\n" + numbers(1.0));
  EXPECT_THAT(error("f [Hz],2:+Z/1:+Z Real,2:+Z/1:+Z Imag\n" + numbers(1.0)), HasSubstr("others are given"));
}

TEST_F(CsvWords, NumbersInBracketsBeforeAPart) {
  std::string text = "f [Hz];H(1,1) Re;H(1,1) Im;H(2,1) Re;H(2,1) Im\n10;2;-1;5;6\n20;3;4;7;8\n";
  const FrfSet set = load(*open(write_file("a.csv", text), given({"1:+Z", "2:+Z"})));
  EXPECT_NEAR(set.values[1].real() / set.values[1].imag(), 5.0 / 6.0, 1e-9);
}

}  // namespace
}  // namespace jointid::frf
