#include "report/text/display_of_tasks.hpp"

#include "frf/set/line_scale.hpp"

namespace jointid::report {
namespace {

void convert_unknown(const Display& display, study::UnknownStatistics& unknown) {
  const auto [unit, factor] = shown_unit(display, unknown.unit);
  unknown.unit = unit;
  for (double* value : {&unknown.mean, &unknown.std_deviation}) *value *= factor;
  for (auto* value : {&unknown.truth, &unknown.bias, &unknown.rms_error}) {
    if (*value) **value *= factor;
  }
  for (double& quantile : unknown.quantiles) quantile *= factor;
}

}  // namespace

tasks::StudyResult in_units_of(const Display& display, tasks::StudyResult result) {
  for (study::UnknownStatistics& unknown : result.statistics.unknowns) convert_unknown(display, unknown);
  return result;
}

tasks::StudyHistograms in_units_of(const Display& display, tasks::StudyHistograms histograms) {
  for (tasks::TrialHistogram& histogram : histograms.unknowns) {
    const auto [unit, factor] = shown_unit(display, histogram.unit);
    histogram.unit = unit;
    histogram.low *= factor;
    histogram.high *= factor;
    if (histogram.mark) *histogram.mark *= factor;
  }
  return histograms;
}

std::vector<tasks::LevelJoint> in_units_of(const Display& display, std::vector<tasks::LevelJoint> levels) {
  const double length = shown_unit(display, "m").factor, stiffness = shown_unit(display, "N/m").factor;
  for (tasks::LevelJoint& level : levels) {
    level.displacement *= length;
    for (double* value : {&level.joint.stiffness, &level.joint.damping, &level.joint.deviation}) *value *= stiffness;
  }
  return levels;
}

std::vector<tasks::PredictedFrf> in_units_of(const Display& display, const std::vector<double>& frequency_hz,
                                             std::vector<tasks::PredictedFrf> frfs) {
  for (tasks::PredictedFrf& frf : frfs) {
    const double factor = frf_factor(display, frf.response, frf.reference);
    for (std::size_t line = 0; line < frequency_hz.size(); ++line) {
      const auto scale = frf::LineScale::from_receptance(display.quantity, frequency_hz[line]);
      for (auto* values : {&frf.value, &frf.with_all, &frf.measured}) {
        if (!values->empty()) (*values)[line] = factor * scale.value((*values)[line]);
      }
      if (!frf.variance.empty()) frf.variance[line] = factor * factor * scale.variance(frf.variance[line]);
    }
  }
  return frfs;
}

}  // namespace jointid::report
