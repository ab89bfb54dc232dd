#include "ident/scene/scene_sections.hpp"

namespace jointid::ident {
namespace {

constexpr double most_lines = 1e7;

double read_step(const scene::Item& item, const std::optional<Range>& range) {
  const double step = item.positive();
  if (!range) item.fail("a step needs a range to start from", "give range = [lo, hi]");
  if (((*range)[1] - (*range)[0]) / step > most_lines) {
    item.fail("the step makes more than ten million lines of the range", "give the step in Hz");
  }
  return step;
}

ResonanceExclusion read_resonances(const scene::Item& item) {
  static const std::vector<std::string> words = {"substructures", "assembly"};
  const scene::Table table = item.table({"of", "half_width"});
  ResonanceExclusion exclusion;
  for (const scene::Item& of : table.require("of").list_not_empty()) {
    bool& flag = of.word(words) == "assembly" ? exclusion.of_assembly : exclusion.of_substructures;
    if (flag) of.fail("'" + of.text() + "' is named twice");
    flag = true;
  }
  if (const auto width = table.find("half_width")) {
    exclusion.half_width = width->number();
    if (!(exclusion.half_width > 0.0 && exclusion.half_width < 1.0)) {
      width->fail("half_width = " + scene::number_text(exclusion.half_width) + " is not between 0 and 1",
                  "it is relative: 0.01 leaves out 1 % on each side");
    }
  }
  return exclusion;
}

}  // namespace

FrequencySection read_frequency(const scene::Item& item) {
  const scene::Table table = item.table({"range", "step", "exclude", "exclude_resonances"});
  FrequencySection frequency;
  if (const auto range = table.find("range")) frequency.range_hz = range->interval();
  if (const auto step = table.find("step")) frequency.step_hz = read_step(*step, frequency.range_hz);
  if (const auto exclude = table.find("exclude")) {
    for (const scene::Item& interval : exclude->list()) frequency.exclude_hz.push_back(interval.interval());
  }
  if (const auto resonances = table.find("exclude_resonances")) {
    frequency.exclude_resonances = read_resonances(*resonances);
  }
  return frequency;
}

}  // namespace jointid::ident
