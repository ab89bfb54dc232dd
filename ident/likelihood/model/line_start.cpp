#include "ident/likelihood/model/line_start.hpp"

#include "ident/likelihood/model/lifted_line.hpp"

namespace jointid::ident {

LineState lifted_start(const LineLayout& layout, const LineData& data, const ComplexMatrix& z) {
  LiftedLine line(layout, data, z);
  std::vector<double> u(line.sizes().front(), 0.0);
  for (const double penalty : {1.0, 10.0, 1e2, 1e3, 1e4}) {
    line.set_penalty(penalty);
    minimise::ceres_blocks({{.block = &line, .parameters = {u.data()}}}, {});
  }
  return line.state(u.data());
}

}  // namespace jointid::ident
