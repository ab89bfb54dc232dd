#include "gui/plot/frf_plot.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "gui/look/named.hpp"
#include "gui/plot/plot_canvas.hpp"

namespace jointid::gui {
namespace {

QString text_of(View view) {
  switch (view) {
    case View::magnitude_phase:
      return FrfPlot::tr("magnitude and phase");
    case View::real_imaginary:
      return FrfPlot::tr("real and imaginary part");
    case View::nyquist:
      return FrfPlot::tr("Nyquist");
    case View::coherence:
      return FrfPlot::tr("coherence");
    case View::difference:
      return FrfPlot::tr("computed over measured");
    case View::sum:
      return FrfPlot::tr("sum of magnitudes");
    case View::cmif:
      return FrfPlot::tr("CMIF");
  }
  return {};
}

QToolButton* button(const char* name, const QString& text, const QString& hint) {
  auto* made = named(new QToolButton, name, hint, hint);
  made->setText(text);
  made->setFocusPolicy(Qt::StrongFocus);
  return made;
}

}  // namespace

FrfPlot::FrfPlot(const QString& hint, QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("FRFs"));
  canvas_ = new PlotCanvas(hint);
  readout_ = named(new QLabel, "readout", tr("Values at the cursor"));
  readout_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  readout_->setTextFormat(Qt::PlainText);
  readout_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  add_controls();
  column->addWidget(canvas_, 1);
  column->addWidget(readout_);
  connect(canvas_, &PlotCanvas::cursor_moved, this, [this](double frequency_hz) {
    show_cursor(frequency_hz);
    Q_EMIT cursor_moved(frequency_hz);
  });
  connect(canvas_, &PlotCanvas::band_chosen, this, &FrfPlot::band_chosen);
}

FrfPlot::~FrfPlot() = default;

void FrfPlot::add_controls() {
  views_ = named(new QComboBox, "plot_view", tr("What is drawn"));
  for (const View view : {View::magnitude_phase, View::real_imaginary, View::nyquist, View::coherence}) offer(view);
  quantities_ = named(new QComboBox, "plot_quantity", tr("Quantity"));
  for (const auto quantity : {frf::Quantity::receptance, frf::Quantity::mobility, frf::Quantity::accelerance}) {
    quantities_->addItem(QString::fromStdString(frf::name(quantity)), static_cast<int>(quantity));
  }
  exclude_ = button("plot_exclude", tr("Exclude"), tr("While pressed, drag to leave a band out of the identification"));
  exclude_->setCheckable(true);
  exclude_->hide();
  auto* all = button("plot_all", tr("All"), tr("Show all frequencies (Home, or a double click)"));
  auto* copy_button = button("plot_copy", tr("Copy"), tr("Copy the curves for a spreadsheet, and the picture"));
  auto* save_button = button("plot_save", tr("Save…"), tr("Save as PNG, SVG, PDF or CSV"));
  auto* row = new QHBoxLayout;
  row->addWidget(views_);
  row->addWidget(quantities_);
  row->addStretch(1);
  for (QToolButton* each : {exclude_, all, copy_button, save_button}) row->addWidget(each);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
  connect(views_, &QComboBox::currentIndexChanged, this, [this] {
    redraw();
    Q_EMIT view_changed();
  });
  connect(quantities_, &QComboBox::currentIndexChanged, this, &FrfPlot::redraw);
  connect(exclude_, &QToolButton::toggled, this, [this](bool on) { canvas_->set_excluding(on); });
  connect(all, &QToolButton::clicked, canvas_, &PlotCanvas::show_all);
  connect(copy_button, &QToolButton::clicked, this, [this] { copy_plot(saveable()); });
  connect(save_button, &QToolButton::clicked, this, [this] { ask_and_save(this, saveable(), inputs_); });
}

void FrfPlot::let_exclude() { exclude_->show(); }

void FrfPlot::offer(View view) { views_->addItem(text_of(view), static_cast<int>(view)); }

frf::Quantity FrfPlot::quantity() const { return static_cast<frf::Quantity>(quantities_->currentData().toInt()); }

View FrfPlot::view() const { return static_cast<View>(views_->currentData().toInt()); }

void FrfPlot::set_view(View view) { views_->setCurrentIndex(views_->findData(static_cast<int>(view))); }

const std::vector<Curve>& FrfPlot::curves() const { return canvas_->curves(); }

void FrfPlot::set_curves(std::vector<Curve> curves) {
  std::erase_if(curves, [](const Curve& curve) { return curve.values.empty(); });
  canvas_->draw(curves, view(), quantity());
  readout_->clear();
}

void FrfPlot::redraw() { set_curves(canvas_->curves()); }

void FrfPlot::set_bands(std::vector<ident::Range> excluded, std::optional<ident::Range> range) {
  canvas_->set_bands(std::move(excluded), range);
}

void FrfPlot::set_marked(std::vector<double> marked_hz) { canvas_->set_marked(std::move(marked_hz)); }

void FrfPlot::set_cursor(double frequency_hz) {
  canvas_->move_cursor(frequency_hz);
  show_cursor(frequency_hz);
}

void FrfPlot::show_cursor(double frequency_hz) {
  readout_->setText(QString::fromStdString(gui::readout(curves(), frequency_hz, quantity())));
}

QString FrfPlot::readout() const { return readout_->text(); }

Saveable FrfPlot::saveable() const {
  return {[this](const QString& ending) { return canvas_->picture(ending); },
          [this](char separator) { return curves_table(curves(), quantity(), separator); }};
}

void FrfPlot::save(const QString& file) const { save_plot(file, saveable(), inputs_); }

}  // namespace jointid::gui
