#pragma once

#include <cstddef>
#include <functional>

namespace jointid::response {

/// How a fit is worked out.
struct FitWork {
  std::size_t threads = 1;
  std::function<bool()> interrupted{};  ///< asked before the responses of some parameters are predicted: Interrupted is thrown
};

}  // namespace jointid::response
