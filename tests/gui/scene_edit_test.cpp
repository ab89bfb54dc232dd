#include "gui/scene/scene_edit.hpp"

#include <gmock/gmock.h>

#include "ident/scene/read_scene.hpp"
#include "widgets.hpp"

namespace jointid::gui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(WithValue, ReplacesAValueAndKeepsComments) {
  EXPECT_EQ(with_value("[a]\nb = [1,\n 2] # why\nc = 3\n", "a", "b", "[9]"), "[a]\nb = [9] # why\nc = 3\n");
  EXPECT_EQ(with_value("[a]\nb = \"x # y\" # why\n", "a", "b", "1"), "[a]\nb = 1 # why\n");
}

TEST(WithValue, AddsAKeyAtTheEndOfItsTable) {
  EXPECT_EQ(with_value("[a]\nb = [\n1]\n# more\n\n[c]\nd = 1\n", "a", "e", "2"), "[a]\nb = [\n1]\ne = 2\n# more\n\n[c]\nd = 1\n");
  EXPECT_EQ(with_value("[a]", "a", "e", "2"), "[a]\ne = 2\n");
}

TEST(WithValue, AddsATable) { EXPECT_EQ(with_value("[a]\nb = 1", "c", "d", "2"), "[a]\nb = 1\n\n[c]\nd = 2\n"); }

TEST(WithValue, TheSceneReaderTakesWhatIsWritten) {
  std::string text = small_scene;
  text = with_value(text, "frequency", "exclude", written(std::vector<ident::Range>{{560.0, 566.5}}));
  text = with_value(text, "frequency", "exclude", written(std::vector<ident::Range>{{560.0, 566.5}, {700.0, 710.0}}));
  text = with_value(text, "joint", "dofs", written({frf::Dof::parse("3:-RZ"), frf::Dof::parse("4:+RZ")}));
  const ident::Scene scene = ident::parse_scene(text, "scene.toml");
  EXPECT_THAT(scene.frequency.exclude_hz, ElementsAre(ElementsAre(560.0, 566.5), ElementsAre(700.0, 710.0)));
  EXPECT_THAT(frf::names(scene.joints.front().dofs), ElementsAre("3:-RZ", "4:+RZ"));
  EXPECT_EQ(scene.data.substructures.size(), 2U);
}

TEST(WithRange, WhatOverlapsIsOne) {
  EXPECT_THAT(with_range({{10, 20}, {30, 40}}, {15, 25}), ElementsAre(ElementsAre(10, 25), ElementsAre(30, 40)));
  EXPECT_THAT(with_range({{10, 20}, {30, 40}}, {20, 30}), ElementsAre(ElementsAre(10, 40)));
  EXPECT_THAT(with_range({{30, 40}}, {1, 2}), ElementsAre(ElementsAre(1, 2), ElementsAre(30, 40)));
}

/// The same that the reader reads, and none where the way has none.
TEST(SceneEdit, FrfsOfModesAreThoseOfTheWay) {
  const std::string data = "[data]\nsubstructures = [\"a\", \"b\"]\nassembly = [\"c\"]\n";
  const std::string rest = "[joint]\ndofs = [\"1:+X\", \"2:+X\"]\n[joint.stiffness]\npattern = \"full\"\n";
  const auto read = [&](const study::Way& way, const std::string& more) {
    return ident::parse_scene(with_way(data + more + rest, way), {}).data.regenerate;
  };
  study::Way way;
  for (const char* word : {"none", "substructures", "assembly", "substructures+assembly"}) {
    way.regenerate = ident::parse_regeneration(word);
    EXPECT_EQ(read(way, ""), way.regenerate) << word;
    EXPECT_EQ(read(way, "regenerate = [\"assembly\"]\n"), way.regenerate) << word;
  }
}

TEST(SceneEdit, AWayOfAComparisonBecomesThatOfTheScene) {
  study::Way way;
  way.method = ident::Method::two;
  way.equations = {ident::Equation::nn, ident::Equation::nj};
  way.weighting = weighting::Weighting::wbs;
  way.delta = 0.05;
  way.solver = ident::Solver::qr;
  const std::string text = "[identify]\nmethod = \"one\"  # at first\nweighting = \"WA\"\n";
  EXPECT_EQ(with_way(text, way),
            "[identify]\nmethod = \"two\"  # at first\nweighting = \"WBS\"\nequations = [\"nn\", \"nj\"]\nsolver = \"qr\"\n"
            "delta = 0.05\n");
  way.method = ident::Method::likelihood;
  way.solver = ident::Solver::gauss_helmert;
  EXPECT_EQ(with_way("", way),
            "\n[identify]\nmethod = \"likelihood\"\nequations = [\"nn\", \"nj\"]\nsolver = \"gauss-helmert\"\n");
}

}  // namespace
}  // namespace jointid::gui
