#include "response/time/exact_march.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "golden.hpp"

namespace jointid::response {
namespace {

using Eigen::VectorXd;
using nlohmann::json;

Eigen::VectorXd first(Eigen::Index size, double value) { return value * VectorXd::Unit(size, 0); }

ForceHistory force_of(const json& one) {
  const Eigen::Index size = matrix(one.at("M")).rows();
  const double p = one.at("p");
  if (one.contains("td")) return ForceHistory::half_sine(first(size, 2.0 * p), one.at("td"));
  return ForceHistory::periodic(one.at("omega"), {1}, Complex(0.0, -1.0) * first(size, p));
}

TEST(ExactMarch, MeetsTheGoldenTransients) {
  for_each_golden("transient_exact", [](const json& one) {
    SCOPED_TRACE(one.at("id").get<std::string>());
    ExactMarch march(jointed(one), force_of(one));
    const auto& times = one.at("times");
    Eigen::MatrixXd x(times.size(), 3), v(times.size(), 3);
    for (std::size_t i = 0; i < times.size(); ++i) {
      // The times are printed with six digits; the sines' are fifths of the run.
      ASSERT_EQ(march.march(times[i]), MarchStatus::reached);
      x.row(at(i)) = march.motion().x;
      v.row(at(i)) = march.motion().v;
    }
    EXPECT_LT(difference(x, matrix(one.at("x"))), tolerance(one));
    EXPECT_LT(difference(v, matrix(one.at("v"))), tolerance(one));
    printf("%s %g %g events %zu steps %zu\n", one.at("id").get<std::string>().c_str(), difference(x, matrix(one.at("x"))), difference(v, matrix(one.at("v"))), march.events(), march.steps());
    if (one.contains("joint_at_end")) {
      EXPECT_LT(difference(march.motion().f, vector(one.at("joint_at_end").at("F"))), 10.0 * tolerance(one));
    }
  });
}

}  // namespace
}  // namespace jointid::response
