#pragma once

#include <limits>

#include "ident/result/solution.hpp"

namespace jointid::report {

/// A solution made by hand: two DOFs, one determined unknown, one that the data do not fix, one non-finite figure.
inline ident::Solution sample_solution() {
  using restrictions::Kind;
  ident::Solution solution;
  solution.status = ident::Status::rank_deficient;
  solution.message = "k2 is not fixed by the data";
  solution.unknowns = {{.name = "K(1,1)", .unit = "N/m", .value = 1e6, .std_error = 2e3, .ci95 = {{9.9e5, 1.01e6}}, .rounding = {}},
                       {.name = "k2",
                        .unit = "N",
                        .value = std::numeric_limits<double>::quiet_NaN(),
                        .determined = false,
                        .std_error = {},
                        .ci95 = {},
                        .rounding = {}}};
  solution.dofs = {frf::Dof::parse("4:+Y"), frf::Dof::parse("4:+RZ")};
  solution.bands = {{.band_hz = {}, .matrices = {{Kind::stiffness, {{1e6, 5.0}, {5.0, 20.0}}}}}};
  solution.fit = {.equations_used = 12, .equations_dropped = 3, .lines = 4, .rank = 1,
                  .condition = std::numeric_limits<double>::infinity(), .digits = {}, .chi_square = {}, .asm_frf_error = {}};
  solution.quality[Kind::stiffness] = {.rjcf = 0.25, .arvf = 0.125, .rms_relative_error = 0.5};
  solution.runtime_s = {.read = 0.5, .assemble = 0.25, .solve = 0.125, .total = 1.0};
  solution.used = {.method = ident::Method::one,
                   .equations = {ident::Equation::nn, ident::Equation::nj},
                   .weighting = weighting::Weighting::wbs,
                   .delta = 0.05,
                   .solver = "qr"};
  return solution;
}

/// The same as method "likelihood" would give it.
inline ident::Solution sample_likelihood() {
  ident::Solution solution = sample_solution();
  solution.used.method = ident::Method::likelihood;
  solution.used.solver = "gauss-helmert";
  solution.fit.iterations = 9;
  solution.fit.chi_square = {.value = 812.25, .degrees_of_freedom = 800.0, .outlying_lines = 2,
                             .by_line = {1.5, std::numeric_limits<double>::quiet_NaN()}};
  solution.variances = {{"a.uff", "the law of [noise]", ""}, {"b.uff", "estimated", "b.uff: too few lines"}};
  return solution;
}

/// 500 joints with 20 unknowns each, of 501 files: j77 has the worst error, and two unknowns of j5 are not determined.
inline ident::Solution sample_of_many_joints() {
  ident::Solution solution = sample_solution();
  solution.unknowns.clear();
  solution.bands.clear();
  for (int joint = 1; joint <= 500; ++joint) {
    for (int u = 0; u < 20; ++u) {
      ident::Estimate each = sample_solution().unknowns.front();
      const std::string kind = u < 10 ? "K" : "D";
      each.name = "j" + std::to_string(joint) + "." + kind + "(1," + std::to_string(u % 10 + 1) + ")";
      each.value = (u < 10 ? 1e6 : 1e4) * (1.0 + 0.1 * (u % 10));
      each.std_error = each.value * (joint == 77 && u == 3 ? 0.5 : 0.01);
      each.determined = joint != 5 || u > 1;
      solution.unknowns.push_back(each);
    }
  }
  for (int file = 1; file <= 501; ++file) solution.variances.push_back({"part_" + std::to_string(file) + ".h5", "the law of [noise]", ""});
  return solution;
}

/// The same under constraints, of which one holds.
inline ident::Solution sample_constrained() {
  ident::Solution solution = sample_solution();
  solution.unknowns[0].limit = "K is singular";
  solution.admissibility = ident::Admissibility{.chi_square = 12.5,
                                                .equations = 3,
                                                .from_variances = true,
                                                .constraints = {{"K positive semidefinite", 2, 1, 12.5}, {"k2 >= 0", 1, 0, 0.0}}};
  return solution;
}

}  // namespace jointid::report
