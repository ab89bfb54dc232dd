#include "frf/set/h1.hpp"
#include "ident/scene/scene_sections.hpp"

namespace jointid::ident {
namespace {

const std::vector<std::string> models = {"uniform", "gaussian", "circular", "hammer", "modal"};

double probability(const scene::Item& item) {
  const double value = item.not_negative();
  if (value > 1.0) item.fail(std::to_string(value) + " is no probability", "0 to 1 is needed");
  return value;
}

/// Number of averages; those that overlap count for less (effective_averages() of a Hann window).
int read_averages(const scene::Table& table, int otherwise) {
  const auto averages = table.find("averages");
  const auto overlap = table.find("overlap");
  if (!averages) {
    if (overlap) overlap->fail("overlap is given without averages", "give averages, too");
    return otherwise;
  }
  const double count = averages->positive();
  if (count < 2.0 || count != static_cast<int>(count)) averages->fail("averages is no whole number from 2 on");
  if (!overlap) return static_cast<int>(count);
  const double share = overlap->not_negative();
  if (share >= 1.0) overlap->fail("overlap is outside 0 <= overlap < 1");
  const double effective = frf::effective_averages(static_cast<int>(count), share, frf::Window::hann);
  if (effective < 2.0) averages->fail("the overlapping averages are worth less than two", "take more averages");
  return static_cast<int>(effective);
}

frf::GrossErrors read_gross(const scene::Item& item) {
  const scene::Table table = item.table({"share", "factor"});
  frf::GrossErrors gross;
  gross.share = probability(table.require("share"));
  if (const auto factor = table.find("factor")) gross.factor = factor->positive();
  return gross;
}

void read_hammer(const scene::Table& table, frf::NoiseModel& model) {
  if (const auto coherence = table.find("coherence")) {
    model.coherence = coherence->positive();
    coherence->here([&] { frf::validate({.kind = frf::NoiseKind::hammer, .coherence = model.coherence}); });
  }
  model.averages = read_averages(table, model.averages);
}

void read_extra_errors(const scene::Table& table, frf::NoiseModel& model) {
  if (const auto floor = table.find("floor")) model.floor = floor->not_negative();
  if (const auto gross = table.find("gross")) model.gross = read_gross(*gross);
  if (const auto share = table.find("sign_errors")) model.sign_errors = probability(*share);
  if (const auto length = table.find("position_errors")) model.position_errors = length->not_negative();
  if (const auto reciprocal = table.find("reciprocal")) model.reciprocal = reciprocal->boolean();
}

}  // namespace

NoiseSection read_noise(const scene::Item& item) {
  const std::vector<std::string> beside = {"floor", "gross", "sign_errors", "position_errors", "reciprocal",
                                           "gain_errors", "mass_errors"};
  const scene::Table all = item.open_table();
  NoiseSection noise;
  noise.model = all.require("model").word(models);
  std::vector<std::string> keys = {"model"};
  if (noise.model == "hammer") {
    keys.insert(keys.end(), {"coherence", "averages", "overlap"});
  } else {
    keys.push_back("level");
  }
  if (noise.model != "modal") keys.insert(keys.end(), beside.begin(), beside.end());
  const scene::Table table = item.table(keys);
  if (noise.model == "hammer") {
    read_hammer(table, noise.frf_model);
  } else {
    noise.level = table.require("level").not_negative();
  }
  if (noise.model == "modal") return noise;
  noise.frf_model.kind = frf::parse_noise_kind(noise.model);
  if (noise.model != "hammer") noise.frf_model.level = noise.level;
  read_extra_errors(table, noise.frf_model);
  if (const auto gain = table.find("gain_errors")) noise.gain_errors = gain->not_negative();
  if (const auto mass = table.find("mass_errors")) noise.mass_errors = mass->not_negative();
  return noise;
}

}  // namespace jointid::ident
