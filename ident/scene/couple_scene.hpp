#pragma once

#include "coupling/assembly.hpp"
#include "coupling/options.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// A joint that another scene identifies.
struct IdentifiedJoint {
  Path scene;
  std::vector<coupling::PlacedDof> dofs;  ///< in the order of that scene's joint; empty: by the same names
};

/// A scene of `jointid couple`, checked for everything that can be checked without opening the data.
struct CoupleScene {
  Path file;
  std::string title;
  std::vector<DataFile> parts;
  std::vector<std::string> names;  ///< of the parts, as written
  bool reciprocity = false;
  FrequencySection frequency;      ///< without exclude_resonances
  coupling::Assembly assembly;               ///< but for the joints of `identified`
  std::vector<IdentifiedJoint> identified;
  coupling::Options options;
  bool find_dependent = false;     ///< threshold "auto": find conditions that others nearly imply, and leave them out
};

/// Reads a scene. Throws InputError (usage) as read_scene().
CoupleScene read_couple_scene(const Path& file);

/// The same from text; `file` is used in messages and to resolve the paths of the data.
CoupleScene parse_couple_scene(const std::string& text, const Path& file);

}  // namespace jointid::ident
