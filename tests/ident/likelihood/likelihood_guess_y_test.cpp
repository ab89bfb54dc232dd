#include "ident/likelihood/model/guess_y.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "likelihood_line_sample.hpp"

namespace jointid::ident {
namespace {

/// On exact FRFs the unmeasured Y are found, also when the joint has rigid-body motions, so that Z A has not full rank.
RC_GTEST_PROP(GuessY, IsExactOnExactData, (unsigned seed, bool with_some)) {
  std::mt19937_64 random(seed);
  LineSample s({.others = 6, .joint = 4, .uncoupled = true, .noise = 1e-12}, random);
  RC_PRE(s.layout.sub_jn.size() >= 8 && s.layout.sub_jj.size() <= 6);  // two joint coordinates in each part
  const ComplexMatrix shape = ComplexMatrix::Identity(4, 4) - ComplexMatrix::Constant(4, 4, 0.25), z = shape * s.joint.at(s.theta) * shape;
  put_on_constraint(s.layout, z, s.exact);
  for (std::size_t i = 0; i < s.layout.asm_jn.size(); ++i) {
    s.data.asm_jn.value[i] =
        s.exact.asm_jn(LineSample::index(s.layout.asm_jn[i].row), LineSample::index(s.layout.asm_jn[i].column));
  }
  for (std::size_t i = with_some ? 1 : 0; i < s.layout.sub_jj.size(); ++i) s.data.sub_jj.weight[i] = 0.0;
  LineState state = s.exact;
  for (std::size_t i = 0; i < s.layout.sub_jj.size(); ++i) {
    const auto [p, q] = s.layout.sub_jj[i];
    if (s.data.sub_jj.weight[i] == Complex(0.0)) state.sub_jj(LineSample::index(p), LineSample::index(q)) = 7.0;
  }
  guess_y(s.layout, s.data, z, state);
  ComplexMatrix wrong = state.sub_jj * z * s.exact.asm_jn - (s.exact.sub_jn - s.exact.asm_jn);
  RC_ASSERT(wrong.norm() <= 1e-8 * s.exact.sub_jn.norm());
  RC_ASSERT((state.sub_jj - state.sub_jj.transpose()).norm() == 0.0);
  RC_ASSERT((state.sub_jj - s.exact.sub_jj).norm() <= 1e-5 * s.exact.sub_jj.norm());
}

TEST(GuessY, LeavesMeasuredOnesAlone) {
  std::mt19937_64 random(1);
  LineSample s({.others = 3, .joint = 2}, random);
  LineState state = s.exact;
  guess_y(s.layout, s.data, s.joint.at(s.theta), state);
  EXPECT_EQ(state.sub_jj, s.exact.sub_jj);
}

TEST(GuessY, IsZeroWithoutAnyAssemblyFrfOfTheJoint) {
  std::mt19937_64 random(1);
  LineSample s({.others = 3, .joint = 2}, random);
  for (Complex& weight : s.data.asm_jn.weight) weight = 0.0;
  for (Complex& weight : s.data.sub_jj.weight) weight = 0.0;
  LineState state = s.exact;
  guess_y(s.layout, s.data, s.joint.at(s.theta), state);
  EXPECT_EQ(state.sub_jj.norm(), 0.0);
}

}  // namespace
}  // namespace jointid::ident
