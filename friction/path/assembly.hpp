#pragma once

#include <memory>
#include <span>
#include <vector>

#include "friction/path/element.hpp"

namespace jointid::friction {

using Parts = std::vector<std::shared_ptr<const Element>>;

/// Parameters of several elements one after the other, named "1.a", "1.b", "2.k", …
class Assembly : public Element {
 public:
  /// Throws InputError when there is no part.
  explicit Assembly(Parts parts);

  std::vector<Parameter> parameters() const override;
  bool admits(std::span<const double> values) const override;

 protected:
  const Parts& parts() const { return parts_; }

  /// The parts with other values.
  Parts parts_with(std::span<const double> values) const;

  /// The stretch of `out` that belongs to each part, in turn.
  std::vector<std::span<double>> split(std::span<double> out) const;

 private:
  bool sizes_agree(std::span<const double> values) const;

  Parts parts_;
  std::vector<std::size_t> sizes_;
};

}  // namespace jointid::friction
