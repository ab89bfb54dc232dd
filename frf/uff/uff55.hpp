#pragma once

#include <array>
#include <complex>
#include <filesystem>
#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// A mode as dataset 55 ("data at nodes") holds it, in SI units.
struct Uff55Mode {
  std::array<std::string, 5> id;  ///< ID lines, UTF-8
  int number = 0;                 ///< mode number
  bool is_complex = false;        ///< analysis type 3 or 7 (complex eigenvalue); else 2 (normal mode)
  Quantity quantity = Quantity::receptance;  ///< of a displacement, as the shape is; mobility: velocity, accelerance: acceleration

  double frequency_hz = 0.0;        ///< normal: as stated; complex: |λ|/2π
  double modal_mass = 1.0;          ///< normal modes
  double viscous_damping = 0.0;     ///< ζ; complex: −Re λ/|λ|
  double hysteretic_damping = 0.0;  ///< η of normal modes

  /// Complex modes: λ in rad/s, residue ψψᵀ/(modal A), modal B = −λ·(modal A).
  std::complex<double> eigenvalue, modal_a{1.0}, modal_b;

  std::vector<Dof> dofs;                     ///< every direction the dataset has, node by node
  std::vector<std::complex<double>> shape;   ///< as long as dofs
};

/// The mode shapes of a universal file, in its order. It skips datasets 55 of other analyses (static, transient, …), of
/// strains, stresses and reactions, and without three or six components per node. Dataset 164 applies to lengths, to modal
/// masses, modal A and B (mass, force·s/length and force/length of the file's units: tonnes for mm and N) and to rotations
/// of shapes. Without it values are taken as SI. Throws InputError if there is no shape, or if a dataset breaks the
/// format. `not_read`: gets a phrase for each mode shape without three or six components per node.
std::vector<Uff55Mode> read_uff55(const std::filesystem::path& path, std::vector<std::string>* not_read = nullptr);

/// Writes dataset 151, 164 (SI), 2411 if nodes are known, and a dataset 55 for each mode, by a temporary name. Data are real for
/// normal modes, complex for complex ones; three components per node, six if a DOF is a rotation, 0 where the mode has none. The
/// format has six significant digits.
void write_uff55(const std::vector<Uff55Mode>& modes, const std::vector<Node>& nodes, const std::filesystem::path& path);

}  // namespace jointid::frf
