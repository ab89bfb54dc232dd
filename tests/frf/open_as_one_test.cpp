#include "frf/file/open_as_one.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/error.hpp"
#include "frf/file/memory_file.hpp"
#include "tests/test_folder.hpp"

namespace jointid::frf {
namespace {

std::vector<Dof> parse_dofs(const std::vector<std::string>& texts) {
  std::vector<Dof> dofs;
  for (const std::string& text : texts) dofs.push_back(Dof::parse(text));
  return dofs;
}

class OpenAsOne : public testing::Test {
 protected:
  std::filesystem::path exported(const std::string& name, const std::string& value) const {
    std::ofstream(folder_ / name, std::ios::binary)
        << "Ref Chan:Resp Chan\t0-Z:0-Z\r\nFrequency\t Real\t Imaginary\r\nHz\t(m)(N)\t \r\n10\t " + value +
               "\t 0\r\n20\t 1\t 0\r\n";
    return folder_ / name;
  }
  TestFolder folder_;
};

/// Files of one FRF each whose labels are all alike, as analysers export them.
TEST_F(OpenAsOne, TheDofsGivenAreThoseOfTheFilesInTurn) {
  const std::vector<std::filesystem::path> files = {exported("a.txt", "5"), exported("b.txt", "7")};
  OpenOptions options;
  options.response = parse_dofs({"4:-X"});
  options.reference = parse_dofs({"1:+X", "3:+X"});
  const FrfSet set = load(*open_as_one(files, options));
  EXPECT_EQ(set.header.response, options.response);
  EXPECT_EQ(set.header.reference, options.reference);
  EXPECT_EQ(set.values[set.index(0, 0, 0)], Complex(5.0, 0.0));
  EXPECT_EQ(set.values[set.index(0, 0, 1)], Complex(7.0, 0.0));
  options.reference = parse_dofs({"1:+X"});
  EXPECT_THROW(open_as_one(files, options), InputError);  // one FRF in two files
}

TEST(OptionsOfFile, AreAllOfThemUnlessThereIsOneForEach) {
  OpenOptions options;
  options.response = parse_dofs({"1:+X", "2:+X", "3:+X"});
  options.reference = parse_dofs({"4:+X", "5:+X"});
  EXPECT_EQ(options_of_file(options, 1, 2).response, options.response);
  EXPECT_EQ(options_of_file(options, 1, 2).reference, parse_dofs({"5:+X"}));
  EXPECT_EQ(options_of_file(options, 0, 1).reference, options.reference);
}

/// Two lines, two responses, one reference; accelerances 1 … 4 with variances.
struct KeptArrays {
  std::vector<Complex> values = {1.0, 2.0, 3.0, 4.0};
  std::vector<Complex> variance = {{1.0, 2.0}, {1.0, 2.0}, {1.0, 2.0}, {1.0, 2.0}};
  std::shared_ptr<FrfArrays> arrays = std::make_shared<FrfArrays>();

  KeptArrays() {
    FrfHeader& header = arrays->header;
    header.file = "beam/left";
    header.frequency_hz = {10.0, 20.0};
    header.response = {Dof::parse("1:+X"), Dof::parse("2:+X")};
    header.reference = {Dof::parse("1:+X")};
    header.quantity = Quantity::mobility;
    header.noise = NoiseRecord::variance;
    arrays->values = values;
    arrays->variance = variance;
  }
};

std::string refusal_of_arrays(const std::shared_ptr<const FrfArrays>& arrays) {
  try {
    const MemoryFile file(arrays);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MemoryFile, IsOpenedByItsPathAsReceptance) {
  const KeptArrays kept;
  const MemoryFile file(kept.arrays);
  const FrfSet set = load(*open(file.path()));
  EXPECT_EQ(set.header.file, "beam/left");
  const Complex factor = to_receptance(Quantity::mobility, 20.0);
  EXPECT_EQ(set.values[3], factor * 4.0);
  EXPECT_DOUBLE_EQ(set.variance[3].real(), std::norm(factor) * 2.0);  // real and imaginary part change places
  EXPECT_DOUBLE_EQ(set.variance[3].imag(), std::norm(factor) * 1.0);
}

/// L Lᴴ + diag(d) of one column, whatever the quantity: c = 1/(iω) scales it by |c|².
TEST(MemoryFile, HasCovariancesAsAFactor) {
  const KeptArrays kept;
  const std::vector<Complex> rows = {1.0, {0.0, 2.0}, 3.0, 4.0};
  const std::vector<double> diagonal = {0.5, 0.25, 0.0, 1.0};
  kept.arrays->rank = 1;
  kept.arrays->factor = rows;
  kept.arrays->factor_diagonal = diagonal;
  const FrfSet set = load_with_covariance(*from_arrays(kept.arrays));
  EXPECT_EQ(set.factor.rank, 1U);
  EXPECT_TRUE(set.covariance.empty());
  const std::vector<Complex> pairs = covariance_pairs(set);
  const double scale = std::norm(to_receptance(Quantity::mobility, 10.0));
  EXPECT_NEAR(pairs[0].real(), scale * 1.5, 1e-14 * scale);
  EXPECT_NEAR(std::abs(pairs[1] - scale * Complex(0.0, 2.0)), 0.0, 1e-14 * scale);
  EXPECT_NEAR(pairs[2].real(), scale * 4.25, 1e-14 * scale);
  kept.arrays->factor = std::span(rows).first(3);
  EXPECT_THAT(refusal_of_arrays(kept.arrays), testing::HasSubstr("covariance_factor"));
}

TEST(MemoryFile, HandsOutWhatTheArraysHaveThen) {
  KeptArrays kept;
  const MemoryFile file(kept.arrays);
  const auto source = open(file.path());
  kept.values[0] = 7.0;
  EXPECT_EQ(load(*source).values[0], to_receptance(Quantity::mobility, 10.0) * 7.0);
}

TEST(MemoryFile, IsGoneWithItsEnd) {
  std::filesystem::path path;
  std::unique_ptr<FrfSource> source;
  const KeptArrays kept;
  {
    const MemoryFile file(kept.arrays);
    path = file.path();
    source = open(path);
  }
  EXPECT_EQ(open_memory_file(path), nullptr);
  EXPECT_THROW(open(path), InputError);
  EXPECT_EQ(load(*source).header.lines(), 2U);  // what is open stays
}

TEST(MemoryFile, HasAPathOfItsOwn) {
  const KeptArrays kept;
  const MemoryFile one(kept.arrays), other(kept.arrays);
  EXPECT_NE(one.path(), other.path());
  EXPECT_EQ(one.path().filename(), "beam_left");
  kept.arrays->header.file = "model.toml";  // which would be read as a model
  EXPECT_NE(MemoryFile(kept.arrays).path().extension(), ".toml");
}

TEST(MemoryFile, RefusesArraysOfAnotherLength) {
  KeptArrays kept;
  kept.arrays->values = kept.arrays->values.first(3);
  EXPECT_THAT(refusal_of_arrays(kept.arrays), testing::HasSubstr("3 numbers"));
  kept.arrays->values = kept.values;
  kept.arrays->variance = {};
  EXPECT_THAT(refusal_of_arrays(kept.arrays), testing::HasSubstr("variance"));
  kept.arrays->variance = kept.variance;
  kept.arrays->covariance = kept.values;
  EXPECT_THAT(refusal_of_arrays(kept.arrays), testing::HasSubstr("covariance"));
  kept.arrays->header.frequency_hz = {10.0, 10.0};
  EXPECT_THAT(refusal_of_arrays(kept.arrays), testing::HasSubstr("beam/left"));
}

TEST(MemoryFile, TakesAnotherQuantityAndNoUnit) {
  const KeptArrays kept;
  const MemoryFile file(kept.arrays);
  OpenOptions options;
  options.quantity = Quantity::receptance;
  EXPECT_NEAR(std::abs(load(*open(file.path(), options)).values[1] - 2.0), 0.0, 1e-15);
  options.quantity.reset();
  options.unit = "mm/N";
  EXPECT_THROW(open(file.path(), options), InputError);
}

TEST(MemoryFile, GivesCovariances) {
  KeptArrays kept;
  const std::vector<Complex> covariance = {3.0, {0.5, 0.1}, 3.0, 3.0, {0.5, 0.1}, 3.0};  // pairs (1,1) (2,1) (2,2) of two lines
  kept.arrays->covariance = covariance;
  const MemoryFile file(kept.arrays);
  const FrfSet set = load_with_covariance(*open(file.path()));
  ASSERT_EQ(set.covariance.size(), 6U);
  EXPECT_NEAR(std::abs(set.covariance[4] - std::norm(to_receptance(Quantity::mobility, 20.0)) * covariance[4]), 0.0, 1e-20);
}

}  // namespace
}  // namespace jointid::frf
