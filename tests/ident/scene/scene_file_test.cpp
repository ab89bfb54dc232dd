#include <gmock/gmock.h>

#include <fstream>

#include "base/error.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/scene/scene.hpp"
#include "tests/ident/scene/full_scene.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

using ::testing::HasSubstr;

/// A folder of its own that goes away with the test.
class SceneFile : public ::testing::Test {
 protected:
  Path write(const std::string& text) const {
    const Path file = folder_ / "scene.toml";
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  static void expect_error(const Path& file, const std::string& fragment) {
    try {
      read_scene(file);
      FAIL() << fragment;
    } catch (const InputError& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_THAT(error.what(), HasSubstr(file.string()));
      EXPECT_THAT(error.what(), HasSubstr(fragment));
    }
  }

  TestFolder folder_;
};

TEST_F(SceneFile, PathsOfTheDataAreRelativeToTheScene) {
  const Path file = write(
      "data = { substructures = ['a.h5'], assembly = ['sub/b.h5'] }\n"
      "joint = { dofs = ['1:X'], stiffness.pattern = 'full' }\n");
  const Scene scene = read_scene(file);
  EXPECT_EQ(scene.data.substructures[0].path, folder_ / "a.h5");
  EXPECT_EQ(scene.data.assembly[0].path, folder_ / "sub/b.h5");
}

TEST_F(SceneFile, WhatIsNotAReadableFile) {
  expect_error(folder_ / "absent.toml", "no such scene file");
  expect_error(folder_, "this is a folder");
}

TEST_F(SceneFile, WhatIsTooLarge) {
  expect_error(write(std::string((std::size_t{16} << 20) + 1, '#')), "larger than 16 MiB");
  expect_error(write("#" + std::string((std::size_t{16} << 20) - 1, '.')), "the key 'data' is missing");
}

TEST_F(SceneFile, WhatIsNotUtf8) { expect_error(write("title = 'caf\xe9'\n"), "line 1, column"); }

TEST_F(SceneFile, DeepNestingIsAnErrorNotACrash) {
  constexpr std::size_t many = 1'000'000;
  std::string dotted;
  for (std::size_t i = 0; i < many; ++i) dotted += "a.";
  expect_error(write("\n" + dotted + "a = 1\n"), "line 2: a key has more than 32 parts");
  expect_error(write("[" + dotted + "a]\n"), "more than 32 parts");
  expect_error(write("x = {" + dotted + "a = 1}\n"), "more than 32 parts");
  std::string quoted;
  for (std::size_t i = 0; i < many; ++i) quoted += "\"=,]\" . ";
  expect_error(write(quoted + "a = 1\n"), "more than 32 parts");
  expect_error(write("x = \"\"\"\n\"\"\"\"\"\n" + quoted + "a = 1\n"), "line 3: a key has more than 32 parts");
  expect_error(write("x = '\\'\n" + quoted + "a = 1\n"), "more than 32 parts");
  expect_error(write("x = " + std::string(many, '[')), "line 1, column");
}

TEST_F(SceneFile, DotsInTextNumbersAndCommentsAreNoKeys) {
  std::string numbers;
  for (int i = 0; i < 50; ++i) numbers += "0.5, ";
  const Path file = write("# " + std::string(100, '.') + "\ntitle = \"a\\\"" + std::string(100, '.') + "\"\n" +
                          "frequency.exclude = [[1.0, 2.0]]\n[truth]\nmass = [[" + numbers + "]]\n");
  expect_error(file, "the key 'data' is missing");
}

/// True when the text is a scene or an InputError (usage); anything else escapes.
bool is_scene(const std::string& text) {
  try {
    parse_scene(text, "scene.toml");
    return true;
  } catch (const InputError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage) << text;
    return false;
  }
}

TEST(SceneText, ADamagedSceneIsAnInputErrorOrAnotherScene) {
  const std::string whole = full_scene;
  ASSERT_TRUE(is_scene(whole));
  std::size_t scenes = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    scenes += is_scene(whole.substr(0, i)) ? 1U : 0U;
    std::string damaged = whole;
    for (const char c : {'"', '[', '.', '-', '9', '\n', '\0', '\xff'}) {
      damaged[i] = c;
      scenes += is_scene(damaged) ? 1U : 0U;
    }
    damaged.erase(i, 1);
    scenes += is_scene(damaged) ? 1U : 0U;
  }
  EXPECT_GT(scenes, 0u);
  EXPECT_LT(scenes, 10 * whole.size());
}

}  // namespace
}  // namespace jointid::ident
