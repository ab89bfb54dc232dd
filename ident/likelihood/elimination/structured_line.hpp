#pragma once

#include <optional>

#include "ident/likelihood/line/reduced_line.hpp"

namespace jointid::ident {

/// Normal equations of a linearised line, solved by a way of its own (see LineModel).
class StructuredLine {
 public:
  virtual ~StructuredLine() = default;
  virtual std::optional<ReducedLine> reduce(double damping, bool answer) = 0;
  virtual LineStep own_step(const LineStep& gradient) const = 0;
};

}  // namespace jointid::ident
