#pragma once

#include <QCompleter>

class QLineEdit;
class QStringListModel;

namespace jointid::gui {

/// Completes the last name of a list with commas.
class ListCompleter : public QCompleter {
  Q_OBJECT

 public:
  ListCompleter(QLineEdit& line, const QString& accessible_name);

  void set_words(const QStringList& words);

  QStringList splitPath(const QString& path) const override;
  QString pathFromIndex(const QModelIndex& index) const override;

 private:
  const QLineEdit& line_;
  QStringListModel* words_;
};

}  // namespace jointid::gui
