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

TEST(ExactMarch, MeetsTheTransientsOfTheThesis) {
  for_each_golden("thesis_18dof", [](const json& one) {
    for (const std::string type : {"B", "E"}) {
      SCOPED_TRACE(type);
      JointedStructure structure = jointed(one);
      structure.laws = {law(one.at("joint_types").at(type)), law(one.at("joint_types").at(type))};
      const Eigen::VectorXcd amplitude = Complex(0.0, -1.0) * VectorXd::Unit(structure.coordinates(), 4);
      ExactMarch march(structure, ForceHistory::periodic(one.at("omega"), {1}, amplitude));
      const json& expected = one.at("type_" + type).at("transient");
      const Eigen::MatrixXd rows = matrix(expected.at(type == "B" ? "x5_x7_f2" : "x5_x7"));
      Eigen::MatrixXd found(rows.rows(), rows.cols());
      for (std::size_t i = 0; i < expected.at("times").size(); ++i) {
        ASSERT_EQ(march.march(expected.at("times")[i]), MarchStatus::reached);
        const Motion motion = march.motion();
        found(at(i), 0) = motion.x[4];
        found(at(i), 1) = motion.x[6];
        if (rows.cols() == 3) found(at(i), 2) = motion.f[1];
      }
      for (Eigen::Index k = 0; k < rows.cols(); ++k) EXPECT_LT(difference(found.col(k), rows.col(k)), 1e-9);
    printf("%s %g %zu %zu\n", type.c_str(), difference(found.leftCols(2), rows.leftCols(2)), march.events(), march.steps());
    }
  });
}

}  // namespace
}  // namespace jointid::response
