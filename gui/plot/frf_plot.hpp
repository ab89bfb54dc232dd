#pragma once

#include <QWidget>
#include <filesystem>
#include <optional>

#include "gui/plot/curve.hpp"
#include "gui/plot/picture.hpp"
#include "ident/scene/scene.hpp"

class QComboBox;
class QLabel;
class QToolButton;

namespace jointid::gui {

class PlotCanvas;

/// FRFs in diagrams below each other with one frequency axis and one cursor: drag to zoom, wheel to zoom, double click for all,
/// arrows for the cursor; with "exclude" pressed a drag names a band instead.
class FrfPlot : public QWidget {
  Q_OBJECT

 public:
  explicit FrfPlot(const QString& hint, QWidget* parent = nullptr);
  ~FrfPlot() override;

  void set_curves(std::vector<Curve> curves);
  const std::vector<Curve>& curves() const;
  /// Bands that the scene leaves out, and the range that it takes.
  void set_bands(std::vector<ident::Range> excluded, std::optional<ident::Range> range);
  /// Lines to be seen at once, those that outlie.
  void set_marked(std::vector<double> marked_hz);
  /// Shows the button that lets bands be excluded.
  void let_exclude();
  /// Files that are never written over.
  void protect(std::vector<std::filesystem::path> inputs) { inputs_ = std::move(inputs); }
  void offer(View view);  ///< adds a view to the choices
  void set_view(View view);
  View view() const;

  void set_cursor(double frequency_hz);
  QString readout() const { return readout_text_; }
  /// Magnitudes in dB.
  void set_decibel(bool on);
  /// The curves and their view in a window of their own.
  FrfPlot* pop_out();
  PlotCanvas& canvas() const { return *canvas_; }

  /// PNG, SVG or PDF by the ending of the name, CSV of the curves. Throws InputError (usage) for another ending, and where the
  /// disk does not take it or the file is protected.
  void save(const QString& file) const;

 Q_SIGNALS:
  void band_chosen(double low_hz, double high_hz);
  void cursor_moved(double frequency_hz);
  void view_changed();
  void band_unwanted(double low_hz, double high_hz);
  /// The FRF behind the one that is drawn (1), or before it (−1).
  void next_wanted(int step);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void add_controls();
  frf::Quantity quantity() const;
  void redraw();
  void show_readout();
  void offer_peaks();
  QString proposed_name() const;
  Saveable saveable() const;

  QComboBox* views_;
  QComboBox* quantities_;
  QToolButton *exclude_, *decibel_, *peaks_;
  QLabel* readout_ = nullptr;
  QString readout_text_;
  int hovered_ = -1;  ///< curve under the mouse
  PlotCanvas* canvas_;
  std::vector<std::filesystem::path> inputs_;
};

}  // namespace jointid::gui
