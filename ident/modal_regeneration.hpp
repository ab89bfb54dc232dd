#pragma once

#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "ident/plan/regeneration_note.hpp"
#include "ident/scene/scene.hpp"
#include "modalfit/model/fit.hpp"

namespace jointid::ident {

/// Sources with the FRFs of modal models in place of those of `sources`: real modes with hysteretic damping
/// (docs/formulas.md §9, 5.65), fitted to the lines
/// of the scene's range and a tenth of its width on either side. The files of an assembly are one structure and become one source, each
/// substructure stays its own. Everything is read and fitted here. `told` gets one entry per structure.
std::vector<std::unique_ptr<frf::FrfSource>> regenerate_sources(std::vector<std::unique_ptr<frf::FrfSource>> sources, bool one_structure,
                                                                const Scene& scene, std::vector<ModalRegeneration>& told);

/// How the modal models of a scene are fitted.
modalfit::FitOptions regeneration_options(const Scene& scene);

}  // namespace jointid::ident
