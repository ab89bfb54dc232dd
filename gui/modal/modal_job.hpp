#pragma once

#include <QString>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "gui/work/worker.hpp"
#include "ident/scene/scene.hpp"
#include "tasks/modalfit/modal_run.hpp"

namespace jointid::gui {

/// Files that are one structure: a part, or the assembly.
struct ModalStructure {
  std::string name;
  std::vector<ident::DataFile> files;
};

/// The parts of a scene, each by itself, and its assembly.
std::vector<ModalStructure> structures_of(const ident::DataSection& data);

struct ModalWish {
  ModalStructure structure;
  modalfit::FitOptions options{};               ///< poles: what is picked, or nothing for all modes to be sought
  std::shared_ptr<const frf::FrfSet> loaded{};  ///< of the same structure, where it was read before
};

struct ModalFound {
  std::shared_ptr<const frf::FrfSet> loaded;
  std::shared_ptr<const tasks::ModalRun> run;
};

/// As `jointid modalfit` does. Interrupted, it gives the modes found so far, marked so; throws Interrupted where there are none,
/// and InputError.
ModalFound run_modal_job(const ModalWish& wish, const Worker::Watch& watch);

/// "jointid modalfit 'part.uff' --range 10:2000 --real --poles 51.5:0.001".
QString modal_command(const ModalStructure& structure, const modalfit::FitOptions& options);

/// What no output may replace.
std::vector<std::filesystem::path> inputs_of(const std::vector<ModalStructure>& structures);

}  // namespace jointid::gui
