#include "gui/open/dropped_files.hpp"

#include "base/control.hpp"
#include "base/error.hpp"
#include "frf/set/frf_source.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "tasks/open/file_kind.hpp"
#include "tasks/open/frf_variables.hpp"
#include "tasks/propose_scene.hpp"

namespace jointid::gui {
namespace {

using Paths = std::vector<std::filesystem::path>;

const char* const one_file = "One file. A joint needs those of the parts and of the assembly.";
const char* const nodes_alone = "The nodes of a file without FRFs.";

/// Why a file that is nothing known has no FRFs.
void add_failure(const std::filesystem::path& file, DroppedFiles& dropped) {
  try {
    frf::open(file);
  } catch (const InputError& error) {
    dropped.failed << QString::fromUtf8(error.what());
  }
}

/// A scene of a joint where the files allow one, else one that shows them.
void make_scene(const Paths& frfs, const QString& folder, const std::function<bool()>& interrupted,
                const tasks::ChosenVariables& variables, DroppedFiles& dropped) {
  const std::filesystem::path from = as_path(folder);
  if (frfs.size() > 1) {
    try {
      dropped.scene = tasks::scene_text(tasks::propose_scene(frfs, interrupted, variables), from);
      dropped.is_proposal = true;
      return;
    } catch (const InputError& error) {
      const InputError::Parts& parts = error.parts();
      dropped.why = "No joint is proposed: " + parts.problem + "; " + parts.remedy + ".";
    }
  }
  dropped.scene = tasks::look_text(frfs, from, dropped.why.empty() ? one_file : dropped.why, variables);
}

QStringList variable_names(const std::vector<std::string>& variables) {
  QStringList out;
  for (const std::string& each : variables) out << q(each);
  return out;
}

}  // namespace

DroppedFiles sort_dropped(const QStringList& files, const QString& folder, const std::function<bool()>& interrupted,
                          const ChosenNames& chosen) {
  DroppedFiles dropped;
  Paths frfs, geometries, others;
  tasks::ChosenVariables variables;
  for (const QString& file : files) {
    stop_if(interrupted);
    const std::filesystem::path path = as_path(file);
    if (const auto found = chosen.find(file); found != chosen.end()) {
      variables[path] = found->second.toStdString();
      frfs.push_back(path);
      continue;
    }
    switch (tasks::kind_of_file(path)) {
      case tasks::FileKind::frfs: frfs.push_back(path); break;
      case tasks::FileKind::geometry: geometries.push_back(path); break;
      case tasks::FileKind::time_record: dropped.records << file; break;
      case tasks::FileKind::loading_curve: dropped.curves << file; break;
      case tasks::FileKind::other: others.push_back(path); break;
    }
  }
  for (const std::filesystem::path& file : others) {
    if (const QStringList names = variable_names(tasks::frf_variables(file)); !names.isEmpty())
      dropped.undecided.emplace_back(as_name(file), names);
  }
  if (!dropped.undecided.empty()) return dropped;
  if (others.size() == static_cast<std::size_t>(files.size())) frf::open(others.front());
  for (const std::filesystem::path& file : others) add_failure(file, dropped);
  if (!frfs.empty()) make_scene(frfs, folder, interrupted, variables, dropped);
  if (!geometries.empty()) dropped.geometry = tasks::look_text(geometries, as_path(folder), nodes_alone);
  return dropped;
}

}  // namespace jointid::gui
