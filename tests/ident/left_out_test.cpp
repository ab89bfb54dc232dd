#include <gmock/gmock.h>

#include <filesystem>
#include <set>

#include "frf/file/write.hpp"
#include "ident/equations/linear_plan.hpp"
#include "ident/identify.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "memory_systems.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using restrictions::Pattern;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// Everything a source was asked for.
struct Asked {
  std::set<std::pair<std::string, std::string>> frfs;  ///< response, reference
  std::set<std::size_t> lines;
  std::set<std::tuple<std::size_t, std::string, std::string>> values;  ///< line, response, reference
  std::size_t again = 0;                                               ///< values that were asked for before
};

/// A set in memory that writes down which FRFs are read.
class Recorder final : public frf::FrfSource {
 public:
  Recorder(frf::FrfSet set, Asked& asked) : asked_(asked), source_(frf::from_memory(std::move(set))) {
    header_ = source_->header();
  }

 private:
  void do_read(const frf::Block& block, std::span<Complex> out) override {
    for (const std::size_t r : block.responses) {
      for (const std::size_t c : block.references) {
        const std::string response = header_.response[r].name(), reference = header_.reference[c].name();
        asked_.frfs.emplace(response, reference);
        for (const std::size_t line : block.lines) asked_.again += asked_.values.emplace(line, response, reference).second ? 0U : 1U;
      }
    }
    asked_.lines.insert(block.lines.begin(), block.lines.end());
    source_->read(block, out);
  }
  void do_read_variance(const frf::Block&, std::span<Complex>) override { FAIL() << "variance was read"; }
  void do_read_coherence(const frf::Block&, std::span<double>) override { FAIL() << "coherence was read"; }

  Asked& asked_;
  std::unique_ptr<frf::FrfSource> source_;
};

struct Run {
  Asked substructures, assembly;
  std::unique_ptr<Plan> plan;
};

/// Case A1; both substructures write into one list.
std::unique_ptr<Run> run_section(const IdentifySection& identify, bool carry_out) {
  const problems::Problem a1 = problems::make("A1");
  Scene scene = problems::scene(a1);
  scene.identify = identify;
  const frf::NoiseModel noise{.level = 0.01};
  scene.noise = NoiseSection{.model = frf::name(noise.kind), .level = noise.level, .frf_model = noise};
  auto run = std::make_unique<Run>();
  std::vector<std::unique_ptr<frf::FrfSource>> parts, whole;
  for (const frf::FrfSet& set : a1.substructures) parts.push_back(std::make_unique<Recorder>(set, run->substructures));
  whole.push_back(std::make_unique<Recorder>(a1.assembly, run->assembly));
  run->plan = make_plan(
      scene,
      std::make_unique<frf::FrfSystem>("substructures", std::move(parts), frf::Composition::uncoupled, false),
      std::make_unique<frf::FrfSystem>("assembly", std::move(whole), frf::Composition::merged, false));
  if (carry_out) solve(*run->plan);
  return run;
}

/// With some equations.
std::unique_ptr<Run> run(const std::vector<Equation>& equations, bool carry_out = true, Method method = Method::one) {
  IdentifySection identify;
  identify.method = method;
  identify.equations = equations;
  return run_section(identify, carry_out);
}

bool is_joint(const std::string& dof) { return dof[0] == '4' || dof[0] == '5'; }

/// Whether an FRF of the block (response joint or not, reference joint or not) was read.
bool read(const Asked& asked, bool joint_response, bool joint_reference) {
  for (const auto& [response, reference] : asked.frfs) {
    if (is_joint(response) == joint_response && is_joint(reference) == joint_reference) return true;
  }
  return false;
}

TEST(LeftOut, APlanReadsNoFrf) {
  const auto done = run({Equation::nn}, false);
  EXPECT_TRUE(done->substructures.frfs.empty());
  EXPECT_TRUE(done->assembly.frfs.empty());
}

TEST(LeftOut, NnAloneReadsItsFourBlocks) {
  const auto done = run({Equation::nn});
  EXPECT_TRUE(read(done->substructures, false, false));   // H_aa
  EXPECT_TRUE(read(done->substructures, true, false));    // H_ba
  EXPECT_FALSE(read(done->substructures, true, true));    // H_bb
  EXPECT_FALSE(read(done->substructures, false, true));   // H_ab
  EXPECT_TRUE(read(done->assembly, false, false));        // H_nn
  EXPECT_TRUE(read(done->assembly, false, true));         // H_nj
  EXPECT_FALSE(read(done->assembly, true, true));         // H_jj
  EXPECT_FALSE(read(done->assembly, true, false));        // H_jn
}

TEST(LeftOut, NjAloneReadsNothingOfTheNonJointReferences) {
  const auto done = run({Equation::nj});
  EXPECT_FALSE(read(done->substructures, false, false));
  EXPECT_FALSE(read(done->substructures, true, false));
  EXPECT_FALSE(read(done->assembly, false, false));
  EXPECT_FALSE(read(done->assembly, true, true));
  EXPECT_TRUE(read(done->substructures, false, true));
  EXPECT_TRUE(read(done->substructures, true, true));
}

TEST(LeftOut, JjAloneIsModelUpdatingAtTheJoint) {
  const auto done = run({Equation::jj});
  for (const Asked* asked : {&done->substructures, &done->assembly}) {
    EXPECT_TRUE(read(*asked, true, true));
    EXPECT_FALSE(read(*asked, false, false) || read(*asked, false, true) || read(*asked, true, false));
  }
}

TEST(LeftOut, JnAloneReadsNoNonJointResponse) {
  const auto done = run({Equation::jn});
  for (const Asked* asked : {&done->substructures, &done->assembly}) {
    EXPECT_FALSE(read(*asked, false, false) || read(*asked, false, true));
  }
  EXPECT_FALSE(read(done->substructures, true, true));
}

TEST(LeftOut, LinearMethodsPrepareNoLikelihood) {
  for (const Method method : {Method::one, Method::direct}) EXPECT_EQ(likelihood_plan(*run({}, false, method)->plan), nullptr);
  const auto planned = run({Equation::nn}, false, Method::likelihood);
  EXPECT_NE(likelihood_plan(*planned->plan), nullptr);
  EXPECT_EQ(linear_plan(*planned->plan), nullptr);
  EXPECT_TRUE(planned->substructures.frfs.empty() && planned->assembly.frfs.empty());
}

TEST(LeftOut, TheLikelihoodReadsWhatItsEquationsRead) {
  const auto nn = run({Equation::nn}, true, Method::likelihood);
  EXPECT_FALSE(read(nn->substructures, true, true));  // H_bb
  EXPECT_FALSE(read(nn->assembly, true, true));       // H_jj
  EXPECT_TRUE(read(nn->assembly, false, false) && read(nn->assembly, false, true));
  const auto nj = run({Equation::nj}, true, Method::likelihood);
  EXPECT_FALSE(read(nj->substructures, false, false));
  EXPECT_FALSE(read(nj->assembly, false, false) || read(nj->assembly, true, true));
  const auto jj = run({Equation::jj}, true, Method::likelihood);
  EXPECT_FALSE(read(jj->assembly, false, false) || read(jj->assembly, false, true) || read(jj->assembly, true, false));
}

/// For the estimate, all linear estimates that it starts from, its prediction, and what is said of its data.
TEST(LeftOut, EveryMethodReadsEveryFrfOnce) {
  const auto all = [](double value) { return Matrix(4, std::vector<double>(4, value)); };
  const std::map<Kind, Matrix> near = {{Kind::stiffness, all(1e5)}, {Kind::hysteretic_damping, all(1e3)}};
  const auto section = [](Method method, std::size_t starts, const std::map<Kind, Matrix>& start) {
    IdentifySection identify;
    identify.method = method;
    identify.starts = starts;
    identify.start = start;
    return identify;
  };
  for (const IdentifySection& identify :
       {section(Method::one, 0, {}), section(Method::two, 0, {}), section(Method::direct, 0, {}), section(Method::newton, 2, {}),
        section(Method::newton, 0, near), section(Method::likelihood, 6, {}), section(Method::likelihood, 0, near)}) {
    const auto done = run_section(identify, true);
    for (const Asked* asked : {&done->substructures, &done->assembly}) {
      EXPECT_GT(asked->values.size(), 0u);
      EXPECT_EQ(asked->again, 0u) << name(identify.method) << (identify.start.empty() ? "" : " from a start");
    }
  }
}

TEST(LeftOut, ThePlanSaysWhatItLeavesOutAndHasNoColumnsForIt) {
  const auto done = run({Equation::nn}, false);
  EXPECT_EQ(done->plan->cost.columns, 20u);  // K and D, no M and C
  EXPECT_THAT(done->plan->left_out, Contains("mass: no columns"));
  EXPECT_THAT(done->plan->left_out, Contains("viscous_damping: no columns"));
  EXPECT_THAT(done->plan->left_out, Contains("H_bb: not read"));
  EXPECT_THAT(done->plan->left_out, Contains("the delta filter"));
  EXPECT_THAT(done->plan->left_out, Not(Contains(HasSubstr("stiffness"))));
  const auto all = run({}, false);
  EXPECT_THAT(all->plan->left_out, Not(Contains(HasSubstr("not read"))));
}

TEST(LeftOut, ThePlanCountsWhatIsRead) {
  const problems::Problem a1 = problems::make("A1");
  Scene scene = problems::scene(a1);
  scene.identify.equations = {Equation::nn};
  const auto plan = problems::plan(scene, {a1.substructures, a1.assembly});
  EXPECT_EQ(plan->cost.equations_per_line, 100u);
  EXPECT_EQ(plan->cost.lines, 31u);
  solve(*plan);
  EXPECT_EQ(plan->assembly->source(0).count().entries, 31u * 10u * 14u);
  // The two parts hold 6×6 + 2×6 and 4×4 + 2×4 of H_aa and H_ba; the rest is zero by construction.
  EXPECT_EQ(plan->substructures->source(0).count().entries, 31u * 48u);
  EXPECT_EQ(plan->substructures->source(1).count().entries, 31u * 24u);
  EXPECT_EQ(plan->cost.bytes_read, 31u * (140u + 140u) * sizeof(Complex));
}

TEST(LeftOut, FourLinesOfALargeFileAreFourLinesRead) {
  const TestFolder folder;
  std::vector<double> lines;
  for (int i = 1; i <= 10000; ++i) lines.push_back(0.1 * i);
  std::mt19937_64 random(1);
  const Dofs all = dofs({"1:+X", "2:+X", "3:+X"});
  frf::write(random_set("parts", lines, all, all, 1.0, random), folder / "parts.h5");
  frf::write(random_set("assembly", lines, all, all, 1.0, random), folder / "assembly.h5");
  Scene scene;
  scene.data.substructures = {{folder / "parts.h5", {}}};
  scene.data.assembly = {{folder / "assembly.h5", {}}};
  scene.joints = {joint_of(dofs({"1:+X", "2:+X"}), Kind::stiffness, Pattern::symmetric)};
  scene.identify.equations = {Equation::nn};
  scene.frequency.range_hz = {{500.0, 500.3}};
  const auto plan = make_plan(scene);
  EXPECT_EQ(plan->cost.lines, 4u);
  EXPECT_THAT(plan->left_out, Contains("9996 of 10000 lines: not read"));
  EXPECT_EQ(solve(*plan).fit.lines, 4u);
  for (const frf::FrfSystem* system : {plan->substructures.get(), plan->assembly.get()}) {
    const frf::ReadCount& count = system->source(0).count();
    EXPECT_EQ(count.entries % 4, 0u);
    EXPECT_LE(count.entries, 4u * 3u);
    EXPECT_EQ(count.lines, 4u * count.calls);
  }
}

}  // namespace
}  // namespace jointid::ident
