#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QTabWidget>
#include <QTextDocument>

#include "gui/look/message_bar.hpp"
#include "gui/look/output.hpp"
#include "gui/look/paths.hpp"
#include "gui/project.hpp"
#include "gui/recent_files.hpp"
#include "gui/scene/scene_editor.hpp"
#include "gui/solve/kept_runs.hpp"
#include "gui/solve/solve_page.hpp"
#include "ident/scene/scene_files.hpp"

namespace jointid::gui {
namespace {

constexpr qint64 largest_scene = qint64{16} << 20;  // bytes, as of the scene reader

bool read_file(const QString& file, QString& text, QString& why) {
  QFile in(file);
  if (!in.open(QIODevice::ReadOnly)) {
    why = in.errorString();
  } else if (in.size() > largest_scene) {
    why = Project::tr("it is larger than 16 MiB");
  } else {
    const QByteArray bytes = in.readAll();
    text = QString::fromUtf8(bytes);
    if (text.toUtf8() != bytes) why = Project::tr("it is not text in UTF-8");
  }
  return why.isEmpty();
}

}  // namespace

namespace {

QString layout_file(const QString& scene) { return QDir(run_folder(scene)).filePath(QStringLiteral("layout.json")); }

}  // namespace

void Project::keep_layout() const {
  if (file_.isEmpty() || !QFileInfo::exists(run_folder(file_))) return;
  const auto run = solve_page_->run_in_front();
  const QJsonObject layout = {{"splitter", QString::fromLatin1(layout_state().toBase64())},
                              {"form", views_->currentIndex() == 1},
                              {"page", pages_->currentIndex()},
                              {"result", solve_page_->results()->currentIndex()},
                              {"run", run ? QFileInfo(solve_page_->runs()[*run].kept).fileName() : QString()}};
  QSaveFile out(layout_file(file_));
  if (out.open(QIODevice::WriteOnly) && out.write(QJsonDocument(layout).toJson()) >= 0) out.commit();
}

/// What cannot be read, or is no longer there, changes nothing.
void Project::restore_kept_layout() {
  QFile in(layout_file(file_));
  if (!in.open(QIODevice::ReadOnly)) return;
  const QJsonObject layout = QJsonDocument::fromJson(in.readAll()).object();
  if (layout.isEmpty()) return;
  restore_layout(QByteArray::fromBase64(layout["splitter"].toString().toLatin1()));
  views_->setCurrentIndex(layout["form"].toBool() ? 1 : 0);
  if (const int page = layout["page"].toInt(-1); page >= 0 && page < pages_->count()) pages_->setCurrentIndex(page);
  QTabWidget* const results = solve_page_->results();
  if (const int result = layout["result"].toInt(-1); result >= 0 && result < results->count() && results->isTabVisible(result))
    results->setCurrentIndex(result);
  solve_page_->want_run(QDir(run_folder(file_)).filePath(layout["run"].toString()));
}

std::filesystem::path Project::path() const { return file_.isEmpty() ? as_path(folder_) / "scene.toml" : as_path(file_); }

QString Project::suggested_file() const { return as_name(path()); }

QString Project::title() const { return file_.isEmpty() ? tr("new scene") : QFileInfo(file_).fileName(); }

bool Project::load(QString& why) {
  QString text;
  if (!read_file(file_, text, why)) return false;
  on_disk_ = text;
  editor_->setPlainText(text);
  editor_->document()->setModified(false);
  check();
  return true;
}

bool Project::open(const QString& file) {
  file_ = QFileInfo(file).absoluteFilePath();
  folder_ = QFileInfo(file_).absolutePath();
  QString why;
  if (!load(why)) {
    messages_->warn(tr("%1 cannot be read: %2").arg(file, why));
    file_.clear();
    return false;
  }
  restore_kept_layout();
  watch();
  note_recent_file(file_);
  Q_EMIT title_changed();
  return true;
}

void Project::start(const std::string& text, const QString& folder) {
  folder_ = QFileInfo(folder).absoluteFilePath();
  editor_->setPlainText(QString::fromStdString(text));
  editor_->document()->setModified(true);
  check();
}

/// A change that nobody has seen yet is not written over; the message offers to.
bool Project::save() {
  if (file_.isEmpty()) return false;
  if (!is_changed_outside()) return write(file_);
  messages_->ask(tr("%1 was changed by another program, and is not saved over.").arg(title()), tr("Replace the file"),
                 [this] { write(file_); });
  return false;
}

bool Project::is_changed_outside() const {
  QString text, why;
  return QFileInfo::exists(file_) && (!read_file(file_, text, why) || text != on_disk_);
}

bool Project::save_as(const QString& file) { return write(QFileInfo(file).absoluteFilePath()); }

bool Project::write(const QString& target) {
  std::vector<std::filesystem::path> inputs;
  if (checked_.seen()) {
    for (const auto& [input, place] : ident::files_of(*checked_.seen())) {
      if (input != path()) inputs.push_back(input);
    }
  }
  if (!file_.isEmpty()) watcher_.removePath(file_);
  try {
    write_output(target, editor_->text(), inputs);
  } catch (const InputError& error) {
    messages_->warn(QString::fromUtf8(error.what()));
    return false;
  }
  file_ = target;
  folder_ = QFileInfo(file_).absolutePath();
  on_disk_ = QString::fromStdString(editor_->text());
  editor_->document()->setModified(false);
  messages_->hide();
  watch();
  note_recent_file(file_);
  check();  // paths are relative to the file
  Q_EMIT title_changed();
  return true;
}

/// A file that is saved by renaming another drops out of the watcher and has to be named again.
void Project::watch() {
  if (!file_.isEmpty() && !watcher_.files().contains(file_) && QFileInfo::exists(file_)) watcher_.addPath(file_);
}

void Project::file_changed() {
  watch();
  QString text, why;
  if (!read_file(file_, text, why)) return messages_->warn(tr("%1 is gone or cannot be read: %2").arg(title(), why));
  if (text == editor_->toPlainText()) {
    on_disk_ = text;
    return editor_->document()->setModified(false);
  }
  if (!is_modified()) return reload();
  messages_->ask(tr("%1 was changed here and by another program.").arg(title()), tr("Load the file again"), [this] { reload(); });
}

/// As an edit, so that it can be undone.
void Project::reload() {
  QString text, why;
  if (!read_file(file_, text, why)) return messages_->warn(tr("%1 cannot be read: %2").arg(title(), why));
  on_disk_ = text;
  editor_->replace_text(text.toStdString());
  editor_->document()->setModified(false);
  messages_->say(tr("%1 was changed by another program and is loaded again.").arg(title()));
}

}  // namespace jointid::gui
