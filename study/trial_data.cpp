#include "study/trial_data.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "base/error.hpp"
#include "ident/identify.hpp"
#include "ident/plan/data_source.hpp"
#include "ident/plan/true_values.hpp"
#include "ident/result/quality.hpp"
#include "models/model_source.hpp"
#include "study/excerpt_pollution.hpp"
#include "study/recorded_noise.hpp"
#include "study/trial_noise.hpp"
#include "study/trial_regeneration.hpp"

namespace jointid::study {
namespace {

using Sources = std::vector<std::unique_ptr<frf::FrfSource>>;

/// Passes blocks on and remembers which responses and references were asked for.
class Recorder final : public frf::FrfSource {
 public:
  explicit Recorder(std::unique_ptr<frf::FrfSource> source) : source_(std::move(source)) { header_ = source_->header(); }

  void forget() {
    responses_.clear();
    references_.clear();
  }
  void want_all() {
    for (std::size_t i = 0; i < header_.response.size(); ++i) responses_.insert(i);
    for (std::size_t i = 0; i < header_.reference.size(); ++i) references_.insert(i);
  }

  /// What was asked for, at the given lines; one FRF when nothing was.
  frf::Excerpt excerpt(const std::vector<std::size_t>& lines) {
    if (responses_.empty()) responses_.insert(0);
    if (references_.empty()) references_.insert(0);
    const std::vector<std::size_t> responses(responses_.begin(), responses_.end());
    const std::vector<std::size_t> references(references_.begin(), references_.end());
    const frf::Block block{lines, responses, references};
    frf::Excerpt out = frf::excerpt(*source_, block);
    if (!keep_covariance_) return out;
    out.set.covariance = covariance_of(*source_, block);
    if (source_->has_reference_correlation()) {
      out.set.reference_correlation.resize(lines.size() * references.size() * references.size());
      source_->read_reference_correlation(lines, references, out.set.reference_correlation);
    }
    return out;
  }

  void keep_covariance() { keep_covariance_ = true; }
  bool has_covariance() const override { return source_->has_covariance(); }
  frf::FactorShape factor_shape() const override { return source_->factor_shape(); }
  bool has_reference_correlation() const override { return source_->has_reference_correlation(); }

 private:
  void remember(const frf::Block& block) {
    responses_.insert(block.responses.begin(), block.responses.end());
    references_.insert(block.references.begin(), block.references.end());
  }
  void do_read(const frf::Block& block, std::span<Complex> out) override {
    remember(block);
    source_->read(block, out);
  }
  void do_read_variance(const frf::Block& block, std::span<Complex> out) override {
    remember(block);
    source_->read_variance(block, out);
  }
  void do_read_coherence(const frf::Block& block, std::span<double> out) override {
    remember(block);
    source_->read_coherence(block, out);
  }
  void do_read_covariance(const frf::Block& pairs, std::span<Complex> out) override { read_pairs(*source_, pairs, out); }
  void do_read_factor(const frf::Block& block, std::span<Complex> rows, std::span<double> diagonal) override {
    source_->read_factor(block, rows, diagonal);
  }
  void do_read_reference_correlation(std::span<const std::size_t> lines, std::span<const std::size_t> references,
                                     std::span<Complex> out) override {
    source_->read_reference_correlation(lines, references, out);
  }

  std::unique_ptr<frf::FrfSource> source_;
  bool keep_covariance_ = false;  ///< in excerpts
  std::set<std::size_t> responses_, references_;
};

/// A system whose sources remember what is read of them.
struct Recorded {
  std::unique_ptr<frf::FrfSystem> system;
  std::vector<Recorder*> recorders;
};

Recorded record(const char* name, Sources sources, frf::Composition composition, bool reciprocity) {
  Recorded out;
  for (auto& source : sources) {
    auto recorder = std::make_unique<Recorder>(std::move(source));
    out.recorders.push_back(recorder.get());
    source = std::move(recorder);
  }
  out.system = std::make_unique<frf::FrfSystem>(name, std::move(sources), composition, reciprocity);
  return out;
}

std::vector<std::size_t> all_lines(const frf::FrfHeader& header) {
  std::vector<std::size_t> lines(header.lines());
  std::iota(lines.begin(), lines.end(), std::size_t{0});
  return lines;
}

/// The scatter of an FRF is seen on lines next to each other, those not in use as well; modes on all of them.
bool needs_all_lines(const ident::Scene& scene) {
  return scene.identify.variance == ident::VarianceChoice::local || scene.data.regenerate.any();
}

std::vector<frf::Excerpt> take(const ident::Plan& plan, const frf::FrfSystem& system, std::size_t ident::Line::*line_of,
                               const std::vector<Recorder*>& recorders) {
  std::vector<double> axis;
  for (const ident::Line& line : plan.lines) axis.push_back(line.frequency_hz);
  std::vector<frf::Excerpt> excerpts;
  for (std::size_t s = 0; s < recorders.size(); ++s) {
    if (needs_all_lines(plan.scene)) {
      excerpts.push_back(recorders[s]->excerpt(all_lines(recorders[s]->header())));
      continue;
    }
    std::vector<std::size_t> lines;
    for (const ident::Line& line : plan.lines) lines.push_back(system.source_line(s, line.*line_of));
    excerpts.push_back(recorders[s]->excerpt(lines));
    excerpts.back().set.header.frequency_hz = axis;
  }
  return excerpts;
}

Measurements sets_of(const Excerpts& excerpts) {
  Measurements out;
  for (const frf::Excerpt& excerpt : excerpts.substructures) out.substructures.push_back(excerpt.set);
  for (const frf::Excerpt& excerpt : excerpts.assembly) out.assembly.push_back(excerpt.set);
  return out;
}

/// The scene for the excerpt: what was chosen on the whole data is not chosen again unless it has all lines.
ident::Scene scene_of_excerpt(const ident::Plan& plan) {
  ident::Scene scene = plan.scene;
  if (!needs_all_lines(scene)) scene.frequency = {};
  scene.identify.equations = plan.equations;
  return scene;
}

void describe(const ident::Plan& plan, TrialData& out) {
  const auto truth = ident::true_values(plan.restriction, plan.scene.truth);
  for (std::size_t column = 0; column < plan.columns->size(); ++column) {
    const std::size_t unknown = plan.columns->unknown_of(column);
    out.unknowns.push_back({.name = plan.columns->name(column, plan.restriction),
                            .unit = plan.restriction.unknowns[unknown].unit,
                            .kind = plan.restriction.unknowns[unknown].kind,
                            .truth = truth[unknown]});
  }
  for (const auto& [kind, matrix] : plan.scene.truth) {
    if (plan.restriction.has(kind) && ident::judge(matrix, matrix)) out.judged.push_back(kind);
  }
  out.lines = plan.lines.size();
  out.equations_per_line = plan.cost.equations_per_line;
}

/// Plans on the whole data, takes what the plan reads, and hands it to `make_pollution`.
template <class MakePollution>
std::shared_ptr<TrialData> prepare(const ident::Scene& scene, Sources substructures, Sources assembly, bool all_dofs, bool covariances,
                                   const MakePollution& make_pollution) {
  const bool reciprocity = scene.data.reciprocity;
  Recorded sub = record("substructures", std::move(substructures), frf::Composition::uncoupled, reciprocity);
  Recorded joined = record("assembly", std::move(assembly), frf::Composition::merged, reciprocity);
  const std::shared_ptr<frf::FrfSystem> parts = std::move(sub.system);  // couple_first couples them, line by line
  const auto plan = ident::make_plan(scene, parts, std::move(joined.system));
  for (const auto* recorders : {&sub.recorders, &joined.recorders}) {
    for (Recorder* recorder : *recorders) {
      all_dofs ? recorder->want_all() : recorder->forget();
      if (covariances && recorder->has_covariance()) recorder->keep_covariance();
    }
  }
  plan->method->read_first_line(*plan);
  const Excerpts excerpts{take(*plan, *parts, &ident::Line::substructures, sub.recorders),
                          take(*plan, *plan->assembly, &ident::Line::assembly, joined.recorders)};
  auto data = std::make_shared<TrialData>();
  data->scene = scene_of_excerpt(*plan);
  data->base = sets_of(excerpts);
  data->pollution = with_regeneration(make_pollution(excerpts), scene);
  describe(*plan, *data);
  data->notes = plan->warnings;
  if (!plan->chosen.empty()) data->notes.push_back("Chosen: " + plan->chosen + ".");
  return data;
}

[[noreturn]] void fail(const ident::Scene& scene, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = scene.file.string(),
                    .place = "[noise]",
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

/// The model of [noise], or of a hammer test when every set says how coherent it is.
frf::NoiseModel noise_of(const ident::Scene& scene, const Sources& substructures, const Sources& assembly) {
  if (scene.noise) {
    if (scene.noise->model == "modal") {
      fail(scene, "model \"modal\" needs the modes of the structures, which FRF files do not hold",
           "use uniform, gaussian, circular or hammer");
    }
    return scene.noise->frf_model;
  }
  for (const Sources* sources : {&substructures, &assembly}) {
    for (const auto& source : *sources) {
      const frf::FrfHeader& header = source->header();
      if (models::is_model(header) || (header.noise == frf::NoiseRecord::coherence && header.averages >= 2.0)) continue;
      fail(scene, "it is missing, and " + header.file + " has no coherence with its number of averages",
           "add [noise] with model and level, or give variances and covariances in all files (`jointid frf`)");
    }
  }
  return {.kind = frf::NoiseKind::hammer};
}

SystematicNoise systematic_of(const ident::Scene& scene) {
  return scene.noise ? SystematicNoise{scene.noise->gain_errors, scene.noise->mass_errors} : SystematicNoise{};
}

/// What a mass does is known from the driving point.
void require_driving_points(const ident::Scene& scene, const Excerpts& excerpts) {
  for (const auto* sets : {&excerpts.substructures, &excerpts.assembly}) {
    for (const frf::Excerpt& excerpt : *sets) {
      const std::string dof = models::is_model(excerpt.set.header) ? "" : without_driving_point(excerpt.set.header);
      if (dof.empty()) continue;
      fail(scene, "mass_errors need the driving point of every response, and " + excerpt.set.header.file + " lacks that of " + dof,
           "use files with it, or leave mass_errors out");
    }
  }
}

/// With covariances in a file, and variances in all, trials draw their errors from these.
bool draws_from_files(const ident::Scene& scene, const Sources& substructures, const Sources& assembly) {
  if (scene.noise && !ident::has_virtual_points(scene)) return false;
  bool any = false;
  for (const Sources* sources : {&substructures, &assembly}) {
    for (const auto& source : *sources) {
      if (source->header().noise != frf::NoiseRecord::variance) return false;
      any = any || source->has_covariance();
    }
  }
  return any;
}

/// Sources that refer to sets which outlive them.
Sources refer_to(const std::vector<frf::FrfSet>& sets) {
  Sources sources;
  for (const frf::FrfSet& set : sets) {
    sources.push_back(frf::from_shared(std::shared_ptr<const frf::FrfSet>(std::shared_ptr<void>(), &set)));
  }
  return sources;
}

/// What the files say of their own noise is of no use where [noise] is there.
std::string unused_noise(const ident::Scene& scene, const Sources& substructures, const Sources& assembly) {
  std::string files;
  for (const Sources* sources : {&substructures, &assembly}) {
    for (const auto& source : *sources) {
      const frf::NoiseRecord record = source->header().noise;
      const bool hammer = scene.noise && scene.noise->frf_model.kind == frf::NoiseKind::hammer;  // takes the coherences of the files
      const bool used = models::is_model(source->header()) || (record == frf::NoiseRecord::coherence && hammer);
      if (used || record == frf::NoiseRecord::none) continue;
      files += (files.empty() ? "" : ", ") + source->header().file;
    }
  }
  if (!scene.noise || files.empty()) return {};
  return "Trials draw their errors from [noise] (" + scene.noise->model + "): the variances or coherences of " + files + " are not used.";
}

std::shared_ptr<TrialData> prepare(const ident::Scene& scene, Sources substructures, Sources assembly, frf::NoiseModel noise) {
  frf::validate(noise);
  const SystematicNoise systematic = systematic_of(scene);
  const bool drawn_apart = systematic.any() && noise.reciprocal && noise.kind != frf::NoiseKind::hammer;
  if (systematic.any()) noise.reciprocal = false;
  const bool all_dofs = noise.position_errors > 0.0 || systematic.mass > 0.0 || scene.data.regenerate.any();
  const auto data = prepare(scene, std::move(substructures), std::move(assembly), all_dofs, false, [&](const Excerpts& excerpts) {
    if (systematic.mass > 0.0) require_driving_points(scene, excerpts);
    return pollution_of(excerpts, noise, systematic);
  });
  declare_noise(noise, *data);
  declare_regeneration(*data);
  if (drawn_apart) {
    data->notes.push_back(
        "With errors of gains or masses the two FRFs of a reciprocal pair are separate "
        "measurements: each gets its own noise.");
  }
  return data;
}

/// With the noise of [noise], or that which the sets record.
std::shared_ptr<const TrialData> prepare(const ident::Scene& scene, Sources substructures, Sources assembly) {
  if (draws_from_files(scene, substructures, assembly)) {
    const auto data = prepare(scene, std::move(substructures), std::move(assembly), scene.data.regenerate.any(), true, recorded_pollution);
    declare_regeneration(*data);
    data->notes.push_back("Trials draw their errors from the variances and covariances of the files.");
    return data;
  }
  const frf::NoiseModel noise = noise_of(scene, substructures, assembly);
  const std::string unused = unused_noise(scene, substructures, assembly);
  const auto data = prepare(scene, std::move(substructures), std::move(assembly), noise);
  if (!unused.empty()) data->notes.push_back(unused);
  return data;
}

}  // namespace

std::shared_ptr<const TrialData> load_trial_data(const ident::Scene& scene) {
  if (systematic_of(scene).any() && ident::has_virtual_points(scene)) {
    fail(scene, "gain_errors and mass_errors are not drawn for sensors of virtual points",
         "remove them, or [[virtual_points]]");
  }
  ident::OpenedScene opened = open_scene(scene);
  return prepare(scene, std::move(opened.substructures), std::move(opened.assembly));
}

std::shared_ptr<const TrialData> make_trial_data(const ident::Scene& scene, const Measurements& base) {
  return prepare(scene, refer_to(base.substructures), refer_to(base.assembly));
}

std::shared_ptr<const TrialData> make_trial_data(const ident::Scene& scene, const Measurements& base, Pollution pollution) {
  auto data = prepare(scene, refer_to(base.substructures), refer_to(base.assembly), scene.data.regenerate.any(), true,
                      [&](const Excerpts&) { return std::move(pollution); });
  declare_regeneration(*data);
  return data;
}

std::shared_ptr<const TrialData> make_trial_data(const ident::Scene& scene, const Measurements& base, const frf::NoiseModel& noise) {
  return prepare(scene, refer_to(base.substructures), refer_to(base.assembly), noise);
}

}  // namespace jointid::study
