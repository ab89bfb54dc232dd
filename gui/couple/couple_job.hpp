#pragma once

#include <memory>
#include <vector>

#include "gui/table/cell_table.hpp"
#include "gui/work/worker.hpp"
#include "ident/scene/couple_scene.hpp"
#include "tasks/couple/couple_frfs.hpp"
#include "tasks/couple.hpp"

namespace jointid::gui {

struct CoupleWish {
  ident::CoupleScene scene;
  std::filesystem::path out;
  bool bounds = false;
  std::vector<std::filesystem::path> measured{};  ///< FRFs of the real assembly, to compare with
};

/// What was predicted, and the FRFs that are shown of it.
struct Coupled {
  ident::CoupleScene scene;
  tasks::CoupleResult result;
  std::vector<tasks::PredictedFrf> frfs;
};

/// As `jointid couple --out` does; reads back what it wrote, and what was measured beside it. Throws InputError and Interrupted,
/// the latter with no file.
std::shared_ptr<const Coupled> run_coupling(const CoupleWish& wish, const Worker::Watch& watch);

/// Errors of the predicted FRFs in dB, those shown, coloured to 3 dB; empty without anything measured.
CellRows coupling_errors(const Coupled& coupled);

/// Resonances of the prediction, and with all conditions where bounds were asked for.
CellRows resonance_rows(const tasks::CoupleResult& result);

}  // namespace jointid::gui
