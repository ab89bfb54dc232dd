#pragma once

#include "impedance/scene/line_scene.hpp"

namespace jointid::impedance {

/// How B is found from AB and A; (n) are the equations of docs/joint-line-by-line.md.
enum class DecoupleWay {
  likelihood,  ///< Z of B at the interface, line by line, with all FRFs that A and AB have in common
  standard,    ///< (23): compatibility and equilibrium at the interface
  extended,    ///< compatibility at the internal DOFs of A, too
  both         ///< equilibrium there, too: as many singular values are kept as the interface has DOFs
};

std::string name(DecoupleWay way);

/// A scene of `jointid decouple`: [data] assembly is AB, substructures is A.
struct DecoupleScene {
  LineScene lines;  ///< the interface as its joint
  std::vector<frf::Dof> interface;
  std::vector<DecoupleWay> ways = {DecoupleWay::likelihood};  ///< the FRFs of the first are written
};

/// Throws InputError (usage) with file, place, value and remedy.
DecoupleScene parse_decouple_scene(const std::string& text, const std::filesystem::path& file);
DecoupleScene read_decouple_scene(const std::filesystem::path& file);

}  // namespace jointid::impedance
