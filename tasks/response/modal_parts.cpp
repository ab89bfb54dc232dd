#include "tasks/response/modal_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "modalfit/model/symmetric_model.hpp"
#include "modalfit/model/synthesis.hpp"

namespace jointid::tasks {
namespace {

[[noreturn]] void fail(std::string file, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = std::move(file),
                    .place = "[frequency] modal_model",
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

/// The model of one file at lines inside its range.
frf::FrfSet on_lines(const frf::FrfSet& measured, const std::vector<double>& lines_hz, const ident::Control& control,
                     std::vector<std::string>& doubts) {
  modalfit::FitOptions options;
  options.interrupted = control.interrupted;
  modalfit::Band band = modalfit::make_band(measured, std::nullopt);
  const modalfit::ModalFit found = modalfit::fit(band, measured.header, options);
  stop_if(control.interrupted);
  const std::array range = {band.frequency_hz.front(), band.frequency_hz.back()};
  const bool symmetric = modalfit::obstacle(found).empty();
  const modalfit::SymmetricModel model = symmetric ? modalfit::make_symmetric(found, band) : modalfit::SymmetricModel{};
  const auto on = [&](const std::vector<double>& lines) {
    frf::FrfHeader header = measured.header;
    header.frequency_hz = lines;
    return symmetric ? modalfit::regenerate(model, header) : modalfit::regenerate(found, header, range);
  };
  if (found.status == Status::no_modes) {
    fail(measured.header.file, "the part has no modal model: " + found.message,
         "leave modal_model out: the lines of the files count");
  }
  const modalfit::SynthesisError error = modalfit::overall(modalfit::synthesis_errors(found, band, on(band.frequency_hz)));
  if (!(error.rms_db_away <= modalfit::most_synthesis_db)) {
    doubts.push_back(fmt::format("{}: the modal model of {} modes is {:.2g} dB off its data away from antiresonances",
                                 measured.header.file, found.modes_inside(), error.rms_db_away));
  }
  return on(lines_hz);
}

}  // namespace

std::unique_ptr<frf::FrfSystem> modal_parts(const ResponseScene& scene, const std::vector<std::unique_ptr<frf::FrfSource>>& parts,
                                            std::vector<double> lines_hz, const ident::Control& control,
                                            std::vector<std::string>& doubts) {
  std::vector<frf::FrfSet> measured;
  for (const auto& source : parts) {
    measured.push_back(frf::load(*source));
    const std::vector<double>& own = measured.back().header.frequency_hz;
    std::erase_if(lines_hz, [&](double hz) { return hz < own.front() || hz > own.back(); });
  }
  if (lines_hz.empty())
    fail(scene.file.string(), "no frequency of the scene lies in the range of all parts", "choose another range");
  std::vector<frf::FrfSet> models;
  for (const frf::FrfSet& part : measured) models.push_back(on_lines(part, lines_hz, control, doubts));
  return frf::memory_system("[data] parts", std::move(models), frf::Composition::uncoupled);
}

}  // namespace jointid::tasks
