#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "frf/file/file_format.hpp"
#include "frf/uff/uff55.hpp"
#include "frf/uff/uff_dofs.hpp"
#include "frf/uff/uff_file.hpp"
#include "uff_samples.hpp"

/// What programs of others write into universal files, on the smallest inputs: 2 kg on a spring of 50 Hz, ζ = 0.02, lines 10 to
/// 100 Hz.
namespace jointid::frf {
namespace {

using namespace samples;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kilograms = 2.0, gravity = 9.80665, pound = 0.45359237 * 9.80665;

double omega(int line) { return 2.0 * std::numbers::pi * 10.0 * (line + 1); }

Complex receptance(int line) {
  const double w0 = 2.0 * std::numbers::pi * 50.0, w = omega(line);
  return 1.0 / (kilograms * Complex(w0 * w0 - w * w, 2.0 * 0.02 * w0 * w));
}

/// Its accelerance, in units of `si`.
Record accelerance(double si = 1.0, const std::string& above = "NONE", const std::string& below = "NONE") {
  Record record;
  record.points = 10;
  record.step = 10.0;
  record.numerator_type = 12;
  record.abscissa_unit = "Hz";
  record.numerator_unit = above;
  record.denominator_unit = below;
  for (int i = 0; i < 10; ++i) {
    const Complex value = -omega(i) * omega(i) * receptance(i) / si;
    record.data += format("%20.12E%20.12E", value.real(), value.imag()) + (i % 2 == 1 ? "\n" : "");
  }
  return record;
}

Record at_node(Record record, int node) {
  record.response_node = node;
  return record;
}

Record coherence(int node, double value = 0.9, const std::string& id = "NONE") {
  Record record = at_node(accelerance(), node);
  record.function_type = 6;
  record.data_type = 4;
  record.numerator_type = record.denominator_type = 0;
  record.id = id;
  record.data.clear();
  for (int i = 0; i < 10; ++i) record.data += format("%20.12E", value - 0.01 * i) + (i % 4 == 3 || i == 9 ? "\n" : "");
  return record;
}

FrfSet read(const std::string& bytes, const OpenOptions& options = {}) {
  const TemporaryUff file(bytes);
  return load(*open(file.path(), options));
}

/// Of errors in use and in data.
std::string refusal_of(const std::string& bytes, const OpenOptions& options = {}) {
  try {
    read(bytes, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

void expect_right(const FrfSet& set, double tolerance = 1e-10) {
  for (int i = 0; i < 10; ++i) {
    const auto line = static_cast<std::size_t>(i);
    EXPECT_NEAR(set.header.frequency_hz[line], 10.0 * (i + 1), 1e-4);
    EXPECT_LE(std::abs(set.values[line * set.header.entries()] - receptance(i)), tolerance * std::abs(receptance(i))) << i;
  }
}

OpenOptions said(const std::string& unit, std::optional<Quantity> quantity = {}) {
  OpenOptions options;
  options.unit = unit;
  options.quantity = quantity;
  return options;
}

OpenOptions named(const std::vector<std::string>& response, const std::vector<std::string>& reference) {
  OpenOptions options;
  for (const std::string& name : response) options.response.push_back(Dof::parse(name));
  for (const std::string& name : reference) options.reference.push_back(Dof::parse(name));
  return options;
}

TEST(UffOfOthers, UnitLabelsAsAnalysersWriteThem) {
  expect_right(read(accelerance(gravity, "G", "N").str()));
  expect_right(read(accelerance(1.0 / pound, "m/s^2", "lb").str()));
  expect_right(read(accelerance(0.0254, "IN/S^2", "N").str()));
  expect_right(read(accelerance(gravity / pound, "g's rms", "LBS").str()));
  expect_right(read(accelerance(1e-3 / gravity, "mm/sec/sec", "KGF").str()));
  expect_right(read(accelerance(1e-3, "g", "N").str(), said("mm/s^2/N")));
  expect_right(read(accelerance(gravity, std::string("g\0old", 5), std::string("\0\0\0", 3)).str()));
}

TEST(UffOfOthers, LabelsThatAreNotUnderstoodAreNamedWithTheirPlaceAndARemedy) {
  EXPECT_THAT(refusal_of(accelerance(1.0, "V", "V").str()),
              AllOf(HasSubstr("sample.uff: dataset 58 number 1, record 9 (byte 7): unknown unit 'V': V is a voltage"),
                    HasSubstr("unit = "), HasSubstr("[data.files.\"NAME\"]"), HasSubstr("--unit")));
  EXPECT_THAT(refusal_of(accelerance(1.0, "m/s^2", "counts").str()), HasSubstr("record 10 (byte 7): unknown unit 'counts'"));
  EXPECT_THAT(refusal_of(accelerance(1.0, "dB", "NONE").str()), HasSubstr("dB is a level in decibels"));
  EXPECT_THAT(refusal_of(accelerance(1.0, "m/s?", "N").str()), HasSubstr("did you mean 'm/s^2'?"));
  EXPECT_THAT(refusal_of(accelerance(1.0, "m/s^2", "m").str()), HasSubstr("record 10 (byte 7): unit 'm' is not one of a force"));
  EXPECT_THAT(refusal_of(accelerance(1.0, "kg", "N").str()),
              HasSubstr("unit 'kg' is not one of a translation, its velocity or acceleration"));
  EXPECT_THAT(refusal_of(accelerance(1.0, "g rms", "N pk").str()), HasSubstr("it mixes rms values and peaks"));
  EXPECT_THAT(refusal_of(accelerance(1.0, "MM/S^2", "MN").str()), HasSubstr("MN may be MN or mN where case was lost"));
  expect_right(read(accelerance(gravity / pound, "V", "V").str(), said("g/lbf")));
  EXPECT_THAT(refusal_of(accelerance().str(), said("g")), HasSubstr("the unit 'g' that is given is not one of 1:+Z over 1:+Z"));
  EXPECT_THAT(refusal_of(accelerance().str(), said("m/N")), HasSubstr("data type 12 makes it accelerance"));
}

TEST(UffOfOthers, TheForceKeepsItsLabelWhereTheUserSaysTheQuantity) {
  Record mobility = accelerance(1.0 / pound, "m/s", "lbf");
  mobility.numerator_type = 11;
  expect_right(read(mobility.str(), said("", Quantity::accelerance)));
  mobility.numerator_unit = "mm/s";  // in what are the numbers?
  EXPECT_THAT(refusal_of(mobility.str(), said("", Quantity::accelerance)),
              HasSubstr("its unit 'mm/s' is one of mobility, and accelerance is given"));
  Record general = accelerance(gravity, "g", "N");
  general.numerator_type = general.denominator_type = 1;
  expect_right(read(general.str()));  // labels of motion and force say it
}

TEST(UffOfOthers, FrequenciesInOtherUnits) {
  for (const auto& [unit, per_hz] :
       {std::pair{"KHz", 1e-3}, {"rad/sec", 2.0 * std::numbers::pi}, {"rpm", 60.0}, {"CPM", 60.0}, {"HZ", 1.0}}) {
    Record record = accelerance();
    record.abscissa_unit = unit;
    record.first = record.step = 10.0 * per_hz;
    expect_right(read(record.str()), 1e-5);  // six digits of record 7
  }
  Record record = accelerance();
  record.abscissa_unit = "order";
  EXPECT_THAT(refusal_of(record.str()), HasSubstr("record 8 (byte 7): 'order' is no unit of frequency that is known"));
}

TEST(UffOfOthers, FieldsPaddedByBytes) {
  std::string text = accelerance(gravity, "g", "N").str();
  const std::string field = "NONE                 g                   ";
  ASSERT_NE(text.find(field), std::string::npos);
  for (const std::string letters : {"Acc\xC3\xA9l", "\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9"}) {
    const std::string name = letters + std::string(20 - letters.size(), ' ');
    std::string padded = text;
    padded.replace(padded.find(field), field.size(), name + " g                   ");
    expect_right(read(padded));
  }
  // Names before node numbers.
  std::string names = accelerance().str();
  const std::string point = "NONE               1   3 NONE               1   3";
  ASSERT_NE(names.find(point), std::string::npos);
  names.replace(names.find(point), point.size(),
                "\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9         1   3 NONE               1   3");
  EXPECT_THAT(read(names).header.response, ElementsAre(Dof::parse("1:+Z")));
}

TEST(UffOfOthers, EndOfFileBytesAndMarks) {
  const std::string text = accelerance().str();
  for (const std::string& bytes : {"\xEF\xBB\xBF" + text, text + "\x1A", text + std::string(300, '\0'),
                                   text + "\x1Aleft over in the last block", text.substr(0, text.size() - 1) + "\x1A"})
    expect_right(read(bytes));
  EXPECT_EQ(read(text + "\x1A" + at_node(accelerance(), 2).str()).header.response.size(), 2U);  // joined by the system
  EXPECT_EQ(read(text + "\xEF\xBB\xBF" + at_node(accelerance(), 2).str()).header.response.size(), 2U);
  for (const char* below : {"End of file\n", "\nEnd of export\nfile: a.uff\n\n", "Notes: none"}) expect_right(read(text + below));
  EXPECT_THAT(refusal_of(text + "End\n1.0 2.0\n"), HasSubstr("'End' is here"));
  const std::string message = refusal_of(text + "junk\n\x1B[31m\x01");
  EXPECT_THAT(message, AllOf(HasSubstr("'junk' is here"), HasSubstr("export it again")));
  EXPECT_EQ(refusal_of(text + "\x1B[31m\x01\n").find_first_of("\x1B\x01\n"), std::string::npos);
}

TEST(UffOfOthers, ValuesThatAreNoNumbersAreNotMeasured) {
  for (const std::string word : {"1.#QNAN0000E+00", "-1.#IND0000E+00", "NaN", "nan(ind)", "********************"}) {
    Record record = accelerance();
    record.data.replace(0, 20, std::string(20 - word.size(), ' ') + word);
    record.data.replace(20, 20, std::string(20 - word.size(), ' ') + word);
    const FrfSet set = read(record.str());
    EXPECT_TRUE(std::isnan(set.values[0].real())) << word;
    EXPECT_LE(std::abs(set.values[1] - receptance(1)), 1e-10 * std::abs(receptance(1))) << word;
  }
  Record infinite = accelerance();
  infinite.data.replace(0, 20, "             1.#INF0");
  EXPECT_THAT(refusal_of(infinite.str()), HasSubstr("a value is infinite, at 10 Hz"));
  infinite.first = 0.0;  // divided by ω²
  EXPECT_TRUE(std::isnan(read(infinite.str()).values[0].real()));
}

TEST(UffOfOthers, TypesOutsideOfTheStandardAreNamedWithWhatToDo) {
  for (const int type : {0, 29, 404}) {
    Record record = accelerance();
    record.function_type = type;
    EXPECT_THAT(refusal_of(record.str()), AllOf(HasSubstr("record 6"), HasSubstr("write 4 in columns 1 to 5"))) << type;
    EXPECT_EQ(read(record.str() + at_node(accelerance(), 2).str()).header.response.size(), 1U)
        << "beside an FRF it is passed over";
  }
  Record record = accelerance();
  record.function_type = 29;
  EXPECT_THAT(refusal_of(record.str()), HasSubstr("function of type 29 (UFF 58 has 0 to 28)"));
}

TEST(UffOfOthers, RealFrfsHaveNoPhases) {
  Record real = accelerance();
  real.data_type = 4;
  real.data = coherence(1).data;
  EXPECT_THAT(refusal_of(real.str()),
              AllOf(HasSubstr("record 7"), HasSubstr("the FRF is real (ordinate type 4): it has no phases")));
}

TEST(UffOfOthers, OtherFrfsAreLeftOutAndNamed) {
  Record microphone = at_node(accelerance(1.0, "Pa", "N"), 2), strain = at_node(accelerance(1.0, "µε", "N"), 3),
         channel = at_node(accelerance(), 4);
  microphone.numerator_type = 15;
  strain.numerator_type = 1;
  strain.numerator_unit = "uE";
  channel.denominator_type = 12;
  const FrfSet set = read(accelerance().str() + microphone.str() + strain.str() + channel.str());
  expect_right(set);
  EXPECT_THAT(set.header.doubts,
              ElementsAre(AllOf(HasSubstr("3 FRFs are left out, as they are no motions over forces: 2:+Z/1:+Z (pressure / "
                                          "excitation force, Pa), 3:+Z/1:+Z (general / excitation force, uE), 4:+Z/1:+Z"))));
  EXPECT_THAT(refusal_of(microphone.str()), HasSubstr("an FRF of data type 15 over 13 is not displacement"));
}

TEST(UffOfOthers, CoherencesThatAreNotUsedAreNamed) {
  const std::string two = accelerance().str() + at_node(accelerance(), 2).str();
  const FrfHeader missing = read(two + coherence(1).str()).header;
  EXPECT_EQ(missing.noise, NoiseRecord::none);
  EXPECT_THAT(missing.doubts, ElementsAre(HasSubstr("coherences are not used, as 1 of 2 FRFs have none: 2:+Z/1:+Z")));
  Record multiple = coherence(1);
  multiple.function_type = 26;
  EXPECT_THAT(read(accelerance().str() + multiple.str()).header.doubts,
              ElementsAre(HasSubstr("multiple coherences (function type 26, 1 of them)")));
  const FrfHeader twice = read(accelerance().str() + coherence(1).str() + coherence(1).str()).header;
  EXPECT_EQ(twice.noise, NoiseRecord::coherence);
  EXPECT_THAT(twice.doubts, ElementsAre(HasSubstr("the same coherence is there several times: 1:+Z/1:+Z")));
  const FrfHeader differ = read(accelerance().str() + coherence(1).str() + coherence(1, 0.8).str()).header;
  EXPECT_EQ(differ.noise, NoiseRecord::none);
  EXPECT_THAT(differ.doubts, ElementsAre(HasSubstr("several that differ: 1:+Z/1:+Z")));
  const FrfHeader averages = read(two + coherence(1, 0.9, "30 averages").str() + coherence(2, 0.9, "10 averages").str()).header;
  EXPECT_EQ(averages.averages, 10.0);
  EXPECT_THAT(averages.doubts, ElementsAre(HasSubstr("FRFs have 10 to 30 averages: 10 are taken for all")));
  EXPECT_THAT(read(two + coherence(1, 0.9, "8 averages").str() + coherence(2, 0.9, "8 averages").str()).header.doubts, IsEmpty());
}

Record nameless(const std::string& name, int direction = 0) {
  Record record = accelerance();
  record.response_name = name;
  record.response_node = record.reference_node = 0;
  record.response_direction = record.reference_direction = direction;
  return record;
}

TEST(UffOfOthers, DofsThatTheFileDoesNotHaveAreGiven) {
  const FrfSet one = read(nameless("Pt1Z-").str(), named({"9:-Z"}, {"56:+X"}));
  expect_right(one);
  EXPECT_THAT(one.header.response, ElementsAre(Dof::parse("9:-Z")));
  EXPECT_THAT(one.header.reference, ElementsAre(Dof::parse("56:+X")));
  const std::string several = nameless("A").str() + nameless("B").str();
  EXPECT_THAT(read(several, named({"4:+Y", "5:-Y"}, {"1:+X"})).header.response,
              ElementsAre(Dof::parse("4:+Y"), Dof::parse("5:-Y")));
  const std::string same = nameless("NONE").str() + nameless("NONE").str();
  EXPECT_THAT(read(same, named({"4:+Y", "5:-Y"}, {"1:+X"})).header.response, ElementsAre(Dof::parse("4:+Y"), Dof::parse("5:-Y")));
  EXPECT_THAT(refusal_of(same, named({"4:+Y", "5:-Y"}, {"1:+X", "2:+X"})), HasSubstr("the records do not state which is which"));
  EXPECT_THAT(refusal_of(several, named({"4:+Y"}, {"1:+X"})),
              HasSubstr("1 responses are given, and its records without a direction have 2: 'A', 'B'"));
  EXPECT_THAT(refusal_of(nameless("Pt1Z-").str()),
              AllOf(HasSubstr("its name is 'Pt1Z-'"),
                    HasSubstr("--response 1:-Z --reference 1:+X (dofs and reference_dofs in a scene)")));
  Record with_coherence = coherence(0);
  with_coherence.response_name = "A";
  with_coherence.response_direction = with_coherence.reference_direction = 0;
  with_coherence.reference_node = 0;
  EXPECT_EQ(read(nameless("A").str() + with_coherence.str(), named({"4:+Y"}, {"1:+X"})).header.noise, NoiseRecord::coherence);
}

TEST(UffOfOthers, OptionsThatDoNotApplyAreErrors) {
  EXPECT_THAT(
      refusal_of(accelerance().str(), named({"9:+Y"}, {"8:+X"})),
      AllOf(HasSubstr("its responses are given (--response, or dofs in a scene), and its records name their own, 1:+Z first"),
            HasSubstr("rename")));
  EXPECT_THAT(refusal_of(accelerance().str(), named({}, {"8:+X"})), HasSubstr("its references are given"));
  expect_right(read(accelerance().str(), named({"1:+Z"}, {"1:+Z"})));  // no contradiction
}

TEST(UffOfOthers, TheUnitInTheNameOfAnAxis) {
  const auto named_axes = [](const std::string& above, const std::string& below) {
    std::string text = accelerance(1.0).str();
    const auto put = [&](const char* type, const std::string& name) {
      const std::size_t at = text.find(type) + 26;
      text.replace(at, 20, name + std::string(20 - name.size(), ' '));
    };
    put("        12    0    0    0 ", above);
    put("        13    0    0    0 ", below);
    return text;
  };
  const auto ratio = [&](const std::string& above, const std::string& below) {
    const FrfSet plain = read(accelerance().str()), set = read(named_axes(above, below));
    return std::abs(set.values[4] / plain.values[4]);
  };
  EXPECT_NEAR(ratio("Acceleration [g]", "Force (lbf)"), gravity / pound, 1e-9);
  EXPECT_NEAR(ratio("NONE g", "lbf"), gravity / pound, 1e-9);
  EXPECT_NEAR(ratio("Response (top)", "Hammer"), 1.0, 1e-12);
  EXPECT_THAT(refusal_of(named_axes("Acceleration (V)", "Force")), HasSubstr("record 9 (byte 7): unknown unit 'V'"));
}

TEST(UffOfOthers, ACodeOfUnitsThatItsFactorsContradict) {
  const auto coded = [](int code, double length, double force) {
    std::string text = units_164(length, force);
    return text.replace(text.find("         9user"), 10, format("%10d", code));
  };
  const double foot = 0.3048;
  struct Coded {
    int code;
    double length, force;  // SI units in one of the file's
  };
  for (const auto& [code, length, force] :
       {Coded{1, 1.0, 1.0}, {2, foot, pound}, {3, 1.0, gravity}, {4, foot, 0.45359237 * foot}, {5, 1e-3, 1e-3}, {6, 1e-2, 1e-2},
        {7, foot / 12, pound}, {8, 1e-3, gravity}, {9, 0.5, 7.0}, {10, 1e-3, 1.0}}) {
    const FrfSet plain = read(accelerance().str()), set = read(coded(code, 1.0 / length, 1.0 / force) + accelerance().str());
    EXPECT_NEAR(std::abs(set.values[4] / plain.values[4]), length / force, 1e-9 * length / force) << code;
  }
  const std::string feet = coded(1, 1.0 / foot, 1.0 / pound);
  EXPECT_THAT(refusal_of(feet + accelerance().str()),
              AllOf(HasSubstr("dataset 164 has units code 1, m and N, whose factors are 1 and 1, and the factors 3.2808 and 0.22481"),
                    HasSubstr("--unit")));
  EXPECT_THAT(refusal_of(coded(7, foot / 12, pound) + accelerance().str()), HasSubstr("units code 7"));
  expect_right(read(feet + accelerance(1.0, "m/s^2", "N").str()));  // labels hold
  expect_right(read(feet + accelerance().str(), said("m/s^2/N")));
}

TEST(UffOfOthers, NamesOfPoints) {
  const auto name = [](const char* text) {
    const auto dof = uff::dof_of_name(text);
    return dof ? dof->name() : std::string();
  };
  for (const auto& [text, dof] : {std::pair{"Pt1Z-", "1:-Z"},
                                  {"Pt56Z", "56:+Z"},
                                  {"12:+X", "12:+X"},
                                  {"beam:12:-Z", "12:-Z"},
                                  {"3 +y", "3:+Y"},
                                  {"P7-X", "7:-X"},
                                  {"4RZ", "4:+RZ"},
                                  {"hammer", ""},
                                  {"Z", ""},
                                  {"", ""},
                                  {"X12", ""},
                                  {"2Za", ""}})
    EXPECT_EQ(name(text), dof) << text;
}

std::string dataset18(int label, int reference, const std::array<double, 9>& p, int method = 1) {
  std::string text = "    -1\n    18\n" + format("%10d%10d%10d%10d%10d\nSYS\n", label, 0, reference, 8, method);
  for (std::size_t i = 0; i < 9; ++i) text += format("%13.5E", p[i]) + (i == 5 || i == 8 ? "\n" : "");
  return text + "    -1\n";
}

std::string node15(int id, int defined_in, int displaced_in) {
  return "    -1\n    15\n" + format("%10d%10d%10d%10d%13.5E%13.5E%13.5E\n", id, defined_in, displaced_in, 8, 0.5, 0.0, 0.0) +
         "    -1\n";
}

Node first_node(const std::string& geometry) { return read(geometry + accelerance().str()).header.nodes.at(0); }

void expect_axes(const Node& node, const Axes& axes) {
  ASSERT_TRUE(node.axes);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_THAT((*node.axes)[i], testing::Pointwise(testing::DoubleNear(1e-6), axes[i])) << i;
}

/// Origin (1, 0, 0), x along global Y, z along Z.
constexpr std::array<double, 9> turned = {1, 0, 0, 1, 1, 0, 1, 0, 1};
constexpr Axes turned_axes = {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};

TEST(UffOfOthers, SystemsOfDataset18) {
  const Node displaced = first_node(dataset18(1, 0, turned) + node15(1, 0, 1));
  EXPECT_THAT(displaced.position, ElementsAre(0.5, 0.0, 0.0));
  expect_axes(displaced, turned_axes);
  const Node defined = first_node(node15(2, 1, 1) + dataset18(1, 0, turned));
  EXPECT_THAT(defined.position, ElementsAre(1.0, 0.5, 0.0));
  expect_axes(defined, turned_axes);
  // Half round, and not exactly at right angles, as Testlab writes it.
  expect_axes(first_node(dataset18(1, 0, {-2.4, -.95, 0, -3.4, -.95, -8.74228e-08, -3.4, -.95, -1}) + node15(1, 0, 1)),
              {{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}});
  // System 7 in system 1, which comes behind it: x along Y of system 1, which is global -X; the plane's third point is no end of
  // an axis.
  expect_axes(first_node(dataset18(7, 1, {0, 0, 0, 0, 2, 0, 0, 3, 4}) + dataset18(1, 0, turned) + node15(1, 0, 7)),
              {{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}});
  EXPECT_THAT(first_node(dataset18(7, 1, {0, 0, 0, 0, 2, 0, 0, 3, 4}) + dataset18(1, 0, turned) + node15(1, 7, 0)).position,
              testing::Pointwise(testing::DoubleNear(1e-12), std::array{0.5, 0.0, 0.0}));
  // In millimetres.
  EXPECT_THAT(first_node(units_164(1000.0, 1.0) + dataset18(1, 0, turned) + node15(2, 1, 1)).position,
              testing::Pointwise(testing::DoubleNear(1e-12), std::array{0.001, 0.0005, 0.0}));
}

TEST(UffOfOthers, SystemsThatAreNotDescribedAreNeverTheGlobalOne) {
  EXPECT_TRUE(std::isnan(first_node(dataset18(1, 0, turned, 3) + node15(1, 0, 1)).axes.value()[0][0]));  // another method
  EXPECT_TRUE(
      std::isnan(first_node(dataset18(1, 9, turned) + node15(1, 0, 1)).axes.value()[0][0]));      // in a system that is not there
  EXPECT_FALSE(first_node(dataset18(1, 0, {0, 0, 0, 1, 0, 0, 0, 0, 1}) + node15(1, 0, 1)).axes);  // the global one
  EXPECT_FALSE(
      first_node(dataset18(7, 1, {0, 0, 0, 1, 0, 0, 0, 0, 1}) + node15(1, 0, 7)).axes);  // 1 is global where nothing else is 1
  EXPECT_THAT(refusal_of(dataset18(1, 0, {0, 0, 0, 1, 0, 0, 2, 0, 0}) + node15(1, 0, 1) + accelerance().str()),
              HasSubstr("do not define a plane"));
}

TEST(UffOfOthers, AUnitOfTheAxisThatIsGivenStandsInPlaceOfItsLabel) {
  OpenOptions given;
  for (const auto& [label, type] : {std::pair{"NONE", 18}, {"Bogus", 18}, {"Hz", 0}, {"rpm", 19}}) {
    Record record = accelerance(1.0, "m/s^2", "N");
    record.abscissa_unit = label, record.abscissa_type = type;
    record.first *= 60.0, record.step *= 60.0;
    given.frequency_unit = "rpm";
    expect_right(read(record.str(), given));
  }
  Record record = accelerance();
  record.abscissa_unit = "Bogus";
  EXPECT_THAT(refusal_of(record.str()),
              AllOf(HasSubstr("record 8"), HasSubstr("'Bogus'"),
                    HasSubstr("or give the unit of the axis: --frequency-unit, in a scene frequency_unit")));
  record.abscissa_type = 17;
  EXPECT_THAT(refusal_of(record.str(), given), HasSubstr("abscissa of data type 17 is not a frequency (18)"));
}

TEST(UffOfOthers, AReactionForceIsAForce) {
  for (const auto& [above, below, si] : {std::tuple{"NONE", "NONE", 1.0}, {"g", "lbf", gravity / pound}}) {
    Record record = accelerance(si, above, below);
    record.denominator_type = 9;
    expect_right(read(record.str()), 1e-9);
  }
  Record contradicts = accelerance(1.0, "m/s^2", "N");
  contradicts.numerator_type = 8, contradicts.denominator_type = 1;
  EXPECT_THAT(refusal_of(contradicts.str()),
              HasSubstr("data type 8 makes it receptance but its unit 'm/s^2' makes it accelerance"));
  Record record = accelerance();
  record.numerator_type = 9, record.denominator_type = 12;
  EXPECT_THAT(refusal_of(record.str()),
              HasSubstr("is not displacement (8), velocity (11) or acceleration (12) over a force (13 or 9)"));
}

std::string mode55(int specific, double modal_mass, const std::string& shape, int values) {
  return "    -1\n    55\nmode 1\nNONE\nNONE\nNONE\nNONE\n" +
         format("%10d%10d%10d%10d%10d%10d\n", 1, 2, values == 6 ? 3 : 2, specific, 2, values) +
         "         2         4         1         1\n" + format("%13.5E%13.5E%13.5E%13.5E\n", 50.0, modal_mass, 0.02, 0.0) +
         "         1\n" + shape + "    -1\n";
}

TEST(UffOfOthers, ModesInTheUnitsOfDataset164) {
  const std::string shape = "  0.00000E+00  0.00000E+00  1.00000E+00\n",
                    turning = "  0.00000E+00  0.00000E+00  1.00000E+00  2.00000E-03  0.00000E+00  0.00000E+00\n";
  const TemporaryUff millimetres(units_164(1000.0, 1.0) + mode55(8, 0.002, shape, 3));
  EXPECT_NEAR(read_uff55(millimetres)[0].modal_mass, 2.0, 1e-12);
  EXPECT_EQ(read_uff55(millimetres)[0].shape[2], 1.0);
  const TemporaryUff pounds(units_164(1 / 0.0254, 1 / pound) + mode55(8, 2.0 * 0.0254 / pound, shape, 3));  // lbf·s²/in
  EXPECT_NEAR(read_uff55(pounds)[0].modal_mass, 2.0, 1e-5);
  const TemporaryUff rotation(units_164(1000.0, 1.0) + mode55(8, 0.002, turning, 6));
  EXPECT_NEAR(read_uff55(rotation)[0].shape[3].real(), 2.0, 1e-12);  // 0.002 rad/mm
  const TemporaryUff stresses(mode55(2, 1.0, shape, 3));
  EXPECT_THAT(error_of([&] { read_uff55(stresses); }), HasSubstr("no mode shapes"));
}

}  // namespace
}  // namespace jointid::frf
