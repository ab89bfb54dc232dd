#include "frf/file/open_as_one.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/error.hpp"
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

}  // namespace
}  // namespace jointid::frf
