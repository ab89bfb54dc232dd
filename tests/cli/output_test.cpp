#include "cli/options/output.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/error.hpp"
#include "tests/test_folder.hpp"

namespace jointid::cli {
namespace {

class Output : public testing::Test {
 protected:
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

  TestFolder folder_;
};

TEST_F(Output, AnythingElseIsAFileThatIsReplacedWhole) {
  std::ostringstream out;
  const auto path = folder_ / "a.json";
  write_target(path, "a long first version\n", out);
  write_target(path, "second\n", out);
  std::ifstream file(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "second\n");
  EXPECT_EQ(files(), 1U);
  EXPECT_EQ(out.str(), "");
}

TEST_F(Output, AFailureLeavesNothingBehind) {
  std::ostringstream out;
  std::filesystem::create_directories(folder_ / "taken/by a folder");
  EXPECT_THROW(write_target(folder_ / "taken", "text", out), InputError);
  EXPECT_EQ(files(), 1U);
  EXPECT_THROW(write_target(folder_ / "absent/a.json", "text", out), InputError);
}

TEST_F(Output, AMinusIsTheStream) {
  std::ostringstream out;
  write_target("-", "text", out);
  EXPECT_EQ(out.str(), "text");
  EXPECT_EQ(files(), 0U);
}

}  // namespace
}  // namespace jointid::cli
