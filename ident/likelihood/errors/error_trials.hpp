#pragma once

#include <string>
#include <vector>

#include "ident/likelihood/data/systematic_plan.hpp"
#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// f(of the assembly, number of the file, its header), the assembly's first
template <class Function>
void for_each_file(const Plan& plan, const Function& f) {
  for (const bool of_assembly : {true, false}) {
    const frf::FrfSystem& system = of_assembly ? *plan.assembly : *plan.substructures;
    for (std::size_t s = 0; s < system.source_count(); ++s) f(of_assembly, s, system.source(s).header());
  }
}

/// A gain of one sensor.
struct SensorTrial {
  frf::Dof dof;
  std::string file;
  bool of_assembly;
};

/// A gain that all FRFs of the assembly share, or all of a part.
struct FileTrial {
  bool of_assembly;
  std::size_t number = 0;  ///< of the part
  std::string name;        ///< of the file, of the assembly's first
  double averages = 0.0;  ///< behind its variances; 0: these come from elsewhere
};

/// An error on one line that all responses to a reference share: its real part (a gain), or its imaginary one (a delay of 1 s, which
/// turns by ω).
struct ReferenceTrial {
  std::size_t file;  ///< in ErrorTrials::files
  bool is_phase;
};

/// Systematic errors that are tried at an estimate, in this order after the unknowns of the fit.
struct ErrorTrials {
  static constexpr std::size_t most = 256;  ///< sensors; references and phases: more would take most of a run

  std::vector<SensorTrial> sensors;
  std::vector<FileTrial> files;
  std::size_t stretches = 0;  ///< of the frequencies of `files`, see Systematic::stretch
  std::vector<std::vector<SensorRole>> roles;  ///< of the files' FRFs
  std::vector<ReferenceTrial> references;
  SystematicPlan plan;

  /// Gains of all sensors that no table of the scene names.
  void add_sensors(const Plan& of);
  /// First the assembly, then the parts.
  void add_files(const Plan& of);
  /// Of all files; after add_files().
  void add_stretches();
  /// Of all files whose variances come from averages without what FRFs have in common; after add_files().
  void add_references(const Plan& of);

  std::size_t first_stretch() const { return sensors.size() + files.size(); }
  /// Those that all lines share: of sensors and files, and the stretches.
  std::size_t shared_by_lines() const { return first_stretch() + stretches; }
  std::size_t size() const { return shared_by_lines() + references.size(); }
};

}  // namespace jointid::ident
