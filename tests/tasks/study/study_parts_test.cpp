// A study in parts, merged, is the study in one run.
#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <random>

#include "base/error.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/problem.hpp"
#include "study/study_records.hpp"
#include "study/trial_data.hpp"
#include "tasks/study/run_study.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

using testing::HasSubstr;

std::string bytes_of(const ident::Path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

class StudyParts : public testing::Test {
 protected:
  static constexpr std::size_t trials = 23, count = 4;

  study::StudyOptions options(const std::string& name) const {
    study::StudyOptions out;
    out.trials = trials;
    out.seed = 7;
    out.threads = 2;
    out.out = folder_ / name;
    out.texts = study_texts("[noise]\nlevel = 0.01");
    return out;
  }

  ident::Path part(std::size_t number, std::uint64_t seed = 7) const {
    study::StudyOptions asked = options("part" + std::to_string(number) + "-" + std::to_string(seed) + ".h5");
    asked.part = {number, count};
    asked.seed = seed;
    EXPECT_TRUE(run_study(data_, asked).run.complete);
    return asked.out;
  }

  std::string merge_error(const std::vector<ident::Path>& files) const {
    return error_of([&] { merge_study(files, folder_ / "wrong.h5"); });
  }

  TestFolder folder_;
  problems::Problem problem_ = problems::make("A1");
  ident::Scene scene_ = ident::read_scene(problems::write(problem_, folder_, {.format = "h5", .seed = 1, .clean = true}));
  std::shared_ptr<const study::TrialData> data_ =
      study::make_trial_data(scene_, study::Measurements{problem_.substructures, {problem_.assembly}});
};

TEST(StudyPart, AreReadAndCoverTheTrialsOnce) {
  EXPECT_EQ(study::parse_part("3/16").number, 3U);
  EXPECT_EQ(study::parse_part("3/16").count, 16U);
  for (const char* wrong : {"", "3", "0/4", "5/4", "1/0", "a/4", "1/4/2", "-1/4", "1 /4", "1/9999999999999999999999"})
    EXPECT_THAT(error_of([&] { study::parse_part(wrong); }), HasSubstr("is no part of a study")) << wrong;
  for (const std::size_t n : {1U, 16U, 17U, 1000U}) {
    std::size_t next = 0;
    for (std::size_t number = 1; number <= 16; ++number) {
      const frf::IndexRange range = study::trials_of({number, 16}, n);
      EXPECT_EQ(range.first, next);
      EXPECT_LE(range.end - range.first, n / 16 + 1);
      next = range.end;
    }
    EXPECT_EQ(next, n);
  }
}

TEST_F(StudyParts, MergedInAnyOrderAreTheStudyInOneRun) {
  const StudyResult whole = run_study(data_, options("whole.h5"));
  const StudyResult merged = merge_study({part(3), part(1), part(4), part(2)}, folder_ / "merged.h5");
  EXPECT_EQ(bytes_of(folder_ / "merged.h5"), bytes_of(folder_ / "whole.h5"));
  EXPECT_EQ(merged.statistics.trials, trials);
  EXPECT_EQ(merged.title, whole.title);
  EXPECT_EQ(merged.seed, 7U);
  EXPECT_EQ(merged.notes, whole.notes);
  for (std::size_t i = 0; i < whole.statistics.unknowns.size(); ++i) {
    EXPECT_EQ(merged.statistics.unknowns[i].mean, whole.statistics.unknowns[i].mean);
    EXPECT_EQ(merged.statistics.unknowns[i].std_deviation, whole.statistics.unknowns[i].std_deviation);
  }
}

TEST_F(StudyParts, OneThatWasStoppedGoesOn) {
  study::StudyOptions asked = options("stopped.h5");
  asked.part = {2, count};
  std::size_t made = 0;
  study::StudyControl control{.progress = {}, .interrupted = [&] { return made > 0; }, .row = [&](auto, auto) { ++made; }};
  asked.threads = 1;
  run_study(data_, asked, control);
  asked.resume = true;
  EXPECT_TRUE(run_study(data_, asked).run.complete);
  EXPECT_EQ(bytes_of(asked.out), bytes_of(part(2)));
  asked.part = {3, count};
  EXPECT_THAT(error_of([&] { run_study(data_, asked); }), HasSubstr("another part"));
  asked.part = {};
  EXPECT_THAT(error_of([&] { run_study(data_, asked); }), HasSubstr("belongs to another"));
}

TEST_F(StudyParts, OneThatIsMissingTwiceThereOrOfAnotherStudyIsNamed) {
  const ident::Path one = part(1), two = part(2), three = part(3), four = part(4);
  EXPECT_THAT(merge_error({one, four}), HasSubstr("parts are missing: 2/4, 3/4"));
  EXPECT_THAT(merge_error({one, two, three, three, four}), HasSubstr("part 3/4 is there twice"));
  EXPECT_THAT(merge_error({one, two, three, part(4, 8)}), HasSubstr("it is of another seed"));
  run_study(data_, options("whole.h5"));
  EXPECT_THAT(merge_error({folder_ / "whole.h5"}), HasSubstr("it is no part of a study"));
  EXPECT_THAT(merge_error({}), HasSubstr("there are no parts"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "wrong.h5"));
  EXPECT_THAT(error_of([&] { merge_study({one, two, three, four}, folder_ / "m.h5", "[noise]\nlevel = 0.02"); }),
              HasSubstr("its study is of another scene"));
}

TEST_F(StudyParts, FilesCutShortAreAnErrorOrTheStudy) {
  const ident::Path one = part(1), two = part(2), three = part(3), four = part(4), cut = folder_ / "cut.h5";
  run_study(data_, options("whole.h5"));
  const std::string all = bytes_of(two), whole = bytes_of(folder_ / "whole.h5");
  std::mt19937 random(1);
  std::size_t refused = 0;
  for (int i = 0; i < 100; ++i) {
    std::ofstream(cut, std::ios::binary) << all.substr(0, random() % all.size());
    const ident::Path out = folder_ / "merged.h5";
    std::filesystem::remove(out);
    try {
      merge_study({one, cut, three, four}, out);
      EXPECT_EQ(bytes_of(out), whole);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 90U);
}

}  // namespace
}  // namespace jointid::tasks
