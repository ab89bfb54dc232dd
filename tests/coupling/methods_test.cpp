#include "coupling/methods.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>


#include "base/error.hpp"
#include "dense/lu.hpp"
#include "random_assembly.hpp"

namespace jointid::coupling {
namespace {

double difference(const ComplexMatrix& a, const ComplexMatrix& b) { return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff(); }

constexpr double tolerance = 1e-9;

RC_GTEST_PROP(Methods, EqualTheDirectlyAssembledSystem, ()) {
  const RandomAssembly at = random_assembly({.symmetric = *rc::gen::arbitrary<bool>()});
  const Wanted all = everything(at.h);
  RC_ASSERT(difference(gic(at.h, at.conditions, all), at.assembled) < tolerance);
  RC_ASSERT(difference(grc(at.h, at.conditions, all), at.assembled) < tolerance);
  RC_ASSERT(difference(pcc(at.h, at.conditions, all), at.assembled) < tolerance);
  RC_ASSERT(difference(mtc(at.h, at.conditions, all).frf, at.assembled) < tolerance);
}

RC_GTEST_PROP(Methods, ReceptanceCouplingDoesWhereItApplies, ()) {
  const RandomAssembly at = random_assembly({.symmetric = *rc::gen::arbitrary<bool>(), .across_only = true});
  RC_ASSERT(!rc_lacks(at.conditions, at.body));
  RC_ASSERT(difference(rc(at.h, at.conditions, everything(at.h), at.body, at.body), at.assembled) < tolerance);
}

RC_GTEST_PROP(Methods, EqualEachOtherWithNoise, ()) {
  RandomAssembly at = random_assembly({.across_only = true});
  for (Index i = 0; i < at.h.rows(); ++i) {
    for (Index j = 0; j < at.h.cols(); ++j) {
      const double re = *rc::gen::inRange(950, 1051) / 1000.0, im = *rc::gen::inRange(950, 1051) / 1000.0;
      at.h(i, j) = {re * at.h(i, j).real(), im * at.h(i, j).imag()};
    }
  }
  const Wanted all = everything(at.h);
  const ComplexMatrix one = grc(at.h, at.conditions, all);
  RC_ASSERT(difference(gic(at.h, at.conditions, all), one) < tolerance);
  RC_ASSERT(difference(pcc(at.h, at.conditions, all), one) < tolerance);
  RC_ASSERT(difference(mtc(at.h, at.conditions, all).frf, one) < tolerance);
  RC_ASSERT(difference(rc(at.h, at.conditions, all, at.body, at.body), one) < tolerance);
}

RC_GTEST_PROP(Methods, SomeRowsAndColumnsAreThoseOfTheWhole, ()) {
  const RandomAssembly at = random_assembly({});
  const Index n = at.h.rows();
  Wanted some;
  for (int k = 0; k < 3; ++k) {
    some.rows.push_back(*rc::gen::inRange<Index>(0, n));
    some.columns.push_back(*rc::gen::inRange<Index>(0, n));
  }
  const ComplexMatrix expected = at.assembled(some.rows, some.columns);
  const double scale = at.assembled.cwiseAbs().maxCoeff();
  for (const ComplexMatrix& found : {gic(at.h, at.conditions, some), grc(at.h, at.conditions, some), pcc(at.h, at.conditions, some),
                                     mtc(at.h, at.conditions, some).frf}) {
    RC_ASSERT((found - expected).cwiseAbs().maxCoeff() < tolerance * scale);
  }
}

RC_GTEST_PROP(Methods, AJointIsAddedDynamicStiffness, ()) {
  const RandomAssembly at = random_assembly({});
  const Index n = at.h.rows();
  const std::vector<Index> joint = {0, n - 1};
  ComplexMatrix z(2, 2);
  z << Complex(2.0, 0.1), Complex(-1.0, 0.0), Complex(-1.0, 0.0), Complex(1.5, 0.3);
  ComplexMatrix sum = dense::inverse(at.h);
  sum(joint, joint) += z;
  RC_ASSERT(difference(with_joint(at.h, joint, z), dense::inverse(sum)) < tolerance);
}

TEST(Alpha, IsZeroForOneMotionAndTwoForGround) {
  EXPECT_EQ(alpha({1.0, 2.0}, {1.0, 2.0}, {1.0, 2.0}), 0.0);
  EXPECT_EQ(alpha({1.0, 2.0}, 0.0, 0.0), 2.0);
  EXPECT_EQ(alpha(0.0, 0.0, 0.0), 0.0);
  // (|3 − 1| + |3 − 2| + |2 − 1|) / (3 + 1 + 2)
  EXPECT_DOUBLE_EQ(alpha(3.0, 1.0, 2.0), 4.0 / 6.0);
}

TEST(Mtc, LeavesOutConditionsThatOthersImply) {
  // Coordinates 0 and 1 move as one, so do 2 and 3: the second condition follows from the first.
  ComplexMatrix h(4, 4);
  h << 1.0, 1.0, 0.0, 0.0,  //
      1.0, 1.0, 0.0, 0.0,   //
      0.0, 0.0, 2.0, 2.0,   //
      0.0, 0.0, 2.0, 2.0;
  const Conditions conditions = {{0, 2, 1.0}, {1, 3, 1.0}};
  const MtcResult result = mtc(h, conditions, everything(h), 0.01);
  EXPECT_THAT(result.coupled, testing::ElementsAre(true, false));
  EXPECT_DOUBLE_EQ(result.alpha[0], (1.0 + 1.0 + 2.0) / 3.0);
  EXPECT_NEAR(result.alpha[1], 0.0, 1e-15);
  EXPECT_NEAR(result.frf(0, 0).real(), 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(result.frf(1, 3).real(), 2.0 / 3.0, 1e-15);
}

TEST(Method, NamesAreRead) {
  EXPECT_EQ(parse_method("pcc"), Method::pcc);
  EXPECT_EQ(name(Method::mtc), "mtc");
  EXPECT_THROW(parse_method("gcr"), InputError);
}

}  // namespace
}  // namespace jointid::coupling
