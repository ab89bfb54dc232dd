#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "laws/data/phasor_file.hpp"
#include "laws/scene/law_scene.hpp"
#include "records/file/record.hpp"
#include "records/order/order_phasors.hpp"

namespace jointid::laws {

/// The time records of one level, read once.
class LevelRecordings {
 public:
  /// Throws InputError (data) where a record cannot be read, has no force at one of the level's force DOFs, or no motion.
  explicit LevelRecordings(const ForceLevel& level);

  /// Where motions were measured, in every record.
  const std::vector<frf::Dof>& dofs() const { return dofs_; }

  /// Phasors of one harmonic.
  struct Harmonic {
    std::shared_ptr<const Phasors> responses, forces;  ///< m and N, lines at n times those of the force
  };
  /// Of each harmonic of the level, by records::steady_phasors or sweep_phasors, at lines of the parts: a steady record whose
  /// frequency is 2e-4 or more from the nearest line is left out, and told. Channels that begin later than the force have the
  /// phases of their own times. Throws InputError (data) as they do.
  std::vector<Harmonic> phasors(const std::vector<frf::Dof>& responses, const std::vector<double>& parts_hz);

  /// What was done and left out, one phrase each.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct Source {
    records::OrderPhasors phasors;
    std::size_t record = 0;
  };
  using Lines = std::map<double, Source>;  ///< of the parts, Hz

  Lines lines_of(const std::vector<double>& parts_hz);
  void judge_sweep(const Lines& lines);
  Harmonic harmonic(std::size_t n, const Lines& lines, const std::vector<frf::Dof>& responses) const;

  const ForceLevel& level_;
  std::vector<records::Record> records_;
  std::vector<frf::Dof> dofs_;
  std::vector<std::string> notes_;
};

}  // namespace jointid::laws
