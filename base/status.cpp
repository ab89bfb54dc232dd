#include "base/status.hpp"

#include <array>
#include <cstddef>

namespace jointid {
namespace {

struct Row {
  Status status;
  const char* word;
  bool is_usable;
};

constexpr std::array rows = {
    Row{Status::ok, "ok", true},
    Row{Status::rank_deficient, "rank_deficient", false},
    Row{Status::no_equations, "no_equations", false},
    Row{Status::not_converged, "not_converged", false},
    Row{Status::imprecise, "imprecise", false},
    Row{Status::doubtful, "doubtful", true},
    Row{Status::poor_fit, "poor_fit", false},
    Row{Status::no_modes, "no_modes", false},
    Row{Status::no_response, "no_response", false},
    Row{Status::too_few_data, "too_few_data", false},
    Row{Status::too_few_points, "too_few_points", false},
};

consteval bool is_in_order() {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (static_cast<std::size_t>(rows[i].status) != i) return false;
  }
  return true;
}
static_assert(is_in_order(), "rows are in the order of the enumerators");

/// Nothing where a file has a number that is none.
const Row* row_of(Status status) {
  const auto place = static_cast<std::size_t>(status);
  return place < rows.size() ? &rows[place] : nullptr;
}

}  // namespace

std::string name(Status status) {
  const Row* const row = row_of(status);
  return row != nullptr ? row->word : "unknown";
}

bool is_usable(Status status) {
  const Row* const row = row_of(status);
  return row != nullptr && row->is_usable;
}

}  // namespace jointid
