// The equations of a line solved by their structure against those of all rows, which likelihood_line_model_test.cpp holds to
// differences.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "base/eigen.hpp"
#include "ident/likelihood/elimination/elimination_flops.hpp"
#include "ident/likelihood/model/line_model.hpp"
#include "likelihood_line_sample.hpp"

namespace jointid::ident {
namespace {

/// Circular errors, of sizes that are apart by factors up to `ratio`.
void make_circular(LineSample& s, double ratio, std::mt19937_64& random) {
  std::uniform_real_distribution<double> power(-0.5, 0.5);
  for (Channel* channel : {&s.data.sub_jn, &s.data.sub_jj, &s.data.asm_jn, &s.data.asm_jj, &s.data.drop_nn}) {
    for (Complex& weight : channel->weight) weight = weight.real() * std::pow(ratio, power(random)) * Complex(1.0, 1.0);
  }
}

/// Systematic errors in some elements.
void add_errors(LineSample& s, std::mt19937_64& random) {
  std::uniform_int_distribution<std::size_t> count(0, 2);
  auto terms = std::make_shared<SystematicTerms>();
  terms->unknowns = 2;
  terms->first.assign(1, 0);
  for (const Channel* channel : {&s.data.sub_jn, &s.data.sub_jj, &s.data.asm_jn, &s.data.asm_jj, &s.data.drop_nn}) {
    for (std::size_t i = 0; i < channel->value.size(); ++i) {
      for (std::size_t u = count(random); u < terms->unknowns; ++u) terms->terms.push_back({u, s.any(), s.any(), s.any()});
      terms->first.push_back(terms->terms.size());
    }
  }
  s.data.terms = std::move(terms);
}

/// Some FRFs off, and A and B off the constraint unless asked for.
LineState moved(LineSample& s, bool on_constraint) {
  LineState state = s.exact;
  LineStep step(at(2 * s.layout.variables()));
  for (double& value : step) value = s.normal();
  move(s.layout, step, 0.05, state.sub_jn, state.sub_jj);
  put_on_constraint(s.layout, s.joint.at(s.theta), state);
  if (on_constraint) return state;
  state.asm_jn += 0.05 * s.any(state.asm_jn);
  if (!s.layout.asm_jj.empty()) state.asm_jj += 0.05 * s.any(state.asm_jj);
  return state;
}

double size_of(const Eigen::MatrixXd& a) { return a.size() == 0 ? 0.0 : a.cwiseAbs().maxCoeff(); }

/// Complex and real equations of all rows, and what is to be the same.
struct Ways {
  LineModel complex, real, structure, blocks;

  explicit Ways(const LineLayout& layout)
      : complex(layout, LineModel::Numbers::complex),
        real(layout, LineModel::Numbers::real),
        structure(layout, LineModel::Numbers::eliminated),
        blocks(layout, LineModel::Numbers::blocks) {}
};

/// To `tolerance` of its size, or as far as the other two agree: what the equations hardly fix has lost digits in these, too.
void expect_same(const Eigen::MatrixXd& found, const Eigen::MatrixXd& complex, const Eigen::MatrixXd& real, double tolerance,
                 double size = 0.0) {
  RC_ASSERT(found.rows() == complex.rows() && found.cols() == complex.cols());
  RC_ASSERT(size_of(found - complex) <= tolerance * (size + size_of(complex)) + 100.0 * size_of(complex - real));
}

/// Information, gradient and χ².
void expect_same_reduction(const ReducedLine& found, const ReducedLine& complex, const ReducedLine& real, double tolerance) {
  expect_same(found.information, complex.information, real.information, tolerance);
  const double size = std::sqrt(size_of(complex.information) * complex.cost);
  expect_same(found.gradient, complex.gradient, real.gradient, tolerance, size);
  RC_ASSERT(std::abs(found.cost - complex.cost) <= tolerance * complex.cost + 100.0 * std::abs(complex.cost - real.cost));
}

void expect_same_ways(const LineSample& s, Ways& ways, const LineState& state, double tolerance) {
  for (const bool with_joint : {true, false}) {
    for (LineModel* model : {&ways.complex, &ways.real, &ways.structure, &ways.blocks}) {
      model->linearise(s.data, s.joint, s.joint.at(s.theta), state, with_joint);
    }
    for (const double damping : {0.0, 0.1, 0.0}) {
      const auto complex = ways.complex.reduce(damping), real = ways.real.reduce(damping);
      RC_ASSERT(complex.has_value() && real.has_value());
      for (LineModel* model : {&ways.structure, &ways.blocks}) {
        const auto found = model->reduce(damping);
        RC_ASSERT(found.has_value());
        expect_same_reduction(*found, *complex, *real, tolerance);
        expect_same(found->back->matrix(), complex->back->matrix(), real->back->matrix(), tolerance);
        expect_same(found->own, complex->own, real->own, tolerance, 1.0);
        LineStep any(complex->own.size());
        for (Eigen::Index i = 0; i < any.size(); ++i) any[i] = std::sin(static_cast<double>(i));
        expect_same(model->own_step(any), ways.complex.own_step(any), ways.real.own_step(any), tolerance);
        const auto without_answer = model->reduce(damping, false);
        RC_ASSERT(without_answer.has_value() && without_answer->back == nullptr);
        expect_same_reduction(*without_answer, *complex, *real, tolerance);
      }
    }
  }
}

RC_GTEST_PROP(LikelihoodElimination, SolvesTheEquationsOfAllRows, (unsigned seed)) {
  std::mt19937_64 random(seed);
  const auto up_to = [&](std::size_t most) { return std::uniform_int_distribution<std::size_t>(1, most)(random); };
  std::bernoulli_distribution coin;
  LineSample s({.others = up_to(6), .joint = up_to(6), .with_b = coin(random), .undriven = coin(random), .uncoupled = coin(random)},
               random);
  make_circular(s, coin(random) ? 10.0 : 1.0, random);
  // Not all of A, B and D.
  std::bernoulli_distribution absent(coin(random) ? 0.2 : 0.0);
  for (Channel* channel : {&s.data.asm_jn, &s.data.asm_jj, &s.data.drop_nn}) {
    for (Complex& weight : channel->weight) weight = absent(random) ? Complex(0.0) : weight;
  }
  if (coin(random)) add_errors(s, random);
  const LineState state = moved(s, coin(random));
  Ways ways(s.layout);
  expect_same_ways(s, ways, state, 1e-10);
}

/// Of four coordinates the first two are driven: D lacks the FRFs of the others with each other.
TEST(ArrowLayout, EliminatesCoordinatesWithoutAForceOneByOne) {
  LineLayout layout;
  layout.others = 4;
  layout.joint = 2;
  layout.sub_jn_first = {0};
  for (std::size_t k = 0; k < layout.others; ++k) {
    for (std::size_t p = 0; p < layout.joint; ++p) layout.sub_jn.push_back({p, k});
    for (std::size_t r = 0; r <= k && r < 2; ++r) layout.drop_nn.push_back({r, k});
    layout.sub_jn_first.push_back(layout.sub_jn.size());
  }
  layout.sub_jj = {{0, 0}, {0, 1}, {1, 1}};
  const ArrowLayout arrow(layout);
  ASSERT_EQ(arrow.lone.size(), 2u);
  EXPECT_EQ(arrow.core, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(arrow.core_size(), 4 + 3);
  EXPECT_EQ(arrow.lone_size, 4);
  for (const ArrowLayout::Lone& lone : arrow.lone) EXPECT_EQ(lone.touches.size(), 2u);
  EXPECT_EQ(arrow.core_pairs.size(), 3u);
}

/// Weights by a factor of 10⁴ apart.
RC_GTEST_PROP(LikelihoodElimination, KeepsDigitsWithErrorsOfAllSizes, (unsigned seed)) {
  std::mt19937_64 random(seed);
  LineSample s({.others = 4, .joint = 4, .with_b = true, .undriven = true, .uncoupled = true}, random);
  make_circular(s, 1e4, random);
  const LineState state = moved(s, true);
  Ways ways(s.layout);
  expect_same_ways(s, ways, state, 1e-7);
}

}  // namespace
}  // namespace jointid::ident
