#include "gui/scene/scene_check.hpp"

#include <gmock/gmock.h>

#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

TEST(SceneCheck, AGoodTextIsAScene) {
  const CheckedScene checked = check_scene(small_scene, "/somewhere/scene.toml");
  EXPECT_FALSE(checked.error);
  ASSERT_TRUE(checked.scene);
  EXPECT_EQ(checked.scene->data.assembly.front().path, "/somewhere/c.uff");
}

TEST(SceneCheck, AnErrorHasItsLineAndRemedy) {
  std::string text = small_scene;
  text.replace(text.find("pattern"), 7, "patern");
  const CheckedScene checked = check_scene(text, {});
  ASSERT_TRUE(checked.error);
  EXPECT_EQ(checked.error->line, 9);
  EXPECT_THAT(checked.error->problem, HasSubstr("patern"));
  EXPECT_THAT(checked.error->remedy, HasSubstr("pattern"));
}

TEST(SceneCheck, AnErrorOfTomlHasItsLine) {
  const CheckedScene checked = check_scene("[data]\nassembly = [\"a\"\n\n[joint]\n", {});
  ASSERT_TRUE(checked.error);
  EXPECT_GE(checked.error->line, 2);
}

TEST(SceneCheck, AnErrorOfAPlanIsLedToItsKey) {
  const InputError error(
      {.kind = ErrorKind::usage, .file = "x", .place = "[joint] dofs", .problem = "no file has 7:+Y", .remedy = ""});
  EXPECT_EQ(located(error, small_scene).line, 6);
  const InputError elsewhere(
      {.kind = ErrorKind::data, .file = "x", .place = "dataset 3", .problem = "it is short", .remedy = ""});
  EXPECT_EQ(located(elsewhere, small_scene).line, 0);
  EXPECT_EQ(located(elsewhere, small_scene).problem, "dataset 3: it is short");
}

}  // namespace
}  // namespace jointid::gui
