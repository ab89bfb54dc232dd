#pragma once

#include <QWidget>
#include <optional>

#include "gui/plot/curve.hpp"
#include "ident/scene/scene.hpp"

class QCPLayer;
class QCustomPlot;

namespace jointid::gui {

struct Drawing;

/// The drawing of FrfPlot, and what the mouse and the keys do in it. Alone with QCustomPlot, whose header takes seconds to
/// compile.
class PlotCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit PlotCanvas(const QString& hint, QWidget* parent = nullptr);

  void draw(const std::vector<Curve>& curves, View view, frf::Quantity quantity, bool decibel = false);
  void set_bands(std::vector<ident::Range> excluded, std::optional<ident::Range> range);
  /// Lines to be seen at once, those that outlie.
  void set_marked(std::vector<double> marked_hz);
  const std::vector<double>& marked() const { return marked_hz_; }
  void set_excluding(bool on) { excluding_ = on; }
  const std::vector<Curve>& curves() const { return curves_; }

  void move_cursor(double frequency_hz);
  /// The line of the cursor, where it is seen.
  std::optional<double> cursor_hz() const;
  /// The second cursor, from which the first is told; M sets it and takes it away.
  const std::optional<double>& mark_hz() const { return mark_hz_; }
  /// The axis of magnitudes round its middle, by a factor; all of it again where the frequencies change.
  void zoom_ordinates(double factor);
  ident::Range shown_ordinates() const;  ///< of the upper diagram
  void show_all();
  ident::Range shown_hz() const;
  void show_range(const ident::Range& range);

  /// The picture; `ending` is png, svg or pdf.
  QByteArray picture(const QString& ending) const;

  QCustomPlot* plot() const { return plot_; }

 Q_SIGNALS:
  void cursor_moved(double frequency_hz);
  void band_chosen(double low_hz, double high_hz);
  /// Delete was pressed with the cursor in an excluded band.
  void band_unwanted(double low_hz, double high_hz);
  void mark_changed();
  /// Other frequencies are shown.
  void range_changed();
  /// The curve under the mouse, or −1.
  void curve_hovered(int curve);
  /// Page Down asks for the next FRF, Page Up for the one before.
  void next_wanted(int step);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  Drawing drawing() const;
  void redraw();
  void draw_diagrams();
  void show_cursor();
  void fit_all();
  bool press(int key, bool far);
  void zoom(double factor);
  void end_drag(const QRect& rectangle);
  bool press_other(int key);
  bool move_by(int key, bool far);
  void drop_band();
  void hover(const QPointF& at);

  QString hint_;
  QCustomPlot* plot_;
  QCPLayer* overlay_;
  std::vector<Curve> curves_;
  View view_ = View::magnitude_phase;
  frf::Quantity quantity_ = frf::Quantity::receptance;
  std::vector<ident::Range> excluded_;
  std::vector<double> marked_hz_;
  std::optional<ident::Range> range_, shown_;
  std::optional<double> cursor_, mark_hz_;
  bool excluding_ = false, decibel_ = false;
  int hovered_ = -1;
};

}  // namespace jointid::gui
