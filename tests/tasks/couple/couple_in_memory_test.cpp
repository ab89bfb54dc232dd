#include <gmock/gmock.h>

#include "base/control.hpp"
#include "base/error.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "problems/case/coupling_problem.hpp"
#include "tasks/couple.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

class CoupleInMemory : public testing::Test {
 protected:
  TestFolder folder_;
  problems::CouplingProblem problem_ = problems::make_coupling("coupling-C");
  ident::CoupleScene scene_ =
      ident::read_couple_scene(problems::write(problem_, folder_, {.format = "h5", .seed = 1, .clean = true}));
};

/// The same FRFs, bounds, conditions and resonances as by files.
TEST_F(CoupleInMemory, GivesWhatFilesGive) {
  scene_.options.uncertainty = true;
  scene_.options.noise = frf::NoiseModel{.level = 0.05};
  const CoupleResult of_files = couple(scene_, folder_ / "out.h5", true);
  const CoupledSets found = couple(scene_, problem_.parts, true);
  const frf::FrfSet set = frf::load(*frf::open_hdf5(folder_ / "out.h5")),
                    all = frf::load(*frf::open_hdf5(folder_ / "out.all.h5"));
  ASSERT_TRUE(found.with_all && found.result.with_all);
  EXPECT_EQ(found.frfs.header.response, set.header.response);
  EXPECT_EQ(found.frfs.header.frequency_hz, set.header.frequency_hz);
  EXPECT_EQ(found.frfs.values, set.values);
  EXPECT_EQ(found.frfs.variance, set.variance);
  EXPECT_EQ(found.with_all->values, all.values);
  EXPECT_EQ(found.result.conditions, of_files.conditions);
  EXPECT_EQ(found.result.result.resonances_hz, of_files.result.resonances_hz);
  EXPECT_TRUE(found.result.result.path.empty());
  EXPECT_NO_THROW(frf::validate(found.frfs));
}

TEST_F(CoupleInMemory, NeedsASetForEveryPart) {
  problem_.parts.pop_back();
  EXPECT_THROW(couple(scene_, problem_.parts), InputError);
}

TEST_F(CoupleInMemory, StopsWhenAsked) {
  ident::Control control;
  control.interrupted = [] { return true; };
  EXPECT_THROW(couple(scene_, problem_.parts, false, control), Interrupted);
}

/// A part of conjugates coupled with others gave FRFs of no structure without a word; so did what a reader doubts.
TEST_F(CoupleInMemory, NotesWhatSpeaksAgainstTheParts) {
  EXPECT_TRUE(couple(scene_, problem_.parts).result.notes.empty());
  for (Complex& value : problem_.parts[0].values) value = std::conj(value);
  problem_.parts[1].header.doubts = {"line 1 states 'gain = 2.5'"};
  const std::vector<std::string> notes = couple(scene_, problem_.parts).result.notes;
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_THAT(notes[0],
              testing::AllOf(testing::StartsWith(scene_.names[0] + ": The driving point"), testing::HasSubstr("not passive")));
  EXPECT_EQ(notes[1], scene_.names[1] + ": line 1 states 'gain = 2.5'");
}

}  // namespace
}  // namespace jointid::tasks
