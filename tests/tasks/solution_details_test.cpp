#include "tasks/solution_details.hpp"

#include <gmock/gmock.h>

#include "base/control.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "problems/vibration/rig_two.hpp"
#include "tasks/equivalent.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

TEST(SolutionDetails, HaveTheFrfThatIsAskedForAndTheWorst) {
  const problems::Problem problem = problems::make("A1");
  const auto plan = ident::make_plan(problems::scene(problem), problem.substructures, {problem.assembly});
  const ident::Solution solution = ident::solve(*plan);
  const FrfEntry asked{plan->assembly->responses().back(), plan->assembly->references().front()};
  const SolutionDetails details = solution_details(*plan, solution, {.first = asked, .frfs = 5, .worst = 2});
  ASSERT_FALSE(details.regenerated.frfs.empty());
  EXPECT_EQ(details.regenerated.frfs.front().entry, asked);
  EXPECT_LE(details.regenerated.frfs.size(), 6U);
  EXPECT_TRUE(details.all_used);
  EXPECT_FALSE(details.quality.empty());
  const std::size_t worst = worst_first(details.errors.rms_db).front(), columns = details.errors.references.size();
  const FrfEntry entry{details.errors.responses[worst / columns], details.errors.references[worst % columns]};
  EXPECT_TRUE(std::ranges::any_of(details.regenerated.frfs, [&](const RegeneratedFrf& frf) { return frf.entry == entry; }));
}

TEST(SolutionDetails, AnInterruptedEstimateSaysSo) {
  ident::Solution best;
  best.fit.iterations = 3;
  best.message = "More.";
  mark_interrupted(best);
  EXPECT_EQ(best.status, ident::Status::not_converged);
  EXPECT_EQ(best.message, "Interrupted after 3 iterations: these are the best values so far. More.");
}

TEST(FindEquivalent, StopsBetweenLevels) {
  const TestFolder folder;
  const ident::EquivalentScene scene =
      ident::read_equivalent_scene(problems::write(problems::make_rig_two("rig2"), folder, {.format = "h5", .clean = true}));
  std::size_t asked = 0;
  ident::Control control;
  control.interrupted = [&] { return ++asked > 2; };
  EXPECT_THROW(find_equivalent(scene, control), Interrupted);
  EXPECT_EQ(asked, 3U);
}

}  // namespace
}  // namespace jointid::tasks
