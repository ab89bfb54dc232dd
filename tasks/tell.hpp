#pragma once

#include <cstddef>
#include <string>

#include "ident/result/control.hpp"

namespace jointid::tasks {

/// Hands on how far a run is, if anybody wants to know; of a stage without steps the total is 0.
inline void tell(const ident::Control& control, const std::string& stage, std::size_t done = 0, std::size_t total = 0) {
  if (control.progress) control.progress(stage.c_str(), done, total);
}

}  // namespace jointid::tasks
