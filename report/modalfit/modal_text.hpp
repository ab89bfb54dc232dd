#pragma once

#include <string>

#include "report/text/table.hpp"
#include "tasks/modalfit/modal_run.hpp"

namespace jointid::report {

Table modes_table(const tasks::ModalRun& run);
/// MAC of each pair of modes whose shapes are more alike than 0.3.
Table mac_table(const tasks::ModalRun& run);
/// Synthesis errors, worst first, at most `most` FRFs.
Table synthesis_table(const tasks::ModalRun& run, std::size_t most);

/// "viscous damping, complex modes".
std::string model_text(const modalfit::ModelKind& kind);
/// "0.9 dB rms, 0.4 dB away from antiresonances".
std::string synthesis_text(const std::vector<modalfit::SynthesisError>& errors);
/// What the user should know, one sentence each.
std::vector<std::string> notes(const tasks::ModalRun& run);

std::string modal_text(const tasks::ModalRun& run);

/// The fit as JSON; the keys stay. Numbers that are not there are null.
std::string modal_json(const tasks::ModalRun& run);

/// One line for each mode.
std::string modes_csv(const tasks::ModalRun& run);

}  // namespace jointid::report
