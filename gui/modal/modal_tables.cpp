#include "gui/modal/modal_tables.hpp"

#include <cmath>

#include "base/text.hpp"
#include "gui/look/said.hpp"
#include "modalfit/model/mac.hpp"

namespace jointid::gui {
namespace {

constexpr double deepest_db = 3.0;

QString mode_name(const tasks::ModalRun& run, std::size_t r) {
  return QStringLiteral("%1: %2 Hz").arg(r + 1).arg(run.fit.modes[r].pole.frequency_hz, 0, 'g', 5);
}

Curve curve_of(const tasks::ModalRun& run, std::size_t response, std::size_t reference) {
  Curve curve;
  curve.response = run.fit.response[response];
  curve.reference = run.fit.reference[reference];
  curve.frequency_hz = run.band.frequency_hz;
  return curve;
}

}  // namespace

CellRows mac_rows(const tasks::ModalRun& run) {
  const tasks::Shapes all = tasks::shapes(run);
  CellRows out;
  for (std::size_t r = 0; r < all.of_mode.size(); ++r) {
    out.columns << mode_name(run, r);
    std::vector<Cell> cells;
    for (std::size_t s = 0; s < all.of_mode.size(); ++s) {
      const double mac = modalfit::mac(all.of_mode[r], all.of_mode[s]);
      Cell cell{std::isfinite(mac) ? q(digits(mac, "%.3f")) : QStringLiteral("–"),
                Said::tr("MAC of the modes at %1 and %2").arg(mode_name(run, r), mode_name(run, s))};
      if (std::isfinite(mac)) cell.shade = mac;
      cells.push_back(std::move(cell));
    }
    out.cells.push_back(std::move(cells));
  }
  out.rows = out.columns;
  return out;
}

CellRows synthesis_rows(const tasks::ModalRun& run) {
  CellRows out;
  for (const frf::Dof& dof : run.fit.reference) out.columns << q(dof.name());
  const auto& errors = run.symmetric ? run.of_model : run.of_fit;
  for (std::size_t r = 0; r < run.fit.response.size(); ++r) {
    out.rows << q(run.fit.response[r].name());
    std::vector<Cell> cells;
    for (std::size_t c = 0; c < run.fit.reference.size(); ++c) {
      const double error_db = errors[r * run.fit.reference.size() + c].rms_db_away;
      Cell cell{std::isfinite(error_db) ? q(digits(error_db, "%.2f")) : QStringLiteral("–")};
      if (std::isfinite(error_db)) cell.shade = std::min(1.0, error_db / deepest_db);
      cells.push_back(std::move(cell));
    }
    out.cells.push_back(std::move(cells));
  }
  return out;
}

std::vector<Curve> synthesised(const tasks::ModalRun& run, std::size_t response, std::size_t reference) {
  const std::size_t entries = run.band.entries(), entry = response * run.fit.reference.size() + reference;
  Curve measured = curve_of(run, response, reference), model = measured;
  measured.name = Said::tr("measured").toStdString();
  model.name = Said::tr("by the modes").toStdString();
  model.is_measured = false;
  for (std::size_t i = 0; i < run.band.lines(); ++i) {
    const Complex value = run.band.value(entry)[i];
    measured.values.push_back(value == 0.0 ? Complex(std::nan(""), std::nan("")) : value);
    model.values.push_back(run.regenerated.values[i * entries + entry]);
  }
  return {measured, model};
}

}  // namespace jointid::gui
