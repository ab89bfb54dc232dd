#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"
#include "virtualpoint/consistency.hpp"

namespace jointid::ident {

/// What may be wrong with measured FRFs; docs/checking-data.md tells what each looks like.
enum class SuspectKind : std::uint8_t {
  sign,            ///< a transducer, or the hammer, pointed the other way
  swap,            ///< the labels of two channels are exchanged
  label,           ///< a DOF that no counterpart has, next to one that lacks its own
  gain,            ///< a channel, or a file, is off by a factor
  unit,            ///< a file is off by a factor between units
  quantity,        ///< receptance, mobility and accelerance mixed up
  conjugate,       ///< the imaginary part has the other sign
  delay,           ///< a phase proportional to frequency, common to a file
  axis,            ///< the frequency axis of a file is stretched
  mass,            ///< the mass of accelerometers is in the FRFs
  dead,            ///< a channel without signal, or not finite
  copy,            ///< a channel that repeats another
  loose,           ///< the assembly moves as its parts alone do
  exchange,        ///< a file holds the FRFs of another
  not_passive,     ///< a driving point gives energy away
  not_reciprocal,  ///< H_ij and H_ji differ for no reason above
  nonlinear,       ///< the assembly does not follow from its parts by forces at the joint, for no reason above
  direction,       ///< a sensor or impact of a virtual point points another way than stated
  outlier,         ///< one number, or a few lines, far from what the neighbours and the other FRFs make of them
  force_noise      ///< noise of the force's signal makes H1 too low, as far as the coherences allow
};

/// "sign", "swap", …, as in JSON.
std::string name(SuspectKind kind);

/// Something that may be wrong, and what would mend it.
struct Suspect {
  SuspectKind kind = SuspectKind::sign;
  std::string file;            ///< as the scene names it
  std::vector<frf::Dof> dofs;  ///< the channels; empty where it is the whole file
  std::string evidence;        ///< numbers in a sentence
  double confidence = 0.0;     ///< 0…1
  std::string remedy;          ///< lines for the scene that would mend it; empty where only measuring again would
};

/// "sign 125:+Y, 126:+Y in rig.uff".
std::string title(const Suspect& suspect);

enum class Verdict : std::uint8_t {
  clean,       ///< nothing stands out
  suspicious,  ///< something may be wrong
  wrong        ///< something is wrong
};

/// "clean", "suspicious", "wrong".
std::string name(Verdict verdict);

/// How reciprocal the FRFs of a file are.
struct ReciprocityMap {
  std::string file;
  std::vector<frf::Dof> dofs;  ///< that it has as responses and references, at least two
  double overall = 0.0;        ///< √(Σ|H_ij − H_ji|² / Σ½(|H_ij|² + |H_ji|²)) over pairs and lines, of accelerances
  std::vector<std::vector<double>> rms{};  ///< the same of each pair over the lines, 0 on the diagonal; empty for more than 100 DOFs
};

/// What a check found, most likely first.
struct CheckResult {
  Verdict verdict = Verdict::clean;
  std::vector<Suspect> suspects;
  std::vector<std::string> notes{};           ///< what is no mistake but should be known, one sentence each
  std::vector<ReciprocityMap> reciprocity{};  ///< of each file that can tell
  std::vector<virtualpoint::Consistency> virtual_points{};  ///< of every file and virtual point that it has channels of
};

}  // namespace jointid::ident
