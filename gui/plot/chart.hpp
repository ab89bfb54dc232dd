#pragma once

#include <QWidget>
#include <array>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "gui/plot/picture.hpp"
#include "report/page/contents.hpp"

class QCustomPlot;
class QLabel;

namespace jointid::gui {

/// Points, curves or histograms as pages have them. A click on a point opens it; ← and → choose one, and Enter opens it. The
/// mouse over a point states it. Where it may be zoomed: wheel, + and − along the x-axis, drag moves it, double click or Home
/// show all.
class Chart : public QWidget {
  Q_OBJECT

 public:
  /// `hint` stands where there is nothing yet.
  Chart(const char* name, const QString& accessible_name, const QString& hint, QWidget* parent = nullptr);

  void draw(report::ScatterPlot plot);
  void draw(std::vector<report::HistogramPlot> plots);
  /// Below each other; those over the same axis zoom together.
  void draw(std::vector<report::CurvePlot> plots);
  void clear();
  /// The part of the x-axis that is shown then stays when something else is drawn.
  void let_zoom();
  std::array<double, 2> shown() const;  ///< of the x-axis
  const report::ScatterPlot& scatter() const { return scatter_; }
  const std::vector<report::HistogramPlot>& histograms() const { return histograms_; }
  const std::vector<report::CurvePlot>& curve_plots() const { return curves_; }

  /// Rings a point, which has to be there, without a signal.
  void choose(std::size_t group, std::size_t point);
  QString readout() const;
  /// Where a point is drawn, in pixels of the canvas.
  QPoint pixel_of(std::size_t group, std::size_t point) const;
  QWidget* canvas() const;
  void protect(std::vector<std::filesystem::path> inputs) { inputs_ = std::move(inputs); }
  Saveable saveable() const;

 Q_SIGNALS:
  void chosen(std::size_t group, std::size_t point);
  void opened(std::size_t group, std::size_t point);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using Place = std::pair<std::size_t, std::size_t>;

  void forget();
  void fit_legend();
  void redraw();
  void ring();
  bool press(int key);
  bool zoom_by(int key);
  bool release(const QPoint& at);
  void show_all();
  bool click(const QPoint& at);
  void hover(const QPoint& at);
  std::optional<std::pair<std::size_t, std::size_t>> nearest(const QPoint& at) const;
  QString point_text(const std::pair<std::size_t, std::size_t>& place) const;
  std::vector<Place> places() const;
  const report::Point& point_at(const Place& place) const;

  QString hint_;
  QCustomPlot* plot_;
  QLabel* readout_;
  report::ScatterPlot scatter_;
  std::vector<report::HistogramPlot> histograms_;
  std::vector<report::CurvePlot> curves_;
  bool may_zoom_ = false, zoomed_ = false;
  QPoint pressed_;
  std::optional<Place> chosen_;
  std::vector<std::filesystem::path> inputs_;
};

}  // namespace jointid::gui
