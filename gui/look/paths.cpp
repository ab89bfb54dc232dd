#include "gui/look/paths.hpp"

#include <QFile>

namespace jointid::gui {

std::filesystem::path as_path(const QString& name) { return QFile::encodeName(name).toStdString(); }

QString as_name(const std::filesystem::path& path) { return QFile::decodeName(path.string().c_str()); }

QString shell_word(QString text) { return "'" + text.replace("'", "'\\''") + "'"; }

}  // namespace jointid::gui
