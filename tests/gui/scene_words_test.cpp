#include "gui/scene/scene_words.hpp"

#include <gmock/gmock.h>

#include "ident/scene/method_traits.hpp"

namespace jointid::gui {
namespace {

using testing::Contains;
using testing::ElementsAreArray;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

TEST(SceneWords, TheReaderNamesTheKeysOfItsTables) {
  EXPECT_THAT(keys_of(""), IsSupersetOf({"title", "data", "frequency", "joint", "joints", "identify", "truth"}));
  EXPECT_THAT(keys_of("data"), IsSupersetOf({"substructures", "assembly", "reciprocity", "files"}));
  EXPECT_THAT(keys_of("frequency"), IsSupersetOf({"range", "step", "exclude", "exclude_resonances"}));
  EXPECT_THAT(keys_of("joint"), IsSupersetOf({"dofs", "bands", "stiffness", "hysteretic_damping"}));
  EXPECT_THAT(keys_of("joints"), IsSupersetOf({"name", "dofs"}));
  EXPECT_THAT(keys_of("joints.mass"), Contains("pattern"));
  EXPECT_THAT(keys_of("noise"), Contains("level"));
  EXPECT_THAT(keys_of("no.such"), IsEmpty());
}

TEST(SceneWords, TablesInsideTablesAreFound) {
  EXPECT_THAT(all_tables(), IsSupersetOf({"data", "frequency", "frequency.exclude_resonances", "joint", "joint.stiffness",
                                          "identify", "identify.start", "noise", "truth"}));
  EXPECT_THAT(all_tables(), Not(Contains("title")));
}

TEST(SceneWords, WordsOfKeys) {
  EXPECT_THAT(words_of("identify", "method"), ElementsAreArray(ident::method_words()));
  EXPECT_THAT(words_of("identify", "equations"), ElementsAreArray({"nn", "nj", "jj", "jn"}));
  EXPECT_THAT(words_of("joint.mass", "pattern"), IsSupersetOf({"full", "symmetric", "diagonal"}));
  EXPECT_THAT(words_of("noise", "model"), Contains("hammer"));
  EXPECT_THAT(words_of("joint", "dofs"), IsEmpty());
  EXPECT_THAT(words_of("frequency", "range"), IsEmpty());
}

TEST(SceneWords, KeysOfAllLawsOfNoise) {
  EXPECT_THAT(keys_of("noise"), IsSupersetOf({"level", "coherence", "averages", "overlap"}));
}

TEST(SceneWords, TheReaderTellsWhatItTakes) {
  using enum ValueKind;
  EXPECT_EQ(kind_of("", "title"), text);
  for (const char* key : {"substructures", "assembly"}) EXPECT_EQ(kind_of("data", key), texts) << key;
  EXPECT_EQ(kind_of("data", "reciprocity"), flag);
  EXPECT_EQ(kind_of("frequency", "range"), interval);
  EXPECT_EQ(kind_of("frequency", "exclude"), value);
  EXPECT_EQ(kind_of("joint", "dofs"), dofs);
  EXPECT_EQ(kind_of("joint.stiffness", "pattern"), word);
  EXPECT_EQ(kind_of("joint.stiffness", "matrix"), value);
  EXPECT_EQ(kind_of("joint.mass", "definite"), flag);
  EXPECT_EQ(kind_of("identify", "method"), word);
  EXPECT_EQ(kind_of("identify", "equations"), words);
  EXPECT_EQ(kind_of("identify", "ties"), texts);
  for (const char* key : {"delta", "starts", "bootstrap"}) EXPECT_EQ(kind_of("identify", key), number) << key;
  for (const char* key : {"level", "floor", "coherence", "averages"}) EXPECT_EQ(kind_of("noise", key), number) << key;
  EXPECT_EQ(kind_of("noise", "reciprocal"), flag);
  EXPECT_EQ(kind_of("joints", "name"), text);
  EXPECT_EQ(kind_of("data.files.\"x.uff\"", "quantity"), text);
  EXPECT_EQ(kind_of("data.files.*", "sensors"), word);
  EXPECT_EQ(kind_of("data.files.*", "conjugate"), flag);
  for (const char* key : {"dofs", "flip", "reference_dofs"}) EXPECT_EQ(kind_of("data.files.*", key), dofs) << key;
  for (const char* key : {"mass", "delay"}) EXPECT_EQ(kind_of("data.files.*", key), number) << key;
}

TEST(SceneWords, TablesOfWhichThereMayBeSeveral) {
  using enum ValueKind;
  EXPECT_THAT(all_tables(), IsSupersetOf({"data.gains", "data.masses", "virtual_points"}));
  for (const char* table : {"joints", "data.gains", "data.masses", "virtual_points"}) EXPECT_TRUE(is_of_several(table)) << table;
  for (const char* table : {"data", "joint", "data.files.*"}) EXPECT_FALSE(is_of_several(table)) << table;
  EXPECT_THAT(keys_of("data.gains"), ElementsAreArray({"dofs", "files", "role", "gain", "delay", "angle", "shared"}));
  EXPECT_THAT(keys_of("data.masses"), ElementsAreArray({"dofs", "files", "mass", "deviation", "shared"}));
  EXPECT_THAT(keys_of("virtual_points"), IsSupersetOf({"name", "position", "sensors", "flexible"}));
  EXPECT_THAT(words_of("data.gains", "role"), ElementsAreArray({"response", "reference"}));
  EXPECT_THAT(words_of("data.masses", "shared"), ElementsAreArray({"files", "none", "all"}));
  EXPECT_THAT(words_of("data.gains", "files"), IsEmpty());
  EXPECT_EQ(kind_of("virtual_points", "flexible"), words);
  EXPECT_EQ(kind_of("virtual_points", "plane"), word);
  EXPECT_EQ(kind_of("virtual_points", "name"), text);
  for (const char* table : {"data.gains", "data.masses"}) {
    EXPECT_EQ(kind_of(table, "dofs"), dofs) << table;
    EXPECT_EQ(kind_of(table, "files"), files) << table;
    EXPECT_EQ(kind_of(table, "shared"), word) << table;
  }
  for (const char* key : {"gain", "delay"}) EXPECT_EQ(kind_of("data.gains", key), number) << key;
  for (const char* key : {"mass", "deviation"}) EXPECT_EQ(kind_of("data.masses", key), number) << key;
  for (const char* key : {"sensors", "impacts"}) EXPECT_EQ(kind_of("virtual_points", key), dofs) << key;
}

TEST(SceneWords, WhatIsAskedBeforehandIsWhatIsAnswered) {
  ask_for_everything();
  EXPECT_EQ(kind_of("identify", "method"), ValueKind::word);
  EXPECT_THAT(words_of("identify", "method"), ElementsAreArray(ident::method_words()));
}

}  // namespace
}  // namespace jointid::gui
