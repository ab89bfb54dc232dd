#include "coupling/condition.hpp"

#include <numeric>

namespace jointid::coupling {

Wanted everything(const MatrixRef& h) {
  Wanted all{std::vector<Index>(static_cast<std::size_t>(h.rows())), std::vector<Index>(static_cast<std::size_t>(h.cols()))};
  std::iota(all.rows.begin(), all.rows.end(), Index{0});
  std::iota(all.columns.begin(), all.columns.end(), Index{0});
  return all;
}

}  // namespace jointid::coupling
