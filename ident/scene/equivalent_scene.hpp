#pragma once

#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// FRFs of the assembly while the relative displacement at the joint was held at one amplitude.
struct DisplacementLevel {
  DataFile assembly;
  double displacement = 0.0;  ///< m
};

/// A scene of `jointid equivalent`, checked for everything that can be checked without opening the data.
struct EquivalentScene {
  Path file;
  std::string title;
  std::vector<DataFile> parts;
  bool reciprocity = false;
  FrequencySection frequency;  ///< without exclude_resonances
  std::array<frf::Dof, 2> dofs;  ///< ends of the joint; the assembly is excited at the first
  std::vector<DisplacementLevel> levels;
  std::optional<DataFile> rigid;  ///< the assembly with the joint clamped: then (7.18), else (7.11), docs/formulas.md §12
  bool real = false;              ///< (7.19) for the parts
  bool relative = false;          ///< residuals over the FRFs, see JointLines
};

/// Reads a scene. Throws InputError (usage) as read_scene().
EquivalentScene read_equivalent_scene(const Path& file);

/// The same from text; `file` is used in messages and to resolve the paths of the data.
EquivalentScene parse_equivalent_scene(const std::string& text, const Path& file);

}  // namespace jointid::ident
