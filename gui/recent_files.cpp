#include "gui/recent_files.hpp"

#include <QFileInfo>
#include <QSettings>

namespace jointid::gui {
namespace {

constexpr qsizetype most_files = 10;
const QString key = QStringLiteral("recent_files");

}  // namespace

QStringList recent_files() {
  QStringList files = QSettings().value(key).toStringList();
  files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
  return files;
}

void note_recent_file(const QString& path) {
  const QString whole = QFileInfo(path).absoluteFilePath();
  QStringList files = recent_files();
  files.removeAll(whole);
  files.prepend(whole);
  QSettings().setValue(key, QStringList(files.mid(0, most_files)));
}

}  // namespace jointid::gui
