#pragma once

#include <map>
#include <string>
#include <tuple>

#include "frf/set/frf_system.hpp"
#include "ident/likelihood/data/estimated_frfs.hpp"
#include "ident/scene/scene.hpp"
#include "models/model_error.hpp"

namespace jointid::ident {

/// What a sensor, hammer or shaker is, in a file.
struct SensorRole {
  bool of_assembly = false;
  std::size_t file = 0;  ///< in its system
  bool is_reference = false;
  frf::Dof dof{};
};

/// A systematic error as the user knows it: its unknown and what it is called, "gain of 125:+Y".
struct NamedSystematic {
  SystematicUnknown unknown;
  std::string name, unit;
  double known = 0.0;  ///< what is removed already (mass)
  frf::Direction towards{};  ///< of an angle: at the sensor's node
};

/// A scale of a part that is a model, on the lines of a band.
struct ScaleUnknown {
  std::size_t unknown;
  bool is_mass;  ///< else stiffness
  models::ModelError::Band band;
};

/// Whether [[data.gains]] and [[data.masses]] leave anything open (gain = 0 says that calibration is exact), or a model states an
/// error.
bool are_errors_unknown(const DataSection& data);

/// Which FRFs have which systematic errors.
class SystematicPlan {
 public:
  /// Those of [[data.gains]] and [[data.masses]], and of parts that are models with an error. Throws InputError for DOFs that no
  /// file has in that role, for a sensor that two tables name, for masses whose driving point is not in their file, and for a
  /// model with an error in the assembly.
  static SystematicPlan of(const Scene& scene, const frf::FrfSystem& substructures, const frf::FrfSystem& assembly);

  /// An unknown of some roles; its number.
  std::size_t add(NamedSystematic systematic, const std::vector<SensorRole>& roles);

  const std::vector<NamedSystematic>& all() const { return all_; }
  std::vector<SystematicUnknown> unknowns() const;

  /// The numbers of those that a sensor has; empty for most.
  const std::vector<std::size_t>& of(const SensorRole& role) const;

  /// Those of a part that is a model; empty for most.
  const std::vector<ScaleUnknown>& scales(std::size_t part) const;

 private:
  using Key = std::tuple<bool, std::size_t, bool, std::int64_t>;
  static Key key(const SensorRole& role) { return {role.of_assembly, role.file, role.is_reference, coordinate_key(role.dof)}; }
  void add_gains(const Scene& scene, const GainPrior& prior, const frf::FrfSystem& substructures, const frf::FrfSystem& assembly);
  void add_angles(const Scene& scene, const GainPrior& prior, const frf::FrfSystem& substructures, const frf::FrfSystem& assembly,
                  const std::vector<SensorRole>& roles);
  void add_masses(const Scene& scene, const MassPrior& prior, const frf::FrfSystem& substructures,
                  const frf::FrfSystem& assembly);
  void add_scales(const DataFile& model, std::size_t part);
  void add_shared(const Scene& scene, Sharing shared, const NamedSystematic& systematic, const std::vector<SensorRole>& roles);

  std::vector<NamedSystematic> all_;
  std::map<Key, std::vector<std::size_t>> of_;
  std::map<std::size_t, std::vector<ScaleUnknown>> scales_;
};

}  // namespace jointid::ident
