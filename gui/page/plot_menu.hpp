#pragma once

#include <QWidget>
#include <variant>
#include <vector>

#include "gui/plot/heat_chart.hpp"
#include "report/page/contents.hpp"

class QComboBox;
class QStackedWidget;

namespace jointid::gui {

class Chart;

/// Diagrams of a page of which one choice is shown, by a menu.
class PlotMenu : public QWidget {
  Q_OBJECT

 public:
  /// The menu is named NAME_menu, the drawing NAME; `hint` stands where there is nothing.
  PlotMenu(const char* name, const QString& accessible_name, const QString& hint, QWidget* parent = nullptr);

  /// A group and how it is called in the menu; the choice that is shown stays, if it is still there.
  using Named = std::pair<QString, report::PlotGroup>;
  using NamedMap = std::pair<QString, HeatPlot>;
  void show_groups(const std::vector<Named>& groups, const std::vector<NamedMap>& maps = {});
  using Drawing = std::variant<std::vector<report::CurvePlot>, std::vector<report::HistogramPlot>, report::ScatterPlot, HeatPlot>;
  QComboBox* menu() const { return menu_; }
  Chart* chart() const { return chart_; }
  HeatChart* map() const { return map_; }

 private:
  void show_choice();

  QComboBox* menu_;
  QStackedWidget* drawn_;
  Chart* chart_;
  HeatChart* map_;
  std::vector<Drawing> choices_;
};

}  // namespace jointid::gui
