#pragma once

#include <QDialog>
#include <string>

class QDialogButtonBox;
class QLineEdit;
class QTreeWidget;

namespace jointid::gui {

/// A built-in problem to be opened, and the folder that its files go to.
class ExampleDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ExampleDialog(QWidget* parent = nullptr);

  std::string name() const;  ///< of the problem that is chosen; empty where none is
  /// A folder of its own below the one that is typed.
  QString folder() const;
  QTreeWidget* problems() const { return list_; }

 private:
  QLayout* make_folder();
  void fill();
  void show_matching();
  void show_state();

  QLineEdit *filter_, *folder_;
  QTreeWidget* list_;
  QDialogButtonBox* buttons_;
};

/// Writes a built-in problem into a folder, or into NAME-2, NAME-3 … where that has files: nothing is replaced. Its scene, or its data
/// where it has none. Throws InputError.
QString write_example(const std::string& name, const QString& folder);

}  // namespace jointid::gui
