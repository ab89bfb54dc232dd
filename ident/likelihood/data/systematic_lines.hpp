#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>

#include "ident/likelihood/data/systematic_plan.hpp"

namespace jointid::ident {

/// Which file an FRF between two coordinates comes from, and whether from its transpose (reciprocity).
struct FrfOrigin {
  std::size_t file = frf::npos;
  bool transposed = false;
};

/// What a stretch needs of a measured FRF: −(ω H' + 2 H)/H, NaN where it is not known, and what of it is in proportion to the value of H.
struct StretchFactor {
  Complex all, own;
};

/// At a place of one system.
using SlopeOf = std::function<StretchFactor(bool of_assembly, Element at)>;

/// Brings the systematic errors of sensors to the elements of a line.
class SystematicLines {
 public:
  /// `coordinates`: those of a LineLayout.
  SystematicLines(SystematicPlan plan, frf::FrfSystem& substructures, frf::FrfSystem& assembly, const Dofs& coordinates);

  const SystematicPlan& plan() const { return plan_; }

  /// Reads the driving points of masses, and the FRFs along the axes that angles are towards, on common lines of both systems, which are
  /// added to those read before.
  void read(std::span<const std::size_t> substructure_lines, std::span<const std::size_t> assembly_lines);
  void clear() {
    driving_.clear();
    other_axes_.clear();
  }

  /// Of the i-th line read; `slope` only where stretches are unknown.
  std::shared_ptr<const SystematicFrfs> of(std::size_t i, const LineLayout& layout, const BothMeasured& measured,
                                           const SlopeOf& slope = {}) const;
  /// The same in place of those of another line, whose memory it takes over.
  void write(std::size_t i, const LineLayout& layout, const BothMeasured& measured, const SlopeOf& slope,
             SystematicFrfs& out) const;

 private:
  struct DrivingPoint {
    bool of_assembly;
    std::size_t coordinate;
    std::unique_ptr<frf::BlockReader> reader;
  };

  /// The FRFs along another axis of a sensor: with all coordinates in the other role.
  struct OtherAxis {
    bool of_assembly, is_reference;
    frf::Dof dof;
    std::unique_ptr<frf::BlockReader> reader;
  };

  const FrfOrigin& origin(bool of_assembly, std::size_t row, std::size_t column) const {
    return origins_[of_assembly ? 1 : 0][row * coordinates_.size() + column];
  }
  void write_way(std::size_t i, bool of_assembly, const MeasuredFrfs& measured, Element at, const SlopeOf& slope,
                 SystematicWay& out) const;
  void write_ways(std::size_t i, bool of_assembly, const MeasuredFrfs& measured, Element at, const SlopeOf& slope,
                  std::vector<SystematicWay>& out) const;
  void plan_errors(const frf::FrfSystem& system, bool of_assembly);
  const std::vector<std::size_t>& errors_of(const SensorRole& sensor, std::size_t coordinate) const {
    return errors_[sensor.of_assembly ? 1 : 0][(2 * sensor.file + (sensor.is_reference ? 1 : 0)) * coordinates_.size() + coordinate];
  }
  void plan_driving_points(frf::FrfSystem& system, bool of_assembly);
  void plan_other_axes(frf::FrfSystem& system, bool of_assembly);
  void read_other_axes(std::span<const std::size_t> substructure_lines, std::span<const std::size_t> assembly_lines);
  Complex along_other_axis(std::size_t i, const SensorRole& sensor, std::size_t unknown, std::size_t coordinate) const;
  void add_factors(std::size_t i, const SensorRole& sensor, std::size_t coordinate, std::size_t other,
                   const MeasuredFrfs& measured, Complex value, const SlopeOf& slope, SystematicWay& out) const;
  SystematicFactor mass_factor(std::size_t i, std::size_t unknown, const SensorRole& sensor, const MeasuredFrfs& measured) const;

  SystematicPlan plan_;
  std::vector<SystematicUnknown> unknowns_;
  Dofs coordinates_;
  std::array<std::vector<FrfOrigin>, 2> origins_;
  std::array<std::vector<std::vector<std::size_t>>, 2> errors_;  ///< SystematicPlan::of() by file, role and coordinate
  std::vector<DrivingPoint> driving_points_;
  std::vector<std::vector<Complex>> driving_;  ///< [line][driving point]
  std::vector<OtherAxis> axes_;
  std::vector<std::vector<Complex>> other_axes_;  ///< [line][axis, coordinate]
};

}  // namespace jointid::ident
