#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "frf/uff/uff_scan.hpp"
#include "frf/uff/uff_unit_table.hpp"

namespace jointid::frf::uff {

/// The coordinate systems of the datasets 2420 and 18 of a file, by their labels; 2420 comes first where both have one. In 2420 a
/// matrix of four rows is the axes of the system and its origin in global axes: global = Σ local_i · row_i + row_4. In 18 three
/// points of a reference system are the origin, one on +X and one in the half plane of +X and +Z. Systems whose reference is not
/// there, or curved, and those that are defined otherwise (method above 1) are known to be there, and not described. Of
/// cylindrical ones (r, θ, z) and spherical ones (r, θ from Z, φ round Z) angles are in degrees, and the axes of a node are along
/// its r, θ and z or φ. Labels 0 and, where no dataset defines it, 1 are the global Cartesian system.
class CoordinateSystems {
 public:
  using Vector = std::array<double, 3>;

  /// Throws InputError where a dataset does not hold what it should, or axes are not orthonormal to 1e-3.
  CoordinateSystems(ByteFile& file, const std::vector<Dataset>& datasets, const UnitTable& units);

  /// Position in m of a point given in the system, with `length` of its units to the metre; empty where the file does not define
  /// the system.
  std::optional<Vector> global(std::int64_t label, const Vector& local, double length) const;

  /// Of a node at a global position; empty: the global ones. NaN where the file does not define the system.
  std::optional<Axes> axes(std::int64_t label, const Vector& position) const;

 private:
  enum class Kind : std::uint8_t { cartesian, cylindrical, spherical };

  struct System {
    Kind kind = Kind::cartesian;
    Axes axes{};
    Vector origin{};  ///< m
  };

  /// Null for the global system and for those that the file does not define.
  const System* find(std::int64_t label) const;
  bool is_global(std::int64_t label) const {
    return label == 0 || (label == 1 && find(label) == nullptr && !not_described_.contains(1));
  }
  static Axes local_axes(Kind kind, const Vector& local);
  void read(ByteFile& file, const Dataset& dataset, double length);

  /// A system of dataset 18 before its reference is known.
  struct Points {
    const Dataset* dataset = nullptr;
    std::int64_t label = 0, reference = 0;
    Kind kind = Kind::cartesian;
    std::array<Vector, 3> points{};  ///< m, in the reference system
  };
  void read_points(ByteFile& file, const Dataset& dataset, double length, std::vector<Points>& waiting);
  void place_all(std::vector<Points> waiting);
  bool place(const Points& points);

  std::map<std::int64_t, System> systems_;
  std::set<std::int64_t> not_described_;
};

}  // namespace jointid::frf::uff
