// What stands beside FRFs in files of named arrays and would be left out: factors, conjugates, orders of axes, labels of plots.
#include <gmock/gmock.h>

#include <numbers>

#include "frf/file/file_format.hpp"
#include "frf/mat/mat_axes.hpp"
#include "frf/text/remarks.hpp"
#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Files as GNU Octave's `save -text` writes them.
class NumbersBeside : public FileTest {
 protected:
  static std::string named(const std::string& name, double value) {
    return "# name: " + name + "\n# type: scalar\n" + std::to_string(value) + "\n\n\n";
  }
  static std::string named(const std::string& name, const std::string& value) {
    return "# name: " + name + "\n# type: string\n# elements: 1\n# length: " + std::to_string(value.size()) + "\n" + value +
           "\n\n\n";
  }
  /// 2 − 1i and 3 + 4i m/N at 10 and 20 Hz.
  std::string file(const std::string& beside) const {
    return "# name: f\n# type: range\n# base, limit, increment\n10 20 10\n\n\n" +
           std::string("# name: frf\n# type: complex matrix\n# rows: 2\n# columns: 1\n (2,-1)\n (3,4)\n\n\n") + beside;
  }
  OpenOptions options() const {
    OpenOptions given;
    given.response = given.reference = dofs({"1:+Z"});
    given.quantity = Quantity::receptance;
    return given;
  }
  FrfSet read(const std::string& beside) const { return load(*open(write_file("a.txt", file(beside)), options())); }
  std::string error(const std::string& beside) const {
    return message_of([&] { open(write_file("a.txt", file(beside)), options()); });
  }
};

TEST_F(NumbersBeside, AFactorThatNobodyAppliesIsAnError) {
  for (const char* name : {"scale",
                           "ScaleFactor",
                           "gain",
                           "calibration",
                           "sensitivity",
                           "sens_acc",
                           "y_scale",
                           "to_si",
                           "frf_gain",
                           "volts_per_eu",
                           "mV_per_g",
                           "ecf",
                           "EUFactor",
                           "unitfactor",
                           "m_per_in",
                           "volt_to_g",
                           "amplitude_correction",
                           "window_correction",
                           "fac",
                           "mult",
                           "divisor",
                           "preamp",
                           "Korrekturfaktor"}) {
    EXPECT_THAT(error(named(name, 0.5)),
                AllOf(HasSubstr(std::string("variable ") + name), HasSubstr("is 0.5 and is not applied to the FRFs"),
                      HasSubstr("store the FRFs multiplied by it and remove")))
        << name;
    EXPECT_THAT(error(named(name, std::string("0.5"))), HasSubstr("is 0.5 and is not applied")) << name;
  }
  EXPECT_THAT(error(named("offset", 3.0)), HasSubstr("store the FRFs with it"));
  EXPECT_THAT(error(named("note", std::string("multiply by 1e-3"))), HasSubstr("states the factor 0.001"));
}

TEST_F(NumbersBeside, AFactorOfOneAndNumbersOfOtherThingsAreRead) {
  const std::vector<Complex> right = {{2.0, -1.0}, {3.0, 4.0}};
  for (const char* name : {"scale", "gain", "sensitivity"}) EXPECT_EQ(read(named(name, 1.0)).values, right) << name;
  EXPECT_EQ(read(named("offset", 0.0)).values, right);
  for (const char* name : {"loss_factor", "dampingFactor", "time_scale", "fs", "mass", "averages", "plot_scale", "example"})
    EXPECT_EQ(read(named(name, 0.5)).values, right) << name;
  EXPECT_EQ(read(named("note", std::string("impact times 12"))).values, right);
}

/// Names that may be of a factor or of anything else.
TEST_F(NumbersBeside, OtherPositiveNumbersAreNoted) {
  for (const char* name : {"amp", "weight", "norm", "slope", "dB_ref", "coeff", "S", "vref", "alpha"})
    EXPECT_THAT(read(named(name, 2.5)).header.doubts,
                ElementsAre("numbers beside the FRFs are not applied to them: " + std::string(name) + " is 2.5"));
  for (const char* name :
       {"fs", "nfft", "zeta", "masses", "sensor_mass", "temperature", "SampleRate", "preload", "loss_factor", "overlap", "nodes"})
    EXPECT_THAT(read(named(name, 2.5)).header.doubts, IsEmpty()) << name;
  EXPECT_THAT(read(named("amp", 1.0) + named("level", -3.0)).header.doubts, IsEmpty());
}

TEST_F(NumbersBeside, OneOfEachChannelIsLikelyAFactor) {
  const auto two = [](const std::string& name) {
    return "# name: f\n# type: range\n# base, limit, increment\n10 30 10\n\n\n# name: frf\n# type: complex matrix\n# rows: 3\n# "
           "columns: 2\n"
           " (2,-1) (1,1)\n (3,4) (1,1)\n (5,4) (1,1)\n\n\n# name: " +
           name + "\n# type: matrix\n# rows: 1\n# columns: 2\n 2.5 3.5\n\n\n";
  };
  OpenOptions given = options();
  given.response = dofs({"1:+Z", "2:+Z"});
  for (const char* name : {"amp", "weights", "coeff", "norm"})
    EXPECT_THAT(message_of([&] { open(write_file("a.txt", two(name)), given); }),
                AllOf(HasSubstr(std::string("variable ") + name + ": holds 2 numbers that are not applied"),
                      HasSubstr("remove or rename")));
  EXPECT_THAT(load(*open(write_file("a.txt", two("v")), given)).header.doubts, ElementsAre(HasSubstr("v begins with 2.5")));
  EXPECT_THAT(load(*open(write_file("a.txt", two("channels")), given)).header.doubts, IsEmpty());
}

TEST_F(NumbersBeside, UnitsInSentencesAreNamed) {
  EXPECT_THAT(error(named("EU", std::string("g"))), HasSubstr("did you mean unit?"));
  for (const char* text : {"FRF in g/N, run 3", "accelerance (mm/s^2/N) of the beam", "accelerance in g per N"})
    EXPECT_THAT(error(named("description", std::string(text))),
                AllOf(HasSubstr("states the unit"), HasSubstr("did you mean unit?")))
        << text;
  for (const char* text : {"run 1/2 in m/N", "n/a", "and/or"})
    EXPECT_EQ(read(named("description", std::string(text))).values.size(), 2U) << text;
}

TEST_F(NumbersBeside, MagnitudesAndPhasesAsPartsAreNoted) {
  const auto doubts = [&](double last, double real) {
    std::string text =
        "# name: f\n# type: range\n# base, limit, increment\n10 200 10\n\n\n# name: frf\n# type: complex matrix\n# rows: 20\n# "
        "columns: 1\n";
    for (int k = 0; k < 20; ++k)
      text += " (" + std::to_string(k == 7 ? real : 1.0 + k) + "," + std::to_string(last * k / 19.0) + ")\n";
    return load(*open(write_file("a.txt", text + "\n\n"), options())).header.doubts;
  };
  for (const double half_turn : {3.14159, 179.5, -178.0})
    EXPECT_THAT(doubts(half_turn, 1.0), ElementsAre(HasSubstr("as if they were magnitudes and phases"))) << half_turn;
  for (const double other : {2.0, 4.0, 90.0, 181.0}) EXPECT_THAT(doubts(other, 1.0), IsEmpty()) << other;
  EXPECT_THAT(doubts(3.14159, -0.1), IsEmpty());
}

TEST_F(NumbersBeside, NamesOfFrequenciesSayTheirUnit) {
  const auto hz = [&](const std::string& name) {
    OpenOptions given = options();
    given.frequency_variable = name;
    const std::string text = file("");
    return load(*open(write_file("a.txt", "# name: " + name + text.substr(9)), given)).header.frequency_hz[0];
  };
  EXPECT_DOUBLE_EQ(hz("angular_frequency"), 10.0 / (2.0 * std::numbers::pi));
  EXPECT_DOUBLE_EQ(hz("circ_freq"), 10.0 / (2.0 * std::numbers::pi));
  EXPECT_DOUBLE_EQ(hz("freq_mHz"), 0.01);
  EXPECT_DOUBLE_EQ(hz("band"), 10.0);
  for (const char* name : {"log_freq", "freq_ratio", "freq_norm"})
    EXPECT_THAT(message_of([&] { hz(name); }),
                AllOf(HasSubstr("holds no frequencies by its name"), HasSubstr("--frequency-unit Hz")));
}

/// Where responses and references are as many and not the same, a transposed array looks the same.
TEST_F(NumbersBeside, SquareArraysWithoutAxesAreNoted) {
  std::string three =
      "# name: f\n# type: matrix\n# rows: 1\n# columns: 3\n 10 20 30\n\n\n# name: frf\n# type: complex matrix\n# ndims: 3\n 3 2 "
      "2\n";
  for (int k = 0; k < 12; ++k) three += " (" + std::to_string(k) + ",1)\n";
  three += "\n\n";
  OpenOptions given = options();
  given.response = dofs({"1:+Z", "2:+Z"}), given.reference = dofs({"1:+Z", "3:+Z"});
  const auto doubts = [&](const std::string& axes) {
    return load(*open(write_file("a.txt", three + axes), given)).header.doubts;
  };
  EXPECT_THAT(doubts(""), ElementsAre(AllOf(HasSubstr("responses or references come first"), HasSubstr("axes = 'FRC'"))));
  EXPECT_THAT(doubts(named("axes", std::string("FRC"))), IsEmpty());
  given.reference = given.response;
  EXPECT_THAT(doubts(""), IsEmpty());
}

TEST_F(NumbersBeside, ConjugatesAreNamed) {
  for (const char* text : {"exp(-i*omega*t)", "convention e^{-iwt}", "H conjugated, exp(-jwt)"})
    EXPECT_THAT(error(named("comment", std::string(text))), HasSubstr("conjugates of FRFs of exp(+iωt)")) << text;
  for (const char* text : {"exp(+i*omega*t)", "exp(iwt)", "tube-jwt", "not conjugated"})
    EXPECT_FALSE(states_conjugates(text)) << text;
}

TEST_F(NumbersBeside, TheLabelOfAPlotStatesTheUnitOfTheAxis) {
  EXPECT_THAT(error(named("xlabel", std::string("Frequency [kHz]"))),
              AllOf(HasSubstr("is not read"), HasSubstr("frequency_unit")));
  EXPECT_EQ(read(named("xlabel", std::string("Frequency [Hz]"))).header.frequency_hz, (std::vector<double>{10.0, 20.0}));
}

TEST(OrderOfAxes, LettersAndWords) {
  const auto order = [](std::string_view text) { return order_of_axes(text).value_or("none"); };
  for (const char* text : {"FRC", "frc", "f,out,in", "freq x response x reference", "lines_outputs_inputs"})
    EXPECT_EQ(order(text), "FRC") << text;
  EXPECT_EQ(order("out,in,f"), "RCF");
  EXPECT_EQ(order("foi"), "FRC");
  EXPECT_EQ(order("f_in_out"), "FCR");
  for (const char* text : {"", "FRR", "a,b,c", "FR", "frequency"}) EXPECT_EQ(order(text), "none") << text;
}

/// [3,2,2], first index fastest.
TEST_F(NumbersBeside, AxesInAnyOrderThatIsStated) {
  std::string three =
      "# name: f\n# type: matrix\n# rows: 1\n# columns: 3\n 10 20 30\n\n\n# name: frf\n# type: complex matrix\n# ndims: 3\n 3 2 "
      "2\n";
  for (int k = 0; k < 12; ++k) three += " (" + std::to_string(k) + ",1)\n";
  three += "\n\n";
  OpenOptions given;
  given.response = given.reference = dofs({"1:+Z", "2:+Z"});
  given.quantity = Quantity::receptance;
  const auto value = [&](const std::string& axes, std::size_t r, std::size_t c) {
    const FrfSet set = load(*open(write_file("a.txt", three + axes), given));
    return set.values[set.index(0, r, c)].real();
  };
  EXPECT_EQ(value("", 1, 0), 3.0);
  EXPECT_EQ(value(named("axes", std::string("FRC")), 1, 0), 3.0);
  EXPECT_EQ(value(named("axes", std::string("freq,in,out")), 1, 0), 6.0);
  const auto message = [&](const char* axes) {
    return message_of([&] { open(write_file("a.txt", three + named("axes", std::string(axes))), given); });
  };
  EXPECT_THAT(message("abc"), HasSubstr("the order of the axes 'abc' is not understood"));
  EXPECT_THAT(message("RCF"), HasSubstr("are expected, with axes RCF"));
}

TEST(NamesOfArrays, OfWhatIsComputedFromFrfs) {
  for (const char* name : {"Z", "dyn_stiff", "Hinv", "HT", "H_transposed", "logH", "H_dB", "H_sq", "dH", "H_err", "H_residual",
                           "H_normalized", "conjH"})
    EXPECT_TRUE(is_of_something_else(name)) << name;
  for (const char* name :
       {"H", "frf", "FRF", "H1", "Hv", "H_acc", "accelerance", "Y", "data", "H_test", "A", "resp", "H12", "transfer"})
    EXPECT_FALSE(is_of_something_else(name)) << name;
}

TEST(TitlesOfColumns, FactorsArePowersOfTen) {
  EXPECT_EQ(factor_in_title("Real x1000 [g/N]"), 1000.0);
  EXPECT_EQ(factor_in_title("Real (x10e-3) [g/N]"), 10e-3);
  EXPECT_EQ(factor_in_title("Re ×10^-6 [m/N]"), 1e-6);
  for (const char* title : {"Real [g/N]", "x1 Re", "x12/x1 Re", "12:+X/1:+X re", "x10 Re", "Real x [m]", "x1.5"})
    EXPECT_FALSE(factor_in_title(title)) << title;
}

}  // namespace
}  // namespace jointid::frf
