#include "gui/solve/kept_runs.hpp"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "gui/look/output.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/scene/scene_files.hpp"
#include "report/result/kept_run.hpp"

namespace jointid::gui {
namespace {

constexpr qint64 largest_run = qint64{512} << 20;  // bytes

/// A name that no run has yet: two may end in one second.
QString free_name(const QDir& folder, const QString& made) {
  const QString stem = QString(made).replace(QLatin1Char(':'), QLatin1Char('-'));
  QString name = stem + QStringLiteral(".json");
  for (int next = 2; folder.exists(name); ++next) name = stem + QStringLiteral("_%1.json").arg(next);
  return folder.filePath(name);
}

[[noreturn]] void refuse_folder(const QString& folder) {
  throw InputError({.kind = ErrorKind::data,
                    .file = folder.toStdString(),
                    .place = "",
                    .problem = "the folder for runs cannot be made",
                    .remedy = "save the scene where you may write"});
}

std::vector<std::string> changed_inputs(const std::vector<report::RunInput>& then) {
  std::vector<std::string> out;
  for (const report::RunInput& each : then) {
    if (input_as_it_is(each.file) != each) out.push_back(std::filesystem::path(each.file).filename().string());
  }
  return out;
}

Solved run_of_file(const QString& file, const QString& scene_file) {
  QFile in(file);
  if (!in.open(QIODevice::ReadOnly) || in.size() > largest_run) refuse("it cannot be read");
  report::KeptRun kept = report::read_kept_run(in.readAll().toStdString());
  Solved out;
  out.solution = std::move(kept.solution);
  out.worth = std::move(kept.worth);
  out.iterations = std::move(kept.iterations);
  out.made = std::move(kept.made);
  out.scene_text = std::move(kept.scene);
  out.scene_file = as_path(scene_file);
  out.inputs = std::move(kept.inputs);
  out.changed = changed_inputs(out.inputs);
  out.kept = file;
  return out;
}

}  // namespace

QString run_folder(const QString& scene_file) {
  const QFileInfo info(scene_file);
  return info.dir().filePath(info.completeBaseName() + QStringLiteral(".runs"));
}

void keep_run(Solved& run, const QString& scene_file) {
  const QDir folder(run_folder(scene_file));
  if (!folder.mkpath(QStringLiteral("."))) refuse_folder(folder.path());
  const QString file = free_name(folder, q(run.made));
  const report::KeptRun kept{run.made, run.scene_text, run.inputs, run.solution, run.worth, run.iterations};
  write_output(file, report::kept_run_json(kept), {});
  run.kept = file;
}

KeptRuns read_kept_runs(const QString& scene_file) {
  KeptRuns out;
  const QDir folder(run_folder(scene_file));
  for (const QString& name : folder.entryList({QStringLiteral("*T*.json")}, QDir::Files, QDir::Name)) {
    try {
      out.runs.push_back(run_of_file(folder.filePath(name), scene_file));
    } catch (const InputError& error) {
      out.failed << QStringLiteral("%1: %2").arg(name, QString::fromUtf8(error.what()));
    }
  }
  return out;
}

void make_plan_of(Solved& run) { run.plan = ident::make_plan(ident::parse_scene(run.scene_text, run.scene_file)); }

}  // namespace jointid::gui
