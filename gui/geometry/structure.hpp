#pragma once

#include <complex>
#include <functional>
#include <map>

#include "frf/uff/uff_lines.hpp"
#include "gui/data/loaded_file.hpp"

namespace jointid::gui {

/// The nodes of all files of a scene, the lines between them, and the DOFs that were measured there.
struct Structure {
  std::vector<frf::Node> nodes;      ///< those with a position, each once, ascending
  std::vector<frf::NodeLine> lines;  ///< between nodes that are there
  std::vector<frf::Dof> dofs;        ///< of nodes that are there, each coordinate once, ascending
  std::vector<frf::Dof> unplaced;    ///< of nodes without a position, or whose directions the files do not tell
  std::map<std::int64_t, int> part{};  ///< of a node with DOFs, from 0 in the order of the substructures
};

/// Files without positions add their DOFs only, those without FRFs their nodes. `lines`: as the files draw them; where none does, the
/// nodes of each file are
/// joined in the order of their numbers, when they are on one straight line.
Structure structure_of(const std::vector<LoadedFile>& files, const std::vector<frf::NodeLine>& lines);

/// Lines of the universal files among the scene's, of those below 256 MB. Throws Interrupted.
std::vector<frf::NodeLine> drawn_lines(const ident::DataSection& data, const std::function<bool()>& interrupted);

using Vector = std::array<double, 3>;

/// Half the diagonal of the box round all nodes, and its middle; 1 and 0 without nodes.
struct Extent {
  Vector middle{};
  double radius = 1.0;
};
Extent extent_of(const Structure& structure);

/// One step along a DOF of the node, in global axes; against its axis for a negative sign.
Vector direction_of(const frf::Node& node, const frf::Dof& dof);

/// Complex displacement of nodes along X, Y and Z of their DOFs (frf::Node::axes), as large as it comes.
using Shape = std::map<std::int64_t, std::array<std::complex<double>, 3>>;

/// The same along the global axes. Nodes that are not there, or whose directions are not known, are left out.
Shape in_global_axes(const Shape& shape, const std::vector<frf::Node>& nodes);

/// How an assembly moves under a harmonic force: translations of all responses to a reference at the line nearest to a frequency,
/// and that frequency. Empty where no file of the assembly has the reference; any file counts where the scene names no assembly.
struct Deflection {
  Shape shape;
  double frequency_hz = 0.0;
};
Deflection deflection_at(const std::vector<LoadedFile>& files, const frf::Dof& reference, double frequency_hz);

/// Whether a file shows how the whole moves: one that could be read, of an assembly, or any where the scene names none.
bool shows_motion(const LoadedFile& file, const std::vector<LoadedFile>& files);

}  // namespace jointid::gui
