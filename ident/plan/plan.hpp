#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "ident/plan/coordinates.hpp"
#include "ident/plan/line.hpp"
#include "ident/plan/method.hpp"
#include "ident/plan/model_in_use.hpp"
#include "ident/plan/planned_method.hpp"
#include "ident/plan/regeneration_note.hpp"
#include "ident/plan/unknown_columns.hpp"
#include "ident/scene/scene.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {

struct AdmissibleSet;

/// From so many unknowns on, rows by parts are chosen where the scene does not name Method One.
inline constexpr std::size_t least_unknowns_by_parts = 150;

/// The hinge: everything that is decided before FRFs are read, from the scene and the headers of its files.
/// What it does not name is not read, allocated or computed. make_plan() and, where it leaves lines out or tries weightings, solve()
/// are all that change one.
struct Plan : PlannedMethod {
  Scene scene;
  restrictions::Restriction restriction;
  std::shared_ptr<frf::FrfSystem> substructures, assembly;
  std::vector<Line> lines;
  std::unique_ptr<UnknownColumns> columns;
  std::string chosen;  ///< "method …: why", where the scene left it open; else empty
  std::shared_ptr<const AdmissibleSet> admissible;  ///< empty where the scene has no constraints
  bool keeps_frfs = false;                     ///< what was read once is not read again
  /// Where Method One takes the rows of each substructure alone (PartOfRows): what its usual rows lack.
  std::optional<InputError::Parts> why_by_parts{};
  double omega0 = 0.0;                ///< rad/s, of the scaled unknowns x = {k, ω₀²m, ω₀c, d}: the highest used frequency
  /// Unknown of a column in SI units = scaled unknown · this.
  double unscale(std::size_t column) const;
  ModelsInUse models{};  ///< of its files
  std::vector<ModalRegeneration> regenerated;  ///< structures whose FRFs are those of modal models
  std::vector<std::string> warnings;  ///< what may be wrong with the data or the scene, one sentence each
};

}  // namespace jointid::ident
