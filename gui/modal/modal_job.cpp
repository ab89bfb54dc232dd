#include "gui/modal/modal_job.hpp"

#include <limits>

#include "base/control.hpp"
#include "base/text.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

constexpr std::size_t stages_of_a_fit = 5;

std::string exact(double value) { return digits(value, "%.17g"); }

std::string list_text(const char* option, const std::vector<frf::Dof>& dofs) {
  std::string names;
  for (const frf::Dof& dof : dofs) names += (names.empty() ? "" : ",") + dof.name();
  return names.empty() ? names : std::string(" --") + option + " " + names;
}

/// What the scene knows of a file that does not say it itself.
std::string open_text(const frf::OpenOptions& options) {
  std::string text;
  if (options.quantity) text += " --quantity " + frf::name(*options.quantity);
  const auto add = [&](const char* option, const std::string& word) {
    if (!word.empty()) text += std::string(" --") + option + " " + shell_word(q(word)).toStdString();
  };
  add("unit", options.unit);
  add("variable", options.variable);
  add("frequency-variable", options.frequency_variable);
  add("frequency-unit", options.frequency_unit);
  return text + list_text("response", options.response) + list_text("reference", options.reference);
}

std::string range_text(const std::array<double, 2>& range_hz) {
  const auto [low, high] = range_hz;
  return (low > 0.0 ? exact(low) : "") + ":" + (high < std::numeric_limits<double>::max() ? exact(high) : "");
}

std::string fit_text(const modalfit::FitOptions& options) {
  std::string text, poles;
  if (options.range_hz) text += " --range " + range_text(*options.range_hz);
  if (options.kind.real_modes) text += " --real";
  if (options.kind.damping != modalfit::Damping::viscous) text += " --damping " + modalfit::name(options.kind.damping);
  if (!options.poles) return text;
  for (const modalfit::Pole& pole : *options.poles)
    poles += (poles.empty() ? "" : ",") + exact(pole.frequency_hz) + ":" + exact(pole.damping);
  return text + " --poles " + poles;
}

}  // namespace

std::vector<ModalStructure> structures_of(const ident::DataSection& data) {
  std::vector<ModalStructure> out;
  for (const ident::DataFile& file : data.substructures) out.push_back({file.path.filename().string(), {file}});
  if (data.assembly.empty()) return out;
  out.push_back({comma_list(data.assembly, [](const ident::DataFile& file) { return file.path.filename().string(); }), data.assembly});
  return out;
}

ModalFound run_modal_job(const ModalWish& wish, const Worker::Watch& watch) {
  ModalFound found{wish.loaded, nullptr};
  if (!found.loaded) {
    watch.begin({1, 2, 0.0, 0.3});
    watch.progress("reading", 0, 0);
    found.loaded = std::make_shared<const frf::FrfSet>(tasks::load_structure(wish.structure.files));
    stop_if(watch.interrupted);
  }
  watch.begin({2, 2, wish.loaded ? 0.0 : 0.3, 1.0, stages_of_a_fit});
  modalfit::FitOptions options = wish.options;
  options.interrupted = watch.interrupted;
  options.progress = [&watch](const char* stage) { watch.progress(stage, 0, 0); };
  found.run = std::make_shared<const tasks::ModalRun>(tasks::run_modal(wish.structure.name, *found.loaded, options));
  return found;
}

QString modal_command(const ModalStructure& structure, const modalfit::FitOptions& options) {
  QString text = QStringLiteral("jointid modalfit");
  for (const ident::DataFile& file : structure.files) text += " " + shell_word(as_name(file.path));
  return text + q(open_text(structure.files.front().options) + fit_text(options));
}

std::vector<std::filesystem::path> inputs_of(const std::vector<ModalStructure>& structures) {
  std::vector<std::filesystem::path> out;
  for (const ModalStructure& structure : structures) {
    for (const ident::DataFile& file : structure.files) {
      out.push_back(file.path);
      for (const ident::DataFile& repeat : file.repeats) out.push_back(repeat.path);
    }
  }
  return out;
}

}  // namespace jointid::gui
