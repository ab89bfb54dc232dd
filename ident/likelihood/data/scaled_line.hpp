#pragma once

#include <memory>
#include <vector>

#include "ident/likelihood/data/scaled_part.hpp"
#include "ident/likelihood/data/systematic_plan.hpp"
#include "ident/likelihood/line/scaled_frfs.hpp"

namespace jointid::ident {

/// The parts of a system that are models with an error.
class ScaledParts {
 public:
  /// `coordinates`: those of a LineLayout.
  ScaledParts(const Scene& scene, const SystematicPlan& plan, const frf::FrfSystem& substructures, const Dofs& coordinates);

  bool none() const { return parts_.empty(); }

  /// For lines in this range and all that the errors make of them. Lines are to be asked for afterwards.
  void open(double low_hz, double high_hz);

  /// Of a line; nothing where no error is of its frequency.
  std::shared_ptr<const ScaledFrfs> line(double frequency_hz, const LineLayout& layout, const BothMeasured& measured) const;

 private:
  struct Part {
    DataFile file;
    std::vector<std::size_t> place;  ///< of each coordinate in `coordinates`; npos: it is another part's
    Dofs coordinates;
    std::vector<ScaleUnknown> scales;
    std::shared_ptr<ScaledPart> frfs{};
    double low_hz = 0.0, high_hz = 0.0;  ///< of the lines that it is open for
  };
  std::vector<Part> parts_;
  std::vector<SystematicUnknown> unknowns_;
};

}  // namespace jointid::ident
