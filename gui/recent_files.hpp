#pragma once

#include <QStringList>

namespace jointid::gui {

/// Scenes that were opened or saved, the last first, kept in the user's settings. Those that are gone are left out.
QStringList recent_files();
void note_recent_file(const QString& path);

}  // namespace jointid::gui
