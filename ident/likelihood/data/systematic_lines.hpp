#pragma once

#include <array>
#include <memory>
#include <span>

#include "ident/likelihood/data/systematic_plan.hpp"

namespace jointid::ident {

/// Which file an FRF between two coordinates comes from, and whether from its transpose (reciprocity).
struct FrfOrigin {
  std::size_t file = frf::npos;
  bool transposed = false;
};

/// Brings the systematic errors of sensors to the elements of a line.
class SystematicLines {
 public:
  /// `coordinates`: those of a LineLayout.
  SystematicLines(SystematicPlan plan, frf::FrfSystem& substructures, frf::FrfSystem& assembly, const Dofs& coordinates);

  const SystematicPlan& plan() const { return plan_; }

  /// Reads the driving points of masses on common lines of both systems, which are added to those read before.
  void read(std::span<const std::size_t> substructure_lines, std::span<const std::size_t> assembly_lines);
  void clear() { driving_.clear(); }

  /// Of the i-th line read.
  std::shared_ptr<const SystematicFrfs> of(std::size_t i, const LineLayout& layout, const BothSystems<Measured>& measured) const;

 private:
  struct DrivingPoint {
    bool of_assembly;
    std::size_t coordinate;
    std::unique_ptr<frf::BlockReader> reader;
  };

  const FrfOrigin& origin(bool of_assembly, std::size_t row, std::size_t column) const {
    return origins_[of_assembly ? 1 : 0][row * coordinates_.size() + column];
  }
  SystematicWay way(std::size_t i, bool of_assembly, std::size_t row, std::size_t column) const;
  std::vector<SystematicWay> ways(std::size_t i, bool of_assembly, const Measured& measured, Element at) const;
  void plan_driving_points(frf::FrfSystem& system, bool of_assembly);

  SystematicPlan plan_;
  std::vector<SystematicUnknown> unknowns_;
  Dofs coordinates_;
  std::array<std::vector<FrfOrigin>, 2> origins_;
  std::vector<DrivingPoint> driving_points_;
  std::vector<std::vector<Complex>> driving_;  ///< [line][driving point]
};

}  // namespace jointid::ident
