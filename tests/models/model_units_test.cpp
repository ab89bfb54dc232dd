// Models in the units of finite-element programs, and what their files state of units.
#include <gmock/gmock.h>

#include <fstream>

#include "base/error.hpp"
#include "frf/set/frf_source.hpp"
#include "models/files/matrix_file.hpp"
#include "models/model_file.hpp"
#include "models/model_source.hpp"
#include "tests/test_folder.hpp"

namespace jointid::models {
namespace {

using testing::HasSubstr;

class ModelUnitsFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  std::vector<Complex> frfs(const std::string& toml) const {
    return frf::load(*open_model(write("part.toml", toml), {5.0, 40.0})).values;
  }
  std::string error(const std::string& toml) const {
    try {
      frfs(toml);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  TestFolder folder_;
};

const std::string names = "dofs = [\"1:+Y\", \"1:+RZ\"]\n";

/// A translation and a rotation that are coupled: kg, kg·m, kg·m²; N/m, N/rad, N·m/rad.
const std::string si = "mass = [[2, 0.1], [0.1, 0.04]]\nstiffness = [[6e5, 2e4], [2e4, 3e3]]\nloss_factor = 0.02\n" + names;

TEST_F(ModelUnitsFile, AreAppliedToTranslationsAndRotations) {
  // t, t·mm, t·mm²; N/mm, N/rad, N·mm/rad.
  const std::string mm = "mass = [[0.002, 0.1], [0.1, 40]]\nstiffness = [[600, 2e4], [2e4, 3e6]]\nloss_factor = 0.02\n" + names;
  // kg, kg·mm, kg·mm²
  const std::string kg = "mass = [[2, 100], [100, 4e4]]\nstiffness = [[600, 2e4], [2e4, 3e6]]\nloss_factor = 0.02\n" + names;
  const std::vector<Complex> expected = frfs(si), tonnes = frfs(mm + "units = \"mm, N\"\n"),
                             kilograms = frfs(kg + "units = \"N, mm, kg\"\n");
  ASSERT_EQ(tonnes.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT(std::abs(tonnes[i] - expected[i]), 1e-12 * std::abs(expected[i])) << i;
    EXPECT_LT(std::abs(kilograms[i] - expected[i]), 1e-12 * std::abs(expected[i])) << i;
  }
  EXPECT_THAT(error(mm + "units = \"mm\"\n"), HasSubstr("a force is missing"));
  EXPECT_THAT(error(mm + "units = \"mm, N, ms\"\n"), HasSubstr("'ms' is no unit of a length, a force or a mass"));
}

TEST_F(ModelUnitsFile, OfMatricesThatStateThemAreAsked) {
  write("k.mtx", "%%MatrixMarket matrix coordinate real symmetric\n% stiffness in N/mm\n1 1 1\n1 1 6.0D+02\n");
  write("m.mtx", "%%MatrixMarket matrix coordinate real symmetric\n1 1 1\n1 1 0.002\n");
  const std::string toml = "mass = \"m.mtx\"\nstiffness = \"k.mtx\"\ndofs = [\"1:+Y\"]\n";
  EXPECT_THAT(error(toml), HasSubstr("the unit 'N/mm' in line 2; models are in SI units"));
  const std::vector<Complex> mm = frfs(toml + "units = \"mm, N, t\"\n"),
                             same = frfs("mass = [[2]]\nstiffness = [[6e5]]\ndofs = [\"1:+Y\"]\n");
  for (std::size_t i = 0; i < mm.size(); ++i) EXPECT_LT(std::abs(mm[i] - same[i]), 1e-12 * std::abs(same[i]));
}

/// A number that was cut off, a turned sign: FRFs of no structure, without a word before.
TEST_F(ModelUnitsFile, MatricesOfNegativeEnergyAreRefused) {
  const std::string mass = "mass = [[2, 0], [0, 1]]\ndofs = [\"1:+Y\", \"2:+Y\"]\n";
  EXPECT_THAT(
      error(mass + "stiffness = [[5e5, -1e5], [-1e5, 300]]\n"),
      HasSubstr(
          "stiffness: element (2, 1) is -100000, and those on the diagonal are 300 and 500000; mass, damping and stiffness"));
  EXPECT_THAT(error(mass + "stiffness = [[-5e5, 0], [0, 3e5]]\n"), HasSubstr("element (1, 1) is -500000; mass"));
  EXPECT_FALSE(frfs(mass + "stiffness = [[1e5, -1e5], [-1e5, 1e5]]\n").empty()) << "free";
  EXPECT_FALSE(frfs(mass + "stiffness = [[1e5, -1e-3], [-1e-3, 0]]\n").empty()) << "rounding";
}

TEST_F(ModelUnitsFile, AMassInGramsByARemarkIsAsked) {
  write("k.mtx", "%%MatrixMarket matrix coordinate real symmetric\n1 1 1\n1 1 6.0D+05\n");
  write("m.mtx", "%%MatrixMarket matrix coordinate real symmetric\n% mass in g\n1 1 1\n1 1 2000\n");
  EXPECT_THAT(error("mass = \"m.mtx\"\nstiffness = \"k.mtx\"\ndofs = [\"1:+Y\"]\n"), HasSubstr("the unit 'g' in line 2"));
}

TEST_F(ModelUnitsFile, PercentagesOfDampingAreRefused) {
  EXPECT_THAT(error("mass = [[2]]\nstiffness = [[6e5]]\nloss_factor = 2\ndofs = [\"1:+Y\"]\n"), HasSubstr("0.02 is 2 %"));
}

TEST_F(ModelUnitsFile, MatrixMarketHasExponentsOfFortranAndListsNothingTwice) {
  const auto read = [&](const std::string& text) {
    return read_symmetric_matrix(write("a.mtx", "%%MatrixMarket matrix coordinate real " + text));
  };
  EXPECT_EQ(read("symmetric\n2 2 2\n1 1 1.5D+03\n2 1 -2d0\n")(0, 0), 1500.0);
  for (const std::string text :
       {"symmetric\n2 2 3\n1 1 1\n2 1 3\n1 2 3\n", "general\n1 1 2\n1 1 1\n1 1 1\n", "general\n1 1 1\n1 1 1x\n"}) {
    try {
      read(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::AnyOf(HasSubstr("it is listed twice"), HasSubstr("is not 3 numbers"))) << text;
    }
  }
}

}  // namespace
}  // namespace jointid::models
