#include "gui/couple/couple_job.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "frf/file/file_format.hpp"
#include "gui/look/said.hpp"
#include "gui/work/control_of.hpp"
#include "report/text/frf_criteria.hpp"

namespace jointid::gui {
namespace {

constexpr std::size_t most_frfs_shown = 60;
constexpr double deepest_db = 3.0;

Cell number_cell(const std::vector<double>& values, std::size_t i) {
  return {i < values.size() ? q(digits(values[i], "%.6g")) : QString()};
}

}  // namespace

std::shared_ptr<const Coupled> run_coupling(const CoupleWish& wish, const Worker::Watch& watch) {
  auto out = std::make_shared<Coupled>();
  out->scene = wish.scene;
  out->result = tasks::couple(wish.scene, wish.out, wish.bounds, control_of(watch));
  if (out->result.status != ident::Status::ok) return out;
  out->frfs = tasks::read_predicted(out->result, most_frfs_shown);
  for (const auto& file : wish.measured) tasks::compare_with(*frf::open(file), out->result.frequency_hz, out->frfs);
  return out;
}

CellRows coupling_errors(const Coupled& coupled) {
  CellRows out;
  out.columns << Said::tr("FRF") << Said::tr("error in dB (rms)") << Said::tr("FRAC") << Said::tr("LAC, mean");
  std::vector<std::pair<double, const tasks::PredictedFrf*>> all;
  for (const tasks::PredictedFrf& frf : coupled.frfs) {
    const double error = tasks::error_db(frf);
    if (std::isfinite(error)) all.emplace_back(error, &frf);
  }
  std::ranges::stable_sort(all, std::ranges::greater(), [](const auto& each) { return each.first; });
  for (const auto& [error, frf] : all) {
    Cell cell{q(digits(error, "%.2f"))};
    cell.shade = std::min(1.0, error / deepest_db);
    const report::FrfCriteria alike = report::criteria_of(frf->measured, frf->value);
    out.cells.push_back({{q(frf->response.name() + " / " + frf->reference.name())},
                         std::move(cell),
                         {q(report::criterion_text(alike.frac))},
                         {q(report::criterion_text(alike.lac))}});
  }
  return out;
}

CellRows resonance_rows(const tasks::CoupleResult& result) {
  const std::vector<double> all = result.with_all ? result.with_all->resonances_hz : std::vector<double>();
  CellRows out;
  out.columns << Said::tr("resonance (Hz)");
  if (result.with_all) out.columns << Said::tr("with all compatibility conditions (Hz)");
  for (std::size_t i = 0; i < std::max(result.result.resonances_hz.size(), all.size()); ++i) {
    std::vector<Cell> row = {number_cell(result.result.resonances_hz, i)};
    if (result.with_all) row.push_back(number_cell(all, i));
    out.cells.push_back(std::move(row));
  }
  return out;
}

}  // namespace jointid::gui
