#pragma once

#include <string>

#include "report/modalfit/modal_run.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

Table modes_table(const ModalRun& run);
/// MAC of each pair of modes whose shapes are more alike than 0.3.
Table mac_table(const ModalRun& run);
/// Synthesis errors, worst first, at most `most` FRFs.
Table synthesis_table(const ModalRun& run, std::size_t most);

/// "viscous damping, complex modes".
std::string model_text(const modalfit::ModelKind& kind);
/// "0.9 dB rms, 0.4 dB away from antiresonances".
std::string synthesis_text(const std::vector<modalfit::SynthesisError>& errors);
/// What the user should know, one sentence each.
std::vector<std::string> notes(const ModalRun& run);

std::string modal_text(const ModalRun& run);

}  // namespace jointid::report
