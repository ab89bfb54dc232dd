#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "frf/hdf5/hdf5_file.hpp"
#include "problems/problem.hpp"
#include "tests/require.hpp"

namespace jointid::problems {
namespace {

namespace fs = std::filesystem;

fs::path golden_folder() { return fs::path(JOINTID_EXTERNAL_DATA).parent_path() / "golden"; }

/// Compares coordinates by their position, k-th of the set (from `first`) with k-th of the file: the files
/// number their rotations one node too high.
void expect_equal(const frf::FrfSet& set, const frf::FrfSet& golden, std::size_t first) {
  ASSERT_EQ(set.header.frequency_hz, golden.header.frequency_hz);
  const std::size_t n = set.header.response.size();
  double largest = 0.0;
  for (const Complex& value : golden.values) largest = std::max(largest, std::abs(value));
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t r = 0; r < n; ++r) {
      for (std::size_t c = 0; c < n; ++c) {
        const Complex expected = golden.values[golden.index(line, first + r, first + c)];
        const Complex found = set.values[set.index(line, r, c)];
        ASSERT_LE(std::abs(found - expected), 1e-10 * std::abs(expected) + 1e-13 * largest)
            << "line " << line << ", " << r << ", " << c;
      }
    }
  }
}

TEST(Golden, CaseA1EqualsTheFilesOfAnIndependentProgram) {
  const fs::path folder = golden_folder();
  if (!fs::exists(folder))
    JOINTID_SKIP("no reference files at " << folder << "; set JOINTID_EXTERNAL_DATA");
  const frf::FrfSet parts = frf::load(*frf::open_hdf5(folder / "caseA1_clean_substructures.h5"));
  const frf::FrfSet assembly = frf::load(*frf::open_hdf5(folder / "caseA1_clean_assembly.h5"));
  const Problem a1 = make("A1");
  expect_equal(a1.substructures[0], parts, 0);
  expect_equal(a1.substructures[1], parts, 8);
  expect_equal(a1.assembly, assembly, 0);
}

}  // namespace
}  // namespace jointid::problems
