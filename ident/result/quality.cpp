#include "ident/result/quality.hpp"

#include <cmath>

namespace jointid::ident {

std::optional<Quality> judge(const Matrix& identified, const Matrix& exact) {
  double sum = 0.0, squares = 0.0, errors = 0.0, count = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t j = i % exact[i].size(); j < exact[i].size(); ++j) {
      if (exact[i][j] == 0.0) continue;
      const double u = identified[i][j] / exact[i][j];
      sum += u;
      squares += u * u;
      errors += (u - 1.0) * (u - 1.0);
      count += 1.0;
    }
  }
  if (count == 0.0) return std::nullopt;
  return Quality{.rjcf = squares > 0.0 ? sum * sum / (count * squares) : 0.0,
                 .arvf = sum / count,
                 .rms_relative_error = std::sqrt(errors / count)};
}

}  // namespace jointid::ident
