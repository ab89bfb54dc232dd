#include "ident/check/beside_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "correlation/channels_beside.hpp"
#include "ident/check/inquiry.hpp"
#include "ident/check/trial/measured_channel.hpp"
#include "ident/check/trial/mistake_trial.hpp"
#include "ident/check/trial/mistaken_units.hpp"
#include "ident/plan/data_source.hpp"
#include "models/model_file.hpp"

namespace jointid::ident {
namespace {

using correlation::ChannelBeside;
using correlation::SetBeside;

constexpr double shift = 0.1;       ///< of resonances
constexpr double sure = 0.8;        ///< agreement of shapes: a channel above is right but for its sign and size
constexpr double unlike = 0.5;      ///< one below is not that of the model's coordinate
constexpr double size_error = 0.3;  ///< of a model's FRF, in log |factor| of a channel beside the others
constexpr double off_scale = 3.0;   ///< of a whole file
constexpr double one_unit = 0.25;   ///< of log factor

/// Lines of a model for a measured band: beyond it by the shift, close enough for a shape to change little from one to the next.
std::vector<double> model_lines(double low, double high) {
  constexpr std::size_t count = 400;
  std::vector<double> out;
  const double first = low / (1.0 + shift), last = high * (1.0 + shift);
  for (std::size_t i = 0; i < count; ++i) out.push_back(first * std::pow(last / first, static_cast<double>(i) / (count - 1)));
  return out;
}

/// Of a model all coordinates, or of a large one those that were measured.
frf::FrfSet model_set(frf::FrfSource& model, const frf::FrfHeader& measured) {
  constexpr std::size_t most = 300;
  const frf::FrfHeader& header = model.header();
  std::vector<std::size_t> responses, references;
  for (std::size_t k = 0; k < header.response.size(); ++k) {
    if (header.response.size() <= most || frf::has(measured.response, header.response[k])) responses.push_back(k);
  }
  for (std::size_t k = 0; k < header.reference.size(); ++k) {
    if (frf::has(measured.reference, header.reference[k])) references.push_back(k);
  }
  const std::vector<std::size_t> lines = all_indices(header.frequency_hz.size());
  return frf::load(model, {lines, responses, references});
}

/// What of one file stands against its model.
class Findings {
 public:
  Findings(std::string file, const Path& model, SetBeside found, CheckResult& result)
      : file_(std::move(file)), model_(model.filename().string()), found_(std::move(found)), result_(result) {}

  void tell() {
    note();
    if (tell_whole()) return;
    for (const ChannelBeside& channel : found_.channels) {
      channel.is_reference ? tell_reference(channel) : tell_response(channel);
    }
  }

 private:
  void note() {
    const ChannelBeside* worst = nullptr;
    for (const ChannelBeside& channel : found_.channels) {
      if (!channel.is_reference && (worst == nullptr || channel.agreement < worst->agreement)) worst = &channel;
    }
    result_.notes.push_back(fmt::format(
        "{} beside the model {}: responses agree with its shapes to {} (median), least {} at {} (1: alike); measured over model {}; "
        "like shapes of the model are at {} times the frequency",
        file_, model_, digits(found_.agreement, "%.3g"), digits(worst->agreement, "%.3g"), worst->dof.name(), digits(found_.factor, "%.3g"),
        digits(found_.frequency_ratio, "%.4g")));
  }

  void add(SuspectKind kind, const std::vector<frf::Dof>& dofs, const std::string& evidence, double confidence, const std::string& line) {
    result_.suspects.push_back({.kind = kind,
                                .file = file_,
                                .dofs = dofs,
                                .evidence = evidence + " (against the model " + model_ + ")",
                                .confidence = confidence,
                                .remedy = line.empty() ? "" : remedy_in(file_, line)});
  }

  /// A quantity or unit of the file; what its channels are then counts for less.
  bool tell_whole() {
    const double order = std::round(found_.slope);
    if (order != 0.0 && std::abs(order) <= 2.0 && std::abs(found_.slope - order) < 0.35) {
      add(SuspectKind::quantity, {},
          fmt::format("the FRFs over those of the model go with ω to the power of {:.2g}: receptances, mobilities and accelerances "
                      "are mixed up",
                      found_.slope),
          0.85, "");
      return true;
    }
    if (std::abs(std::log(found_.factor)) < std::log(off_scale)) return false;
    const UnitFactor unit = nearest_unit(1.0 / found_.factor, one_unit);
    add(SuspectKind::unit, {},
        fmt::format("the FRFs are {} times those of the model{}", digits(found_.factor, "%.3g"),
                    unit.words.empty() ? "" : ", as of " + unit.words),
        unit.words.empty() ? 0.6 : 0.85, "gain = " + digits(unit.factor, "%.6g"));
    return true;
  }

  void tell_response(const ChannelBeside& channel) {
    const std::string name = channel.dof.name(), dof = quoted_dof(channel.dof);
    if (channel.agreement < unlike && found_.agreement > sure) {
      tell_label(channel);
    } else if (channel.agreement >= sure && channel.factor < 0.0) {
      add(SuspectKind::sign, {channel.dof}, "the sensor at " + name + " points the other way", channel.agreement, "flip = [" + dof + "]");
    } else if (channel.agreement >= sure && std::abs(std::log(channel.factor)) > size_error) {
      add(SuspectKind::gain, {channel.dof},
          fmt::format("the sensor at {} reads {} times what it should", name, digits(channel.factor, "%.3g")), 0.7 * channel.agreement,
          fmt::format("gain = {{ {} = {} }}", dof, digits(1.0 / channel.factor, "%.3g")));
    }
  }

  void tell_label(const ChannelBeside& channel) {
    const std::string name = channel.dof.name();
    if (!channel.alike || channel.agreement_alike < sure) {
      add(SuspectKind::label, {channel.dof}, fmt::format("the sensor at {} has the shape of no coordinate of the model", name), 0.5, "");
      return;
    }
    const bool turned = channel.alike->node == channel.dof.node;
    add(turned ? SuspectKind::direction : SuspectKind::label, {channel.dof},
        fmt::format("the sensor at {} moves as {} does: {} of its part of the shapes, {} as labelled", name, channel.alike->name(),
                    percent(channel.agreement_alike), percent(channel.agreement)),
        channel.agreement_alike, "rename = { " + quoted_dof(channel.dof) + " = " + quoted_dof(*channel.alike) + " }");
  }

  void tell_reference(const ChannelBeside& channel) {
    const std::string name = channel.dof.name(), dof = quoted_dof(channel.dof);
    if (channel.agreement < sure) return;
    const double relative = channel.factor / found_.factor;
    if (channel.factor < 0.0) {
      add(SuspectKind::sign, {channel.dof}, "the hammer or shaker at " + name + " points the other way", channel.agreement,
          "flip_reference = [" + dof + "]");
    } else if (std::abs(std::log(relative)) > 2.0 * size_error) {
      add(SuspectKind::gain, {channel.dof},
          fmt::format("FRFs of the hammer or shaker at {} are {} times those of the model, of all references {}", name,
                      digits(channel.factor, "%.3g"), digits(found_.factor, "%.3g")),
          0.6, fmt::format("gain_reference = {{ {} = {} }}", dof, digits(1.0 / relative, "%.3g")));
    }
  }

  std::string file_, model_;
  SetBeside found_;
  CheckResult& result_;
};

void check_file(const Scene& scene, const DataFile& file, CheckResult& result) {
  const Sources opened = open_all({file});
  frf::FrfSource& source = *opened.front();
  const frf::FrfHeader& header = source.header();
  constexpr std::size_t most = 120;
  const std::vector<std::size_t> lines = lines_in_range(scene, header.frequency_hz, most);
  if (lines.empty()) return;
  const frf::FrfSet measured = frf::load(source, {lines, all_indices(header.response.size()), all_indices(header.reference.size())});
  const std::vector<double>& hz = measured.header.frequency_hz;
  const auto model = models::open_model(*file.model, model_lines(hz.front(), hz.back()));
  Findings(name_in_scene(scene, header.file), *file.model,
           correlation::beside_model(measured, model_set(*model, measured.header), shift), result)
      .tell();
}

}  // namespace

void check_beside_models(const Scene& scene, const Control& control, CheckResult& result) {
  const std::vector<Suspect> before = result.suspects;
  for (const auto* files : {&scene.data.substructures, &scene.data.assembly}) {
    for (const DataFile& file : *files) {
      stop_if(control.interrupted);
      if (file.model) check_file(scene, file, result);
    }
  }
  const auto is_known = [&](const Suspect& suspect) {
    return std::ranges::any_of(before, [&](const Suspect& other) {
      return other.kind == suspect.kind && other.file == suspect.file && other.dofs == suspect.dofs;
    });
  };
  const auto first = result.suspects.begin() + static_cast<std::ptrdiff_t>(before.size());
  result.suspects.erase(std::remove_if(first, result.suspects.end(), is_known), result.suspects.end());
  if (result.suspects.empty()) return;
  std::ranges::stable_sort(result.suspects, std::ranges::greater{}, &Suspect::confidence);
  result.verdict = std::max(result.verdict, verdict_of(result.suspects));
}

}  // namespace jointid::ident
