#pragma once

#include <QWidget>
#include <optional>

#include "gui/modal/modal_job.hpp"
#include "gui/modal/picked_poles.hpp"

class QCheckBox;
class QLabel;
class QComboBox;
class QDoubleSpinBox;
class QPushButton;
class QTabWidget;

namespace jointid::gui {

class CellTable;
class Chart;
class FrfPlot;
class HeatChart;
class JobLine;

/// Modes behind the FRFs of a part or of the assembly: a stabilisation diagram whose poles are taken and left by click, the FRFs
/// that the modes give over the measured ones, the modes with their deviations, and their MAC.
class ModalPage : public QWidget {
  Q_OBJECT

 public:
  explicit ModalPage(QWidget* parent = nullptr);

  void set_scene(const std::optional<ident::Scene>& scene);
  /// Seeks all modes of the structure that is chosen.
  void run();
  void cancel();
  bool is_busy() const;
  void undo();
  void redo();

  const tasks::ModalRun* shown() const { return run_.get(); }
  const PickedPoles& picked() const { return picked_; }
  QString status() const;
  Chart* chart() const { return chart_; }
  FrfPlot* plot() const { return plot_; }
  CellTable* modes() const { return modes_; }
  CellTable* mac() const { return mac_; }
  HeatChart* cross_mac() const { return cross_mac_; }
  /// The modes that are found beside those of a universal file.
  void compare_with(const QString& file);
  QTabWidget* results() const { return results_; }
  /// "jointid modalfit 'part.uff' --range 10:500 --poles 51.5:0.001".
  QString command_line() const;
  /// What `jointid modalfit --shapes` and `--regenerate` write.
  void write_shapes(const QString& file);
  void write_regenerated(const QString& file);

 Q_SIGNALS:
  void failed(const jointid::InputError& error);
  /// shown() has other modes.
  void modes_changed();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* make_top();
  QWidget* make_results();
  QWidget* make_frf_tab();
  QWidget* make_cross_tab();
  void show_cross_mac();
  void connect_all();
  modalfit::FitOptions options() const;
  void add_job(const modalfit::FitOptions& options);
  void pick(std::vector<modalfit::Pole> poles);
  void toggle(std::size_t group, std::size_t point);
  void leave_chosen_mode();
  void go();
  void show_run();
  void show_frf();
  void show_buttons();
  void write(const QString& file, const std::function<void(const std::filesystem::path&)>& to);
  const ModalStructure* structure() const;

  QComboBox *structure_, *damping_, *response_, *reference_;
  QCheckBox* real_;
  QDoubleSpinBox *low_, *high_;
  QPushButton *find_, *undo_, *redo_, *none_, *command_, *shapes_, *regenerated_;
  JobLine* line_;
  Chart* chart_;
  QTabWidget* results_;
  FrfPlot* plot_;
  CellTable *modes_, *mac_, *errors_;
  HeatChart* cross_mac_;
  QLabel* cross_word_;
  QString other_modes_;  ///< the file of the other set
  std::vector<ModalStructure> structures_;
  std::shared_ptr<const frf::FrfSet> loaded_;
  std::shared_ptr<const tasks::ModalRun> run_, sought_;  ///< shown; by the search, whose diagram stays
  ModalStructure of_run_;
  modalfit::FitOptions used_;  ///< of the search
  PickedPoles picked_;
  std::size_t wanted_ = 0;  ///< counts jobs
};

}  // namespace jointid::gui
