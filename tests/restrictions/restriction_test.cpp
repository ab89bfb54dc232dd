#include "restrictions/restriction.hpp"

#include <gmock/gmock.h>

#include "tests/restrictions/joints.hpp"

namespace jointid::restrictions {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Doubles = std::vector<double>;

TEST(Restriction, FullHasEveryElementRowByRow) {
  const Restriction r = build({joint(dofs({"1:+X", "2:+X"}), Kind::stiffness, Pattern::full)});
  EXPECT_THAT(names(r), ElementsAre("K(1,1)", "K(1,2)", "K(2,1)", "K(2,2)"));
  EXPECT_EQ(r.matrix(Kind::stiffness, {1, 2, 3, 4}), (Doubles{1, 2, 3, 4}));
  EXPECT_FALSE(r.symmetric());
}

TEST(Restriction, SymmetricHasTheUpperTriangle) {
  const Restriction r = build({joint(dofs({"1:+X", "2:+X", "3:+X"}), Kind::mass, Pattern::symmetric)});
  EXPECT_THAT(names(r), ElementsAre("M(1,1)", "M(1,2)", "M(1,3)", "M(2,2)", "M(2,3)", "M(3,3)"));
  EXPECT_EQ(r.matrix(Kind::mass, {1, 2, 3, 4, 5, 6}), (Doubles{1, 2, 3, 2, 4, 5, 3, 5, 6}));
  EXPECT_TRUE(r.symmetric());
}

TEST(Restriction, DiagonalHasTheDiagonal) {
  const Restriction r = build({joint(dofs({"1:+X", "2:+X"}), Kind::viscous_damping, Pattern::diagonal)});
  EXPECT_THAT(names(r), ElementsAre("C(1,1)", "C(2,2)"));
  EXPECT_EQ(r.matrix(Kind::viscous_damping, {7, 8}), (Doubles{7, 0, 0, 8}));
  EXPECT_TRUE(r.symmetric());
}

TEST(Restriction, AMatrixThatNoJointNamesIsAbsentAndZero) {
  const Restriction r = build({joint(dofs({"1:+X"}), Kind::stiffness, Pattern::full)});
  EXPECT_TRUE(r.has(Kind::stiffness));
  EXPECT_FALSE(r.has(Kind::mass));
  EXPECT_THAT(r.matrices, SizeIs(1));
  EXPECT_EQ(r.matrix(Kind::mass, {1}), (Doubles{0}));
}

TEST(Restriction, SpringsStandBetweenTheirEnds) {
  const std::vector<Spring> springs = {spring("5:+Y", "4:+Y"), spring("4:+RZ", "ground")};
  const Restriction r = build({joint(beam_dofs(), Kind::stiffness, springs)});
  EXPECT_THAT(names(r), ElementsAre("K[5:+Y,4:+Y]", "K[4:+RZ,ground]"));
  EXPECT_THAT(units(r), ElementsAre("N/m", "N*m/rad"));
  EXPECT_EQ(r.matrix(Kind::stiffness, {3, 5}), (Doubles{3, 0, -3, 0, 0, 5, 0, 0, -3, 0, 3, 0, 0, 0, 0, 0}));
}

TEST(Restriction, SignsOfASpringCountRelativeToTheJoint) {
  // The joint measures node 1 along −X: a spring between u₁ and u₂ stretches by −q₁ − q₂.
  const Restriction r =
      build({joint(dofs({"1:-X", "2:+X"}), Kind::stiffness, std::vector<Spring>{spring("1:+X", "2:+X")})});
  EXPECT_EQ(r.matrix(Kind::stiffness, {2}), (Doubles{2, 2, 2, 2}));
}

/// Case B of the golden files: mass, stiffness and damping of one form.
EntryMatrix case_b_form() {
  return {{"a", "c", "e", "d"}, {"c", "b", "-d", "f"}, {"e", "-d", "a", "-c"}, {"d", "f", "-c", "b"}};
}

TEST(Restriction, CaseBHasEighteenUnknowns) {
  JointSpec spec = joint(beam_dofs(), Kind::hysteretic_damping, case_b_form());
  spec.matrices[Kind::stiffness] = case_b_form();
  spec.matrices[Kind::mass] = case_b_form();
  const Restriction r = build({spec});
  EXPECT_THAT(names(r), ElementsAre("K.a", "K.c", "K.e", "K.d", "K.b", "K.f", "M.a", "M.c", "M.e", "M.d", "M.b", "M.f",
                                    "D.a", "D.c", "D.e", "D.d", "D.b", "D.f"));
  EXPECT_TRUE(r.symmetric());
  Doubles y(18, 0.0);
  for (std::size_t i = 0; i < 6; ++i) y[6 + i] = static_cast<double>(i + 1);
  EXPECT_EQ(r.matrix(Kind::mass, y), (Doubles{1, 2, 3, 4, 2, 5, -4, 6, 3, -4, 1, -2, 4, 6, -2, 5}));
  EXPECT_EQ(r.matrix(Kind::stiffness, y), Doubles(16, 0.0));
}

TEST(Restriction, T10_4TiesTenElementsToFourUnknowns) {
  const EntryMatrix form = {
      {"A", "B", "-A", "B"}, {"B", "C", "-B", "D"}, {"-A", "-B", "A", "-B"}, {"B", "D", "-B", "C"}};
  const Restriction r = build({joint(beam_dofs(), Kind::stiffness, form)});
  EXPECT_THAT(names(r), ElementsAre("K.A", "K.B", "K.C", "K.D"));
  EXPECT_EQ(r.matrix(Kind::stiffness, {662400, 99360, 19872, 9936}),
            (Doubles{662400, 99360, -662400, 99360, 99360, 19872, -99360, 9936, -662400, -99360, 662400, -99360, 99360,
                     9936, -99360, 19872}));
}

TEST(Restriction, T10_2KeepsKnownNumbersOutOfTheUnknowns) {
  const EntryMatrix form = {{"A", 99360.0, "-A", 99360.0},
                            {99360.0, "C", "-99360", 9936.0},
                            {"-A", -99360.0, "A", -99360.0},
                            {99360.0, 9936.0, "-9.936e4", "C"}};
  const Restriction r = build({joint(beam_dofs(), Kind::stiffness, form)});
  EXPECT_THAT(names(r), ElementsAre("K.A", "K.C"));
  EXPECT_THAT(r.matrices[0].known, SizeIs(10));
  EXPECT_TRUE(r.symmetric());
  EXPECT_EQ(r.matrix(Kind::stiffness, {1, 2}),
            (Doubles{1, 99360, -1, 99360, 99360, 2, -99360, 9936, -1, -99360, 1, -99360, 99360, 9936, -99360, 2}));
}

TEST(Restriction, AnEntryMayMixUnknownsAndANumber) {
  const Restriction r = build({joint(dofs({"1:+X"}), Kind::stiffness, EntryMatrix{{"2*k+m-10"}})});
  EXPECT_THAT(names(r), ElementsAre("K.k", "K.m"));
  EXPECT_EQ(r.matrix(Kind::stiffness, {100, 7}), (Doubles{197}));
}

TEST(Restriction, AllNumbersLeaveNoUnknown) {
  const Restriction r = build({joint(dofs({"1:+X", "2:+X"}), Kind::stiffness, EntryMatrix{{1.0, 2.0}, {3.0, 0.0}})});
  EXPECT_THAT(r.unknowns, IsEmpty());
  EXPECT_THAT(r.matrices[0].known, SizeIs(3));
  EXPECT_FALSE(r.symmetric());
  EXPECT_EQ(r.matrix(Kind::stiffness, {}), (Doubles{1, 2, 3, 0}));
}

TEST(Restriction, SeveralJointsAreDiagonalBlocksAndKeepTheirNamesApart) {
  JointSpec left = joint(dofs({"1:+X", "2:+X"}), Kind::stiffness, EntryMatrix{{"k", "-k"}, {"-k", "k"}});
  left.name = "left";
  JointSpec right = joint(dofs({"3:+X"}), Kind::stiffness, EntryMatrix{{"k"}});
  right.name = "right";
  right.matrices[Kind::mass] = Pattern::full;
  left.matrices[Kind::viscous_damping] = Pattern::diagonal;
  const Restriction r = build({left, right});
  EXPECT_THAT(names(r), ElementsAre("left.K.k", "right.K.k", "right.M(1,1)", "left.C(1,1)", "left.C(2,2)"));
  EXPECT_EQ(r.dofs, dofs({"1:+X", "2:+X", "3:+X"}));
  const Doubles y = {1, 2, 3, 4, 5};
  EXPECT_EQ(r.matrix(Kind::stiffness, y), (Doubles{1, -1, 0, -1, 1, 0, 0, 0, 2}));
  EXPECT_EQ(r.matrix(Kind::mass, y), (Doubles{0, 0, 0, 0, 0, 0, 0, 0, 3}));
  EXPECT_EQ(r.matrix(Kind::viscous_damping, y), (Doubles{4, 0, 0, 0, 5, 0, 0, 0, 0}));
  EXPECT_EQ(r.unknowns[1].joint, 1u);
  EXPECT_EQ(r.unknowns[3].joint, 0u);
}

}  // namespace
}  // namespace jointid::restrictions
