#pragma once

#include <QWidget>
#include <filesystem>
#include <string>
#include <vector>

#include "gui/plot/picture.hpp"
#include "report/page/contents.hpp"

class QCPColorMap;
class QCustomPlot;
class QLabel;

namespace jointid::gui {

/// Values over two axes as colours: rows with names, from below, over columns with names or along an axis of numbers.
struct HeatPlot {
  std::string x_label, y_label, value_label;
  std::vector<std::string> columns;  ///< names; empty where x_values are there
  std::vector<double> x_values;      ///< ascending
  std::vector<std::string> rows;
  std::vector<double> values;  ///< [rows × columns]; NaN is left blank
  bool log = false;            ///< colours by powers of ten
  bool from_0_to_1 = false;    ///< colours from 0 to 1; else from the least to the largest value
};

/// The curves of a plot below each other, a row for each, named by its series.
HeatPlot heat_of(const report::CurvePlot& plot, const std::string& rows);

/// A map of colours with a scale beside it; the value under the mouse, or chosen by the arrow keys, is below.
class HeatChart : public QWidget {
  Q_OBJECT

 public:
  HeatChart(const char* name, const QString& accessible_name, const QString& hint, QWidget* parent = nullptr);

  /// The hint, where there are no values.
  void draw(HeatPlot plot);
  const HeatPlot& plot() const { return heat_; }
  QString readout() const;
  QWidget* canvas() const;
  /// The middle of a cell, in pixels of the canvas.
  QPoint pixel_of(std::size_t row, std::size_t column) const;
  Saveable saveable() const;
  void protect(std::vector<std::filesystem::path> inputs) { inputs_ = std::move(inputs); }

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void redraw();
  void fill(QCPColorMap& map) const;
  std::size_t column_count() const;
  void point_at(const QPoint& pixel);
  bool move_by(int key);
  void show_cell(std::size_t row, std::size_t column);
  std::string table(char separator) const;

  QString hint_;
  QCustomPlot* plot_;
  QLabel* readout_;
  HeatPlot heat_;
  std::size_t row_ = 0, column_ = 0;
  std::vector<std::filesystem::path> inputs_;
};

}  // namespace jointid::gui
