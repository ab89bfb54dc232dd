// Functions as SDynPy saves them, records of numpy (make.py).
#include <gmock/gmock.h>

#include <complex>

#include "frf/file/file_format.hpp"
#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::filesystem::path foreign(const std::string& name) { return std::filesystem::path(JOINTID_FOREIGN_FRFS) / name; }

OpenOptions as_receptances() {
  OpenOptions options;
  options.quantity = Quantity::receptance;
  return options;
}

std::string error(const std::string& name, const OpenOptions& options = as_receptances()) {
  return message_of([&] { open(foreign(name), options); });
}

TEST(FunctionRecords, AreReadWithTheirDofs) {
  for (const char* name : {"functions.npz", "functions.npy"}) {
    const FrfSet set = load(*open(foreign(name), as_receptances()));
    EXPECT_THAT(names(set.header.response), ElementsAre("1:+Z", "2:+Z")) << name;
    EXPECT_THAT(names(set.header.reference), ElementsAre("1:+Z", "2:+Z", "3:-X")) << name;
    EXPECT_THAT(set.header.frequency_hz, ElementsAre(10.0, 20.0, 30.0, 40.0)) << name;
    EXPECT_THAT(set.header.doubts, ElementsAre(HasSubstr("SI units"))) << name;
    for (std::size_t l = 0; l < 4; ++l) {
      for (std::size_t r = 0; r < 2; ++r) {
        for (std::size_t c = 0; c < 3; ++c) {
          const double line = static_cast<double>(l), row = static_cast<double>(r), column = static_cast<double>(c);
          const Complex right(1.0 + line + 0.1 * row + 0.01 * column, row - 2.0 * column - 0.5 * line);
          EXPECT_LE(std::abs(set.values[set.index(l, r, c)] - right), 1e-14) << name;
        }
      }
    }
  }
}

TEST(FunctionRecords, WhatIsNoFrfIsRefused) {
  EXPECT_THAT(error("functions.npz", {}), AllOf(HasSubstr("does not state which quantity"), HasSubstr("--quantity accelerance")));
  EXPECT_THAT(error("coherences.npz"), AllOf(HasSubstr("functions of type 6"), HasSubstr("an FRF is of type 4")));
  EXPECT_THAT(error("functions_twice.npy"), AllOf(HasSubstr("function 4"), HasSubstr("the same DOFs as function 1")));
  EXPECT_THAT(error("functions_lines.npy"), AllOf(HasSubstr("function 6"), HasSubstr("other frequencies than function 1")));
  EXPECT_THAT(error("records.npy"), AllOf(HasSubstr("records with named fields"), HasSubstr("numpy.savez")));
  OpenOptions named = as_receptances();
  named.variable = "data";
  EXPECT_THAT(error("functions.npz", named), HasSubstr("leave out --variable"));
}

TEST(FunctionRecords, FrequenciesInAnotherUnit) {
  OpenOptions kilo = as_receptances();
  kilo.frequency_unit = "kHz";
  EXPECT_EQ(open(foreign("functions.npz"), kilo)->header().frequency_hz.front(), 10'000.0);
}

}  // namespace
}  // namespace jointid::frf
