#pragma once

#include <QWidget>
#include <optional>

#include "gui/couple/couple_job.hpp"
#include "gui/scene/scene_check.hpp"

class QCheckBox;
class QLabel;
class QPushButton;
class QTabWidget;

namespace jointid::gui {

class CellTable;
class JobLine;
class PlotMenu;

/// Whether a text is a scene of `jointid couple`: it has a table [couple].
bool is_couple_scene(const std::string& text);

/// The assembly as its parts and joints give it, with intervals and bounds, over what was measured of it.
class CouplePage : public QWidget {
  Q_OBJECT

 public:
  explicit CouplePage(QWidget* parent = nullptr);

  /// A scene of coupling, or anything else, with which the page has nothing to do. What is wrong with a scene of coupling.
  /// `file`: where it is saved, or empty.
  std::optional<SceneError> set_scene(const std::string& text, const std::filesystem::path& path, const QString& file);
  /// FRFs of the real assembly, shown behind the predicted ones.
  void set_measured(const QStringList& files);
  void set_bounds(bool on);
  void run();
  void cancel();
  bool is_busy() const;

  const Coupled* shown() const { return coupled_.get(); }
  QString status() const;
  PlotMenu* plots() const { return plots_; }
  CellTable* errors() const { return errors_; }
  CellTable* resonances() const { return resonances_; }
  CellTable* conditions() const { return conditions_; }
  /// SCENE's name with .coupled.h5, beside the scene.
  QString result_file() const;
  /// "jointid couple 'c.toml' --out 'c.coupled.h5' --bounds".
  QString command_line() const;

 Q_SIGNALS:
  void failed(const jointid::InputError& error);

 private:
  QWidget* make_top();
  QTabWidget* make_tables();
  void show_coupled();
  void show_buttons();

  QPushButton *run_, *command_;
  QCheckBox* bounds_;
  QLabel* names_;
  JobLine* line_;
  PlotMenu* plots_;
  QTabWidget* tables_;
  CellTable *errors_, *resonances_, *conditions_;
  std::optional<ident::CoupleScene> scene_;
  QString file_;
  QStringList measured_;
  std::shared_ptr<const Coupled> coupled_;
};

}  // namespace jointid::gui
