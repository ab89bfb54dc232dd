#include "gui/look/paths.hpp"

#include <QFile>
#include <QMimeData>
#include <QUrl>

namespace jointid::gui {

std::filesystem::path as_path(const QString& name) { return QFile::encodeName(name).toStdString(); }

QString as_name(const std::filesystem::path& path) { return QFile::decodeName(path.string().c_str()); }

QStringList local_files(const QMimeData* data) {
  QStringList files;
  for (const QUrl& url : data->urls()) {
    if (url.isLocalFile()) files << url.toLocalFile();
  }
  return files;
}

QString shell_word(QString text) { return "'" + text.replace("'", "'\\''") + "'"; }

}  // namespace jointid::gui
