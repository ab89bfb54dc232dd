#include <gmock/gmock.h>
#include <hdf5.h>

#include <functional>

#include "file_fixture.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "frf/set/corrections.hpp"
#include "frf/set/kept_source.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

/// 4 lines, 3 responses, 2 references; covariances of rank two and variances that are halves of their diagonal.
FrfSet correlated_set(Quantity quantity) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  FrfSet set;
  set.header.quantity = quantity;
  set.header.noise = NoiseRecord::variance;
  set.header.frequency_hz = {5.0, 10.0, 20.0, 21.0};
  set.header.response = dofs({"1:+X", "2:-Y", "3:+RZ"});
  set.header.reference = dofs({"1:+X", "9:+Z"});
  const auto draw = [&] { return Complex{1e-7 * normal(random), 1e-7 * normal(random)}; };
  set.variance.resize(24);
  set.covariance.resize(48);
  for (int i = 0; i < 24; ++i) set.values.push_back(draw());
  for (std::size_t line = 0; line < 4; ++line) {
    for (std::size_t c = 0; c < 2; ++c) {
      for (int k = 0; k < 2; ++k) {
        const std::array e = {draw(), draw(), draw()};
        for (std::size_t r = 0; r < 3; ++r) {
          set.variance[set.index(line, r, c)] += 0.5 * std::norm(e[r]) * Complex{1.0, 1.0};
          for (std::size_t s = 0; s <= r; ++s) set.covariance[(line * 6 + pair_index(r, s)) * 2 + c] += e[r] * std::conj(e[s]);
        }
      }
    }
  }
  return set;
}

class CovarianceFile : public FileTest {
 protected:
  /// What is said on reading the file after `edit`.
  std::string message_after(const std::function<void(hid_t)>& edit) const {
    write_hdf5(correlated_set(Quantity::receptance), path("a.h5"));
    const hid_t file = H5Fopen(path("a.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    edit(file);
    H5Fclose(file);
    return message_of([&] { load_with_covariance(*open_hdf5(path("a.h5"))); });
  }

  double version() const {
    const hid_t file = H5Fopen(path("a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t attribute = H5Aopen(file, "version", H5P_DEFAULT);
    double value = 0.0;
    H5Aread(attribute, H5T_NATIVE_DOUBLE, &value);
    H5Aclose(attribute);
    H5Fclose(file);
    return value;
  }
};

TEST_F(CovarianceFile, ComesBackFromEveryStoredQuantityInVersionTwo) {
  for (const Quantity quantity : all_quantities) {
    const FrfSet set = correlated_set(quantity);
    write_hdf5(set, path("a.h5"));
    EXPECT_EQ(version(), 2.0);
    const auto source = open_hdf5(path("a.h5"));
    EXPECT_TRUE(source->has_covariance());
    const FrfSet read = load_with_covariance(*source);
    expect_same(read, set, 1e-14);
    ASSERT_EQ(read.covariance.size(), set.covariance.size());
    for (std::size_t i = 0; i < set.covariance.size(); ++i) EXPECT_TRUE(near(read.covariance[i], set.covariance[i], 1e-14)) << i;
  }
}

TEST_F(CovarianceFile, IsVersionOneWhereThereIsNone) {
  FrfSet set = correlated_set(Quantity::receptance);
  set.covariance.clear();
  write_hdf5(set, path("a.h5"));
  EXPECT_EQ(version(), 1.0);
  const auto source = open_hdf5(path("a.h5"));
  EXPECT_FALSE(source->has_covariance());
  EXPECT_TRUE(load_with_covariance(*source).covariance.empty());
}

TEST_F(CovarianceFile, IsAHermitianMatrixOfTheResponsesAskedFor) {
  const FrfSet set = correlated_set(Quantity::accelerance);
  write_hdf5(set, path("a.h5"));
  std::vector<std::unique_ptr<FrfSource>> sources;
  sources.push_back(open_hdf5(path("a.h5")));
  sources.push_back(from_memory(set));
  sources.push_back(std::make_unique<KeptSource>(from_memory(set)));
  const std::vector<std::size_t> lines = {1, 3}, responses = {2, 0}, references = {1};
  for (const auto& source : sources) {
    std::vector<Complex> out(8);
    source->read_covariance({lines, responses, references}, out);
    for (std::size_t l = 0; l < 2; ++l) {
      const auto stored = [&](std::size_t r, std::size_t s) { return set.covariance[(lines[l] * 6 + pair_index(r, s)) * 2 + 1]; };
      EXPECT_TRUE(near(out[4 * l], stored(2, 2), 1e-14));
      EXPECT_TRUE(near(out[4 * l + 1], stored(2, 0), 1e-14));
      EXPECT_EQ(out[4 * l + 2], std::conj(out[4 * l + 1]));
      EXPECT_TRUE(near(out[4 * l + 3], stored(0, 0), 1e-14));
    }
  }
}

/// Nothing of a damaged covariance is seen by whoever reads FRFs and variances.
TEST_F(CovarianceFile, CostsNothingWhereItIsNotAskedFor) {
  FrfSet set = correlated_set(Quantity::receptance);
  for (Complex& value : set.covariance) value = -1.0;
  write_hdf5(set, path("a.h5"));
  const auto source = open_hdf5(path("a.h5"));
  set.covariance.clear();
  expect_same(load(*source), set, 0.0);
  EXPECT_THAT(message_of([&] { load_with_covariance(*source); }),
              HasSubstr("covariance of 1:+X/1:+X, line 1: -1 + 0i is no variance"));
}

TEST_F(CovarianceFile, ThatIsBrokenIsOneClearError) {
  EXPECT_THAT(
      message_after([](hid_t file) {
        H5Ldelete(file, "covariance", H5P_DEFAULT);
        const hsize_t dims[3] = {4, 3, 2};
        const hid_t space = H5Screate_simple(3, dims, nullptr), type = H5Tcreate(H5T_COMPOUND, 16);
        H5Tinsert(type, "r", 0, H5T_NATIVE_DOUBLE);
        H5Tinsert(type, "i", 8, H5T_NATIVE_DOUBLE);
        const hid_t dataset = H5Dcreate2(file, "covariance", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        const std::vector<double> zeros(48);
        H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
        H5Dclose(dataset);
        H5Sclose(space);
      }),
      HasSubstr("dataset covariance: has dimensions [4,3,2] where frequency, response_dof and reference_dof make [4,6,2]"));
  EXPECT_THAT(message_after([](hid_t file) {
                H5Adelete(file, "version");
                const hid_t space = H5Screate(H5S_SCALAR);
                const hid_t attribute = H5Acreate2(file, "version", H5T_NATIVE_INT, space, H5P_DEFAULT, H5P_DEFAULT);
                const int one = 1;
                H5Awrite(attribute, H5T_NATIVE_INT, &one);
                H5Aclose(attribute);
                H5Sclose(space);
              }),
              HasSubstr("has a dataset covariance and is of version 1"));
  EXPECT_THAT(message_after([](hid_t file) {
                H5Ldelete(file, "covariance", H5P_DEFAULT);
                H5Lcreate_hard(file, "variance", file, "covariance", H5P_DEFAULT, H5P_DEFAULT);
              }),
              HasSubstr("dataset covariance: has dimensions [4,3,2]"));
}

TEST_F(CovarianceFile, ThatIsCutShortIsAnErrorAtEveryLength) {
  write_hdf5(correlated_set(Quantity::receptance), path("a.h5"));
  const auto size = std::filesystem::file_size(path("a.h5"));
  for (std::uintmax_t keep = 0; keep < size; keep += 97) {
    std::filesystem::copy_file(path("a.h5"), path("b.h5"), std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(path("b.h5"), keep);
    EXPECT_THAT(message_of([&] { load_with_covariance(*open_hdf5(path("b.h5"))); }), HasSubstr("b.h5")) << keep;
  }
}

/// Corrections change FRFs and covariances alike: C = E[e e^H] of e scaled is that of the scaled error.
TEST(Covariance, OfCorrectedFrfsIsThatOfTheirErrors) {
  const FrfSet set = correlated_set(Quantity::receptance);
  FrfSet error = set;  // one realisation e, with C = e e^H
  for (std::size_t line = 0; line < 4; ++line) {
    for (std::size_t c = 0; c < 2; ++c) {
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t s = 0; s <= r; ++s) {
          error.covariance[(line * 6 + pair_index(r, s)) * 2 + c] =
              set.values[set.index(line, r, c)] * std::conj(set.values[set.index(line, s, c)]);
        }
      }
    }
  }
  for (const bool conjugate : {false, true}) {
    Corrections corrections;
    corrections.conjugate = conjugate;
    corrections.delay = 1e-3;
    corrections.gain = 3.0;
    corrections.flip = dofs({"2:+Y"});
    corrections.response_gain = {{Dof::parse("3:+RZ"), 0.5}};
    corrections.reference_gain = {{Dof::parse("9:+Z"), 2.0}};
    const auto source = corrected(from_memory(error), corrections);
    ASSERT_TRUE(source->has_covariance());
    const FrfSet read = load_with_covariance(*source);
    for (std::size_t line = 0; line < 4; ++line) {
      for (std::size_t c = 0; c < 2; ++c) {
        for (std::size_t r = 0; r < 3; ++r) {
          for (std::size_t s = 0; s <= r; ++s) {
            const Complex expected = read.values[read.index(line, r, c)] * std::conj(read.values[read.index(line, s, c)]);
            EXPECT_TRUE(near(read.covariance[(line * 6 + pair_index(r, s)) * 2 + c], expected, 1e-13));
          }
        }
      }
    }
  }
}

TEST(Covariance, OfAnotherLengthIsAnError) {
  FrfSet set = correlated_set(Quantity::receptance);
  validate(set);
  set.covariance.pop_back();
  EXPECT_THAT(message_of([&] { validate(set); }),
              HasSubstr("covariance: 47 numbers, where 4 lines, responses and references make 48"));
}

}  // namespace
}  // namespace jointid::frf
