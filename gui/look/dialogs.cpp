#include "gui/look/dialogs.hpp"

#include <QFileDialog>
#include <QSettings>

namespace jointid::gui {
namespace {

const QString folder_key = QStringLiteral("folder");

QString folder() { return QSettings().value(folder_key).toString(); }

void note_folder(const QString& file) { begin_dialogs_in(QFileInfo(file).absolutePath()); }

}  // namespace

void begin_dialogs_in(const QString& folder) { QSettings().setValue(folder_key, folder); }

QStringList choose_files_to_open(QWidget* parent) {
  const QString filter = QFileDialog::tr("Scenes and FRFs (*.toml *.uff *.unv *.h5 *.hdf5 *.mat *.csv *.txt);;All files (*)");
  const QStringList files = QFileDialog::getOpenFileNames(parent, QFileDialog::tr("Open"), folder(), filter);
  if (!files.isEmpty()) note_folder(files.front());
  return files;
}

QString choose_file_to_save(QWidget* parent, const QString& title, const QString& suggestion, const QString& filter,
                            const QString& suffix) {
  QFileDialog dialog(parent, title, folder(), filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  if (!suggestion.isEmpty()) dialog.selectFile(suggestion);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
  note_folder(dialog.selectedFiles().front());
  return dialog.selectedFiles().front();
}

}  // namespace jointid::gui
