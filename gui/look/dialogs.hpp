#pragma once

#include <QStringList>

class QWidget;

namespace jointid::gui {

/// The folder that the next dialog of files shows.
void begin_dialogs_in(const QString& folder);

/// Files to open, or none. The folder is remembered.
QStringList choose_files_to_open(QWidget* parent);
/// The same of files with mode shapes.
QStringList choose_modes_to_open(QWidget* parent);

/// A file to write, with `suffix` where the user gives none, or an empty name.
QString choose_file_to_save(QWidget* parent, const QString& title, const QString& suggestion, const QString& filter,
                            const QString& suffix);

}  // namespace jointid::gui
