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

TEST(SceneWords, WhatIsAskedBeforehandIsWhatIsAnswered) {
  ask_for_everything();
  EXPECT_EQ(kind_of("identify", "method"), ValueKind::word);
  EXPECT_THAT(words_of("identify", "method"), ElementsAreArray(ident::method_words()));
}

}  // namespace
}  // namespace jointid::gui
