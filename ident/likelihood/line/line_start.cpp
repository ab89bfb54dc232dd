#include "ident/likelihood/line/line_start.hpp"

#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>

#include "ident/likelihood/line/lifted_line.hpp"

namespace jointid::ident {

LineState lifted_start(const LineLayout& layout, const LineData& data, const ComplexMatrix& z) {
  LiftedLine line(layout, data, z);
  std::vector<double> u(line.parameters(), 0.0);
  ceres::Problem::Options borrowing;
  borrowing.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(borrowing);
  problem.AddResidualBlock(&line, nullptr, u.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  for (const double penalty : {1.0, 10.0, 1e2, 1e3, 1e4}) {
    line.set_penalty(penalty);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
  }
  return line.state(u.data());
}

}  // namespace jointid::ident
