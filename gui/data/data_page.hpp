#pragma once

#include <QWidget>

#include "gui/data/loaded_file.hpp"
#include "gui/plot/curve.hpp"

class QCheckBox;
class QComboBox;
class QLabel;
class QTableView;
class QTreeWidget;

namespace jointid::gui {

class FrfGridModel;
class FrfPlot;
class Worker;

/// The files of a scene, which FRFs each has and how good they are, and the FRFs that are chosen there.
class DataPage : public QWidget {
  Q_OBJECT

 public:
  explicit DataPage(QWidget* parent = nullptr);

  /// `signature` is what the files depend on: they are opened anew when it changes.
  void set_scene(const ident::Scene& scene, const std::string& signature);

  const std::vector<LoadedFile>& files() const { return files_; }
  bool is_busy() const;
  /// Chooses a file, and FRFs of it as (response, reference) of the grid.
  void choose_file(std::size_t file);
  void choose_frfs(const std::vector<std::pair<int, int>>& entries);
  FrfPlot* plot() const { return plot_; }
  FrfGridModel* grid() const { return model_; }

 Q_SIGNALS:
  void files_opened();
  /// The user wants a value in the scene's text.
  void edit_wanted(const std::string& table, const std::string& key, const std::string& value);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void add_left();
  void show_files();
  void colour_files();
  void show_file();
  void show_figures(std::size_t file, std::vector<EntryFigures> figures);
  std::size_t most_wanted() const;
  void read_curves();
  void exclude(double low_hz, double high_hz);
  void include(double low_hz, double high_hz);
  void choose_next(int step);
  void use_as_joint();

  QTreeWidget* tree_;
  QLabel* about_;
  QComboBox* figure_;
  QCheckBox* everywhere_;
  QTableView* table_;
  FrfGridModel* model_ = nullptr;
  FrfPlot* plot_;
  Worker* worker_;
  std::vector<LoadedFile> files_;
  std::size_t chosen_ = 0;
  std::size_t wanted_ = 0;                 ///< counts what was asked of the plot, so that only the last is drawn
  View read_for_ = View::magnitude_phase;  ///< what the curves were read for
  std::string signature_;
  ident::Scene scene_;
};

}  // namespace jointid::gui
