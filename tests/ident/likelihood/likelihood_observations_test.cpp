#include "ident/likelihood/data/observations.hpp"

#include <gtest/gtest.h>

#include "base/statistics.hpp"
#include "tests/ident/memory_systems.hpp"

namespace jointid::ident {
namespace {

const LikelihoodBlocks everything{{true, true, true}, {true, true, true}};

/// Two parts, others 1 and 9, joint 4 and 5, with everything measured at enough lines for some chunks.
struct Input {
  explicit Input(std::size_t count = 3, const frf::NoiseModel& model = {.kind = frf::NoiseKind::circular, .level = 0.1}) {
    std::mt19937_64 random(2);
    std::vector<double> axis;
    for (std::size_t i = 0; i < count; ++i) {
      axis.push_back(10.0 + double(i));
      lines.push_back({axis.back(), i, i});
    }
    const Dofs a = dofs({"1:+X", "4:+X"}), b = dofs({"9:+X", "5:+X"});
    parts = {random_set("a", axis, a, a, 1.0, random), random_set("b", axis, b, b, 1.0, random)};
    whole = random_set("assembly", axis, joined(a, b), joined(a, b), 1.0, random);
    scene.noise = NoiseSection{.model = frf::name(model.kind), .level = model.level, .frf_model = model};
  }

  Observations& read(const LikelihoodBlocks& blocks = everything) {
    substructures = memory_system("substructures", parts, frf::Composition::uncoupled);
    assembly = memory_system("assembly", {whole}, frf::Composition::merged);
    observations = std::make_unique<Observations>(scene, dofs({"1:+X", "9:+X", "4:+X", "5:+X"}), 2, blocks, *substructures, *assembly);
    observations->read(lines, [this](std::size_t) { ++chunks; });
    return *observations;
  }

  std::vector<frf::FrfSet> parts;
  frf::FrfSet whole;
  Scene scene;
  std::vector<Line> lines;
  std::unique_ptr<frf::FrfSystem> substructures, assembly;
  std::unique_ptr<Observations> observations;
  std::size_t chunks = 0;
};

std::vector<std::array<std::size_t, 2>> places(const std::vector<Element>& elements) {
  std::vector<std::array<std::size_t, 2>> all;
  for (const Element& e : elements) all.push_back({e.row, e.column});
  return all;
}
using Places = std::vector<std::array<std::size_t, 2>>;

TEST(Observations, LeaveOutWhatIsZeroByConstruction) {
  Input input;
  const LineLayout& layout = input.read().layout();
  EXPECT_EQ(places(layout.sub_jn), (Places{{0, 0}, {1, 1}}));
  EXPECT_EQ(layout.sub_jn_first, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(places(layout.sub_jj), (Places{{0, 0}, {1, 1}}));
  EXPECT_EQ(places(layout.asm_jn), (Places{{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
  EXPECT_EQ(places(layout.asm_jj), (Places{{0, 0}, {0, 1}, {1, 1}}));
  EXPECT_EQ(places(layout.drop_nn), (Places{{0, 0}, {0, 1}, {1, 1}}));
}

TEST(Observations, LeaveOutSubstructureFrfsThatAreZeroOnEveryLine) {
  Input input;
  for (std::size_t line = 0; line < 3; ++line) {
    frf::FrfSet& part = input.parts[0];
    part.values[part.index(line, 0, 1)] = part.values[part.index(line, 1, 0)] = 0.0;
  }
  EXPECT_EQ(places(input.read().layout().sub_jn), (Places{{1, 1}}));
  frf::FrfSet& part = input.parts[0];
  part.values[part.index(1, 0, 1)] = part.values[part.index(1, 1, 0)] = 1.0;
  EXPECT_EQ(places(input.read().layout().sub_jn), (Places{{0, 0}, {1, 1}}));
}

TEST(Observations, KeepUnmeasuredSubstructureFrfsAsFreeOnes) {
  Input input;
  const Observations& observations = input.read({{.nn = true, .jn = true}, {.nn = true, .jn = true}});
  EXPECT_EQ(places(observations.layout().sub_jj), (Places{{0, 0}, {1, 1}}));
  EXPECT_TRUE(observations.layout().asm_jj.empty());
  const LineData& line = observations.lines()[0];
  EXPECT_EQ(line.sub_jj.weight[0], Complex(0.0));
  EXPECT_EQ(line.measured, 2u * (2 + 4 + 3));
  EXPECT_EQ(line.redundancy(observations.layout()), 18.0 - 8.0);
}

TEST(Observations, ForgetAnAssemblyFrfThatNoLineHas) {
  Input input;
  for (std::size_t line = 0; line < 3; ++line) input.whole.values[input.whole.index(line, 0, 0)] = nan;
  input.whole.values[input.whole.index(1, 1, 1)] = nan;  // H_jj of coordinate 4 on one line
  const Observations& observations = input.read();
  EXPECT_EQ(places(observations.layout().drop_nn), (Places{{0, 1}, {1, 1}}));
  EXPECT_EQ(observations.lines()[1].asm_jj.weight[0], Complex(0.0));
  EXPECT_NE(observations.lines()[0].asm_jj.weight[0], Complex(0.0));
  EXPECT_EQ(observations.lines()[0].measured, observations.lines()[1].measured + 2);
}

TEST(Observations, DifferencesHaveBothVariances) {
  Input input;
  const LineData& line = input.read().lines()[2];
  const Complex sub = input.parts[0].values[input.parts[0].index(2, 0, 0)], whole = input.whole.values[input.whole.index(2, 0, 0)];
  EXPECT_EQ(line.drop_nn.value[0], sub - whole);
  EXPECT_NEAR(std::pow(line.drop_nn.weight[0].real(), -2.0), 0.005 * (std::norm(sub) + std::norm(whole)), 1e-12);
  // Across the parts there is that of the assembly alone, here of two measurements.
  const double one = std::norm(input.whole.values[input.whole.index(2, 0, 2)]);
  const double other = std::norm(input.whole.values[input.whole.index(2, 2, 0)]);
  EXPECT_NEAR(std::pow(line.drop_nn.weight[1].real(), -2.0), 0.005 / (1.0 / one + 1.0 / other), 1e-12);
}

TEST(Observations, AFloorIsThatOfAllLinesHoweverTheyAreRead) {
  Input many(5000, {.kind = frf::NoiseKind::circular, .level = 0.0, .floor = 0.1});
  const Observations& observations = many.read();
  EXPECT_GT(many.chunks, 1u);
  EXPECT_EQ(observations.lines().front().sub_jn.weight[1], observations.lines().back().sub_jn.weight[1]);
  const Complex before = observations.lines().back().sub_jj.weight[0];
  const LineState state{ComplexMatrix::Ones(2, 2), ComplexMatrix::Ones(2, 2), ComplexMatrix::Ones(2, 2), ComplexMatrix::Ones(2, 2)};
  many.observations->weigh_at(0, state, ComplexMatrix::Zero(2, 2));
  EXPECT_EQ(observations.lines().front().sub_jj.weight[0], before);
}

/// Makes (c, r) a copy of (r, c).
void symmetrise(frf::FrfSet& set) {
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t r = 0; r < set.header.response.size(); ++r) {
      for (std::size_t c = 0; c < r; ++c) set.values[set.index(line, r, c)] = set.values[set.index(line, c, r)];
    }
  }
}

TEST(Observations, TakeWeightsFromTheLawAtTheEstimatedValues) {
  Input input;
  for (frf::FrfSet* set : {&input.parts[0], &input.parts[1], &input.whole}) symmetrise(*set);
  Observations& observations = input.read();
  const LineLayout& layout = observations.layout();
  const LineData first = observations.lines()[1];
  LineState state{ComplexMatrix::Zero(2, 2), ComplexMatrix::Zero(2, 2), ComplexMatrix::Zero(2, 2), ComplexMatrix::Zero(2, 2)};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    state.sub_jn(k, k) = 1.25 * first.sub_jn.value[i];
    state.sub_jj(k, k) = 100.0 * first.sub_jj.value[i];
  }
  for (std::size_t i = 0; i < layout.asm_jn.size(); ++i) {
    state.asm_jn(static_cast<Eigen::Index>(layout.asm_jn[i].row), static_cast<Eigen::Index>(layout.asm_jn[i].column)) =
        0.8 * first.asm_jn.value[i];
  }
  observations.weigh_at(1, state, ComplexMatrix::Zero(2, 2));
  const LineData& now = observations.lines()[1];
  EXPECT_NEAR(now.sub_jn.weight[1].real(), first.sub_jn.weight[1].real() / 1.25, 1e-12 * first.sub_jn.weight[1].real());
  EXPECT_EQ(now.sub_jj.weight[0], 0.5 * first.sub_jj.weight[0]);  // no more than a factor of two
  EXPECT_EQ(now.asm_jj.weight[0], first.asm_jj.weight[0]);        // a value of zero gives no variance
  EXPECT_EQ(now.sub_jn.value, first.sub_jn.value);
  observations.weigh_at(1, state, ComplexMatrix::Zero(2, 2));
  EXPECT_EQ(observations.lines()[1].sub_jj.weight[0], 0.5 * first.sub_jj.weight[0]);  // of what they were at first
  EXPECT_NEAR(now.asm_jn.weight[0].real(), first.asm_jn.weight[0].real() / 0.8, 1e-12 * first.asm_jn.weight[0].real());
}

}  // namespace
}  // namespace jointid::ident
