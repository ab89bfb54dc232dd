#include "gui/look/dialogs.hpp"

#include <QFileDialog>
#include <QSettings>

namespace jointid::gui {
namespace {

const QString open_key = QStringLiteral("folder"), save_key = QStringLiteral("save_folder");

QString folder(const QString& key) { return QSettings().value(key).toString(); }

void note_folder(const QString& key, const QString& file) { QSettings().setValue(key, QFileInfo(file).absolutePath()); }

}  // namespace

void begin_dialogs_in(const QString& folder) {
  for (const QString& key : {open_key, save_key}) QSettings().setValue(key, folder);
}

namespace {

QStringList choose_to_open(QWidget* parent, const QString& filter) {
  const QStringList files = QFileDialog::getOpenFileNames(parent, QFileDialog::tr("Open"), folder(open_key), filter);
  if (!files.isEmpty()) note_folder(open_key, files.front());
  return files;
}

}  // namespace

QStringList choose_files_to_open(QWidget* parent) {
  return choose_to_open(parent,
                        QFileDialog::tr("Scenes and FRFs (*.toml *.uff *.unv *.h5 *.hdf5 *.mat *.csv *.txt);;All files (*)"));
}

QStringList choose_modes_to_open(QWidget* parent) {
  return choose_to_open(parent, QFileDialog::tr("Mode shapes (*.uff *.unv *.json);;All files (*)"));
}

QString choose_file_to_save(QWidget* parent, const QString& title, const QString& suggestion, const QString& filter,
                            const QString& suffix) {
  QFileDialog dialog(parent, title, folder(save_key), filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  if (!suggestion.isEmpty()) dialog.selectFile(suggestion);
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
  note_folder(save_key, dialog.selectedFiles().front());
  return dialog.selectedFiles().front();
}

}  // namespace jointid::gui
