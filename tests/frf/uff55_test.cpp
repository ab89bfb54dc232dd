#include "frf/uff/uff55.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "tests/require.hpp"
#include "tests/test_folder.hpp"

namespace jointid::frf {
namespace {

namespace fs = std::filesystem;

class Uff55 : public testing::Test {
 protected:
  fs::path external(const std::string& name) const { return fs::path(JOINTID_EXTERNAL_DATA) / "uff" / name; }
  void write(const std::string& text) const { std::ofstream(file_) << text; }
  std::string error() const {
    try {
      read_uff55(file_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  TestFolder folder_;
  fs::path file_ = folder_ / "modes.uff";
};

void expect_near(Complex found, Complex expected) { EXPECT_LE(std::abs(found - expected), 1e-5 * std::abs(expected)); }

TEST_F(Uff55, NormalAndComplexModesComeBack) {
  Uff55Mode normal, damped;
  normal.id[0] = "normal";
  normal.number = 1;
  normal.frequency_hz = 123.456;
  normal.hysteretic_damping = 0.0125;
  normal.dofs = {Dof::parse("4:+Y"), Dof::parse("4:+RZ"), Dof::parse("17:-X")};
  normal.shape = {0.5, -12.25, 3.0e-7};
  damped.number = 2;
  damped.is_complex = true;
  damped.eigenvalue = {-3.5, 1234.5};
  damped.modal_a = {1.0, 0.25};
  damped.modal_b = -damped.eigenvalue * damped.modal_a;
  damped.dofs = {Dof::parse("4:+Y"), Dof::parse("123456789:+Z")};
  damped.shape = {{0.1, -0.2}, {-1.5e10, 2.5e-10}};
  write_uff55({normal, damped}, {{4, {0.1, 0.2, 0.3}}}, file_);

  const auto found = read_uff55(file_);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].id[0], "normal");
  EXPECT_FALSE(found[0].is_complex);
  EXPECT_NEAR(found[0].frequency_hz, 123.456, 1e-3);
  EXPECT_EQ(found[0].modal_mass, 1.0);
  EXPECT_NEAR(found[0].hysteretic_damping, 0.0125, 1e-7);
  ASSERT_EQ(found[0].dofs.size(), 12u);  // two nodes, six components
  EXPECT_EQ(found[0].dofs[1], Dof::parse("4:+Y"));
  expect_near(found[0].shape[1], 0.5);
  expect_near(found[0].shape[5], -12.25);
  expect_near(found[0].shape[6], -3.0e-7);  // 17:+X is minus 17:-X
  EXPECT_EQ(found[0].shape[0], 0.0);

  EXPECT_TRUE(found[1].is_complex);
  EXPECT_EQ(found[1].number, 2);
  expect_near(found[1].eigenvalue, damped.eigenvalue);
  expect_near(found[1].modal_a, damped.modal_a);
  expect_near(found[1].modal_b, damped.modal_b);
  EXPECT_NEAR(found[1].viscous_damping, 3.5 / 1234.5, 1e-7);
  ASSERT_EQ(found[1].dofs.size(), 6u);
  expect_near(found[1].shape[1], damped.shape[0]);
  expect_near(found[1].shape[5].real(), -1.5e10);
  expect_near(found[1].shape[5].imag(), 2.5e-10);
}

TEST_F(Uff55, ModesOfOthers) {
  if (!fs::is_directory(external(""))) JOINTID_SKIP(external("") << " is missing: no external data");
  const auto testlab = read_uff55(external("uff55 sample_test record10.uff"));
  ASSERT_EQ(testlab.size(), 1u);
  EXPECT_TRUE(testlab[0].is_complex);
  EXPECT_EQ(testlab[0].number, 1);
  EXPECT_EQ(testlab[0].eigenvalue, Complex(-0.1111111, 41.11111));
  EXPECT_EQ(testlab[0].modal_a, Complex(4111.111, -3111.111));
  EXPECT_EQ(testlab[0].modal_b, Complex(-111111.0, -211111.0));
  const Complex b = -testlab[0].eigenvalue * testlab[0].modal_a;  // its digits were made up, signs and magnitudes are Testlab's
  EXPECT_LT(std::abs(testlab[0].modal_b - b), 0.25 * std::abs(b));
  ASSERT_EQ(testlab[0].dofs.size(), 6u);
  EXPECT_EQ(testlab[0].dofs[1], Dof::parse("111111:+Y"));
  EXPECT_EQ(testlab[0].shape[1], Complex(0.1111111, 0.09111111));
  const auto three = read_uff55(external("uff55_translation.uff"));
  ASSERT_EQ(three.size(), 3u);
  EXPECT_EQ(three[1].frequency_hz, 12.0);
  EXPECT_EQ(three[1].number, 2);
  EXPECT_EQ(three[1].dofs[9], Dof::parse("4:+X"));
  EXPECT_EQ(three[1].shape[9], 1.98289);
  const auto six = read_uff55(external("uff55_translation_rotation.uff"));
  EXPECT_NEAR(six[0].frequency_hz, 97.013, 1e-12);
  EXPECT_EQ(six[0].dofs[5], Dof::parse("1:+RZ"));
  EXPECT_EQ(six[0].shape[0], 5.3569e-2);
  EXPECT_THROW(read_uff55(external("TestLab 161 164 18 15 82.uff")), InputError);
}

TEST_F(Uff55, DamageIsNamed) {
  const std::string head = "    -1\n    55\na\nb\nc\nd\ne\n         1         2         2         8         2         3\n"
                           "         2         4         1         1\n";
  write(head + "  1.00000e+01  0.00000e+00  0.00000e+00  oops\n    -1\n");
  EXPECT_THAT(error(), testing::AllOf(testing::HasSubstr("record 8"), testing::HasSubstr("'oops' is not a number")));
  write(head + "  1.00000e+01  0.00000e+00  0.00000e+00  0.00000e+00\n         1\n    -1\n");
  EXPECT_THAT(error(), testing::HasSubstr("record 10"));
  write("    -1\n    55\na\nb\n    -1\n");
  EXPECT_THAT(error(), testing::HasSubstr("the dataset ends before it"));
  write("    -1\n   151\nx\n    -1\n");
  EXPECT_THAT(error(), testing::HasSubstr("no mode shapes"));
}

}  // namespace
}  // namespace jointid::frf
