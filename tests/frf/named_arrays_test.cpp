// Files of named arrays as numpy, h5py and scipy write them (tests/frf/foreign/make.py).
#include <gmock/gmock.h>

#include <numbers>

#include "file_fixture.hpp"
#include "frf/mat/mat_module.hpp"
#include "tests/require.hpp"
#include "tests/test_folder.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

constexpr double one_g = 9.80665;

std::filesystem::path foreign(const std::string& name) { return std::filesystem::path(JOINTID_FOREIGN_FRFS) / name; }

Complex stored(std::size_t line, std::size_t r, std::size_t c) {
  const auto l = static_cast<double>(line), a = static_cast<double>(r), b = static_cast<double>(c);
  return {1.0 + l + 0.1 * a + 0.01 * b, a - 2.0 * b - 0.5 * l};
}

/// Receptance of an accelerance in units of `unit`.
Complex receptance(Complex accelerance, double hz, double unit) {
  return -unit * accelerance / std::pow(2.0 * std::numbers::pi * hz, 2);
}

OpenOptions given(std::optional<Quantity> quantity, const std::vector<std::string>& response = {},
                  const std::vector<std::string>& reference = {}) {
  OpenOptions options;
  options.quantity = quantity;
  options.response = dofs(response);
  options.reference = dofs(reference);
  return options;
}

/// All FRFs, or those of the first `references`; of accelerances in `unit`, or receptances where it is 0.
void expect_stored(const FrfSet& set, double unit, double tolerance, std::size_t references = 3, std::size_t responses = 2) {
  ASSERT_EQ(set.header.lines(), 4U);
  ASSERT_EQ(set.header.response.size(), responses);
  ASSERT_EQ(set.header.reference.size(), references);
  for (std::size_t l = 0; l < 4; ++l) {
    const double hz = 10.0 * static_cast<double>(l + 1);
    EXPECT_NEAR(set.header.frequency_hz[l], hz, 1e-12 * hz);
    for (std::size_t r = 0; r < responses; ++r) {
      for (std::size_t c = 0; c < references; ++c) {
        const Complex right = unit == 0.0 ? stored(l, r, c) : receptance(stored(l, r, c), hz, unit);
        EXPECT_LE(std::abs(set.values[set.index(l, r, c)] - right), tolerance * std::abs(right)) << l << ' ' << r << ' ' << c;
      }
    }
  }
}

FrfSet read(const std::string& name, const OpenOptions& options = {}) { return load(*open(foreign(name), options)); }

std::string error(const std::string& name, const OpenOptions& options = {}) {
  return message_of([&] { open(foreign(name), options); });
}

TEST(NamedArrays, StoredArchiveOfNumpy) {
  const FrfSet set = read("stored.npz");
  expect_stored(set, 0.0, 0.0);
  EXPECT_EQ(set.header.response, dofs({"1:+Z", "2:+Z"}));
  EXPECT_EQ(set.header.reference, dofs({"1:+Z", "2:+Z", "3:-X"}));
  EXPECT_EQ(set.header.quantity, Quantity::receptance);
  expect_stored(read("square.npz"), 0.0, 0.0, 2);
  OpenOptions in_kilohertz;
  in_kilohertz.frequency_unit = "kHz";
  EXPECT_EQ(read("stored.npz", in_kilohertz).header.frequency_hz[1], 1000.0 * set.header.frequency_hz[1]);
}

TEST(NamedArrays, PackedArchiveOfBigEndianSinglesInFortranOrderWithItsUnit) {
  if (!has_matio()) JOINTID_SKIP("this build lacks matio, with which zlib comes");
  const FrfSet set = read("packed.npz");
  expect_stored(set, one_g, 1e-6);
  EXPECT_EQ(set.header.quantity, Quantity::accelerance);
  EXPECT_EQ(set.header.reference, dofs({"1:+Z", "2:+Z", "3:-X"}));
}

TEST(NamedArrays, OneArrayWithTheFileOfItsFrequencies) {
  OpenOptions options = given(Quantity::receptance, {"1:+Z", "2:+Z"}, {"1:+Z", "2:+Z", "3:-X"});
  EXPECT_THAT(error("frf.npy", options),
              HasSubstr("holds one array and no frequencies; name the .npy file of these, --frequency-variable"));
  options.frequency_variable = "frequency.npy";
  expect_stored(read("frf.npy", options), 0.0, 0.0);
  options.frequency_variable = "none.npy";
  EXPECT_THAT(error("frf.npy", options), HasSubstr("none.npy: there is no such file of frequencies"));
  options.frequency_variable = "frequency.npy";
  options.response = dofs({"1:+Z"});
  EXPECT_THAT(error("frf.npy", options), HasSubstr("is [4x2x3] where 4 lines, 1 responses and 3 references are expected"));
  EXPECT_THAT(error("frequency.npy", options), HasSubstr("holds no complex numbers, and an FRF without a phase is none"));
}

TEST(NamedArrays, WhatIsNoFrfOrLeftOpenIsRefused) {
  EXPECT_THAT(error("real.npz"), HasSubstr("variable frf: is real, and an FRF without a phase is none; export complex FRFs"));
  EXPECT_THAT(error("flat.npz"),
              HasSubstr("[4x6] leaves open which column is of which response and reference; shape it [F,R,C]"));
  OpenOptions options;
  options.variable = "G";
  EXPECT_THAT(error("stored.npz", options), HasSubstr("has no variable G; there are frf [4x2x3]"));
}

/// Which of them holds is said by no format.
TEST(NamedArrays, TwoOfOneNameAreRefused) {
  EXPECT_THAT(error("twice.npz"), HasSubstr("variable frequency: is there twice"));
  if (!has_matio()) JOINTID_SKIP("this build lacks matio");
  std::ifstream in(foreign("letters.mat"), std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  constexpr std::size_t header = 128;
  const TestFolder folder;
  std::ofstream(folder / "a.mat", std::ios::binary) << whole << whole.substr(header);
  EXPECT_THAT(message_of([&] { open(folder / "a.mat"); }), HasSubstr("is there twice"));
}

TEST(NamedArrays, Hdf5ThatMatlabDidNotWriteIsNotTransposed) {
  const FrfSet set = read("h5py.h5", given({}, {"1:+Z", "2:+Z"}));
  expect_stored(set, one_g, 1e-15, 2);
  EXPECT_EQ(set.header.quantity, Quantity::accelerance) << "by the unit";
}

TEST(NamedArrays, RealAndImaginaryPartsAndAnAngularAxis) {
  OpenOptions options = given(Quantity::receptance, {"1:+Z", "2:+Z"}, {"1:+Z", "2:+Z", "3:-X"});
  expect_stored(read("parts.h5", options), 0.0, 0.0);
  options.variable = "measured.H";
  expect_stored(read("parts.h5", options), 0.0, 0.0);
  options.variable = "measured.H_real";
  EXPECT_THAT(error("parts.h5", options), HasSubstr("is real"));
}

class StructsOfMatlab : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_matio()) JOINTID_SKIP("this build lacks matio");
  }
};

TEST_F(StructsOfMatlab, StepsInKilohertzAndUnitAsTestlabExportsThem) {
  for (const std::string variable : {"", "FRF", "FRF.y_values.values"}) {
    OpenOptions options = given({}, {"1:+Z"});
    options.variable = variable;
    expect_stored(read("testlab.mat", options), one_g, 1e-14, 1, 1);
  }
  OpenOptions other = given({}, {"1:+Z"});
  other.variable = "FRF.x_values";
  EXPECT_THAT(error("testlab.mat", other), HasSubstr("is no array of complex numbers; name one of FRF.y_values.values [4x1]"));
}

TEST_F(StructsOfMatlab, AnArrayWithAnElementForEveryReference) {
  const OpenOptions options = given(Quantity::receptance, {"1:+Z", "2:+Z"});
  const FrfSet set = read("runs.mat", options);
  expect_stored(set, 0.0, 0.0);
  EXPECT_EQ(set.header.reference, dofs({"1:+Z", "2:+Z", "3:-X"}));
  ASSERT_EQ(set.header.noise, NoiseRecord::coherence);
  EXPECT_DOUBLE_EQ(set.coherence[set.index(3, 1, 2)], 0.7);
  OpenOptions one = options;
  one.variable = "run(2).H1";
  const FrfSet second = read("runs.mat", one);
  EXPECT_EQ(second.header.reference, dofs({"2:+Z"}));
  EXPECT_EQ(second.values[0], stored(0, 0, 1));
}

TEST_F(StructsOfMatlab, AnArrayWithAnElementForEveryFrf) {
  const FrfSet set = read("each.mat", given(Quantity::receptance));
  expect_stored(set, 0.0, 0.0);
  EXPECT_EQ(set.header.reference, dofs({"1:+Z", "2:+Z", "3:-X"}));
}

TEST_F(StructsOfMatlab, AStructWithAllThatIsNeeded) {
  const FrfSet set = read("cells.mat");
  expect_stored(set, 1.0, 1e-15);
  EXPECT_EQ(set.header.response, dofs({"1:+Z", "2:+Z"}));
  EXPECT_EQ(set.header.noise, NoiseRecord::coherence);
  EXPECT_EQ(set.header.averages, 5.0);
  EXPECT_THAT(
      error("cells.mat", given({}, {"7:+Z", "8:+Z"})),
      HasSubstr(
          "variable test.resp: names the DOFs 1:+Z, 2:+Z, others are given; leave out the DOFs that are given (--response"));
}

TEST(NamedArrays, AScaleThatIsNotAppliedIsRefused) {
  OpenOptions options;
  options.response = options.reference = {Dof::parse("1:+Z"), Dof::parse("2:+Z")};
  options.quantity = Quantity::receptance;
  EXPECT_THAT(message_of([&] { open(foreign("scaled.h5"), options); }),
              HasSubstr("variable frf@scale_factor: is 0.001 and is not applied to the FRFs; store the FRFs multiplied"));
}

/// Archives that are cut off or changed are one error, or still the same FRFs.
TEST(NamedArrays, DamagedArchivesAreOneErrorOrTheFrfs) {
  const TestFolder folder;
  for (const std::string name : {"stored.npz", "packed.npz"}) {
    if (name == "packed.npz" && !has_matio()) continue;
    std::ifstream in(foreign(name), std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    const auto try_bytes = [&](const std::string& bytes) {
      const std::filesystem::path file = folder / "a.npz";
      std::ofstream(file, std::ios::binary) << bytes;
      try {
        EXPECT_EQ(load(*open(file)).header.lines(), 4U);
      } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("a.npz"));
      }
    };
    for (std::size_t at = 0; at < whole.size(); ++at) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(~damaged[at]);
      try_bytes(damaged);
      if (at % 7 == 0) try_bytes(whole.substr(0, at));
    }
  }
}

TEST(NamedArrays, LettersBeyondAscii) {
  expect_stored(read("letters.npz"), 1.0, 1e-12, 1, 1);
  if (!has_matio()) JOINTID_SKIP("this build lacks matio");
  const FrfSet set = read("letters.mat");
  EXPECT_LE(std::abs(set.values[0] - 1e-6 * stored(0, 0, 0)), 1e-18);
}

/// Variables attached to the axes (dimension scales) or labels; the FRFs are square, so that a wrong order looks right.
TEST(NamedArrays, AxesInTheOrderThatHdf5States) {
  for (const char* group : {"FCR", "RFC", "CRF", "named_FCR", "named_RFC", "named_CRF", "German"}) {
    OpenOptions options = given(Quantity::receptance);
    options.variable = std::string(group) + ".H";
    const FrfSet set = read("axes.h5", options);
    expect_stored(set, 0.0, 0.0, 2);
    EXPECT_EQ(set.header.response, dofs({"1:+Z", "2:+Z"})) << group;
    EXPECT_EQ(set.header.reference, dofs({"1:+Z", "2:+Z"})) << group;
  }
  OpenOptions options = given(Quantity::receptance);
  options.variable = "unknown.H";
  EXPECT_THAT(error("axes.h5", options), HasSubstr("has axes named dim_0, dim_2, dim_1, which do not state where"));
}

TEST(NamedArrays, TheNameOfAFileOfFrequenciesStatesTheirUnit) {
  const TestFolder folder;
  std::filesystem::copy_file(foreign("frf.npy"), folder / "frf.npy");
  for (const auto& [name, hz] : {std::pair{"f.npy", 10.0},
                                 {"omega.npy", 10.0 / (2.0 * std::numbers::pi)},
                                 {"w.npy", 10.0 / (2.0 * std::numbers::pi)},
                                 {"freq_khz.npy", 1e4}}) {
    std::filesystem::copy_file(foreign("frequency.npy"), folder / name);
    OpenOptions options = given(Quantity::receptance, {"1:+Z", "2:+Z"}, {"1:+Z", "2:+Z", "3:-X"});
    options.frequency_variable = name;
    EXPECT_NEAR(load(*open(folder / "frf.npy", options)).header.frequency_hz[0], hz, 1e-12 * hz) << name;
  }
}

/// A cell of each response and reference, or of each response.
TEST(NamedArrays, CellsOfArraysAndStructs) {
  for (const char* name : {"table.mat", "table_v73.mat"}) {
    const OpenOptions all = given(Quantity::accelerance, {"1:+Z", "2:+Z"}, {"1:+Z", "2:+Z", "3:-X"});
    expect_stored(read(name, all), one_g, 1e-12);
    const OpenOptions turned = given(Quantity::accelerance, {"1:+Z", "2:+Z", "3:-X"}, {"1:+Z", "2:+Z"});
    EXPECT_THAT(error(name, turned), HasSubstr("has 2 rows and 3 columns, and 3 responses and 2 references were given"));
  }
  expect_stored(read("structs_v73.mat", given(Quantity::accelerance, {"1:+Z", "2:+Z"}, {"1:+Z"})), one_g, 1e-12, 1);
}

TEST(NamedArrays, UnitOfOctave) {
  expect_stored(read("octave.h5", given(std::nullopt, {"1:+Z", "2:+Z"}, {"1:+Z", "2:+Z"})), one_g, 1e-12, 2);
}

}  // namespace
}  // namespace jointid::frf
