#include "tasks/couple.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>

#include "base/error.hpp"
#include "coupling/assembly_reader.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "ident/plan/data_source.hpp"
#include "tasks/identified_joint.hpp"
#include "tasks/source_doubts.hpp"
#include "weighting/line_selection.hpp"

namespace jointid::tasks {
namespace {

std::vector<coupling::Part> parts_of(const ident::CoupleScene& scene, ident::Sources sources) {
  std::vector<coupling::Part> parts;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    ident::Sources own;
    own.push_back(std::move(sources[i]));
    parts.push_back({scene.names[i], std::make_shared<frf::FrfSystem>(scene.names[i], std::move(own), frf::Composition::merged,
                                                                      scene.reciprocity)});
  }
  return parts;
}

std::vector<coupling::Part> open_parts(const ident::CoupleScene& scene, ident::ModelsInUse& models) {
  return parts_of(scene, std::move(open_systems({scene.parts}, scene.frequency, scene.file, &models).front()));
}

std::vector<coupling::Part> parts_in_memory(const ident::CoupleScene& scene, std::vector<frf::FrfSet> sets) {
  if (sets.size() != scene.names.size()) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = scene.file.string(),
                      .place = "[data] parts",
                      .problem = std::to_string(sets.size()) + " sets for " + std::to_string(scene.names.size()) + " parts",
                      .remedy = "give one for each, in their order"});
  }
  ident::Sources sources;
  for (frf::FrfSet& set : sets) {
    frf::validate(set);
    sources.push_back(frf::from_memory(std::move(set)));
  }
  return parts_of(scene, std::move(sources));
}

std::vector<std::size_t> all(std::size_t count) {
  std::vector<std::size_t> out(count);
  std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

std::vector<std::size_t> choose_lines(const ident::CoupleScene& scene, const std::vector<double>& axis) {
  std::vector<std::size_t> lines = weighting::select_lines(
      axis, {.range_hz = scene.frequency.range_hz, .step_hz = scene.frequency.step_hz, .exclude_hz = scene.frequency.exclude_hz});
  if (!lines.empty()) return lines;
  throw InputError({.kind = ErrorKind::usage,
                    .file = scene.file.string(),
                    .place = "[frequency]",
                    .problem = "the selection leaves no line",
                    .remedy = "the parts have " + frf::range_text(axis)});
}

/// Whom to tell how far it is, and who may stop it.
class Watch {
 public:
  Watch(const ident::Control& control, const char* stage, std::size_t total) : control_(control), stage_(stage), total_(total) {}

  void at(std::size_t done) const {
    stop_if(control_.interrupted);
    if (control_.progress) control_.progress(stage_, done, total_);
  }

 private:
  const ident::Control& control_;
  const char* stage_;
  std::size_t total_;
};

constexpr std::size_t survey_lines = 256, lines_per_pass = 64;

/// The alphas of all conditions on all lines, from a single FRF of the result.
std::vector<coupling::LineRecord> survey(coupling::AssemblyReader& reader, const std::vector<std::size_t>& lines,
                                         const ident::Control& control) {
  const std::vector<std::size_t> one = {0};
  std::vector<coupling::LineRecord> records(lines.size());
  std::vector<Complex> values(std::min(survey_lines, lines.size()));
  const Watch watch(control, "dependencies", lines.size());
  for (std::size_t first = 0; first < lines.size(); first += survey_lines) {
    watch.at(first);
    const std::size_t count = std::min(survey_lines, lines.size() - first);
    reader.read({std::span(lines).subspan(first, count), one, one}, std::span(values).first(count), {},
                std::span(records).subspan(first, count));
  }
  return records;
}

/// Σ|H|² over point FRFs.
class PointLevel {
 public:
  explicit PointLevel(const frf::FrfHeader& header) : entries_(header.entries()) {
    for (std::size_t r = 0; r < header.response.size(); ++r) {
      const std::size_t c = frf::find_coordinate(header.reference, header.response[r]);
      if (c != frf::npos) points_.push_back(r * header.reference.size() + c);
    }
    if (points_.empty()) points_.push_back(0);
  }

  void add(std::span<const Complex> lines) {
    for (std::size_t first = 0; first < lines.size(); first += entries_) {
      double sum = 0.0;
      for (const std::size_t point : points_) sum += std::norm(lines[first + point]);
      level_.push_back(sum);
    }
  }

  const std::vector<double>& values() const { return level_; }

 private:
  std::size_t entries_;
  std::vector<std::size_t> points_;
  std::vector<double> level_;
};

/// Lines of the assembly as they are coupled.
struct CoupledLines {
  std::size_t first = 0, count = 0;
  std::span<const Complex> values, variance, covariance;
};

/// Where they go.
class Sink {
 public:
  virtual ~Sink() = default;
  /// Lines at a time, at least as many as are coupled at a time.
  virtual std::size_t step() const = 0;
  virtual void put(const CoupledLines& lines) = 0;
  virtual void finish() = 0;
};

class FileSink final : public Sink {
 public:
  FileSink(const ident::Path& path, const frf::FrfHeader& header, bool covariance)
      : writer_(path, header, {.covariance = covariance}) {}

  /// Whole chunks.
  std::size_t step() const override {
    const std::size_t chunk = writer_.lines_per_chunk();
    return chunk * ((lines_per_pass + chunk - 1) / chunk);
  }
  void put(const CoupledLines& lines) override {
    writer_.write_lines(lines.first, lines.count, lines.values, lines.variance, {}, {lines.covariance, {}, {}, {}});
  }
  void finish() override { writer_.finish(); }

 private:
  frf::Hdf5Writer writer_;
};

class MemorySink final : public Sink {
 public:
  explicit MemorySink(frf::FrfSet& set) : set_(set) {}

  std::size_t step() const override { return lines_per_pass; }
  void put(const CoupledLines& lines) override {
    set_.values.insert(set_.values.end(), lines.values.begin(), lines.values.end());
    set_.variance.insert(set_.variance.end(), lines.variance.begin(), lines.variance.end());
    set_.covariance.insert(set_.covariance.end(), lines.covariance.begin(), lines.covariance.end());
  }
  void finish() override {}

 private:
  frf::FrfSet& set_;
};

using MakeSink = std::function<std::unique_ptr<Sink>(const frf::FrfHeader& header, bool covariance)>;

CoupledFile write(coupling::AssemblyReader& reader, const std::vector<std::size_t>& lines, const MakeSink& make_sink,
                  const ident::Control& control, std::vector<coupling::LineRecord>& records) {
  frf::FrfHeader header = reader.header();
  header.frequency_hz.clear();
  for (const std::size_t line : lines) header.frequency_hz.push_back(reader.header().frequency_hz[line]);
  const std::vector<std::size_t> responses = all(header.response.size()), references = all(header.reference.size());
  const std::unique_ptr<Sink> sink = make_sink(header, reader.has_covariance());
  PointLevel level(header);
  std::vector<Complex> values, variance, covariance;
  records.resize(lines.size());
  const Watch watch(control, "couple", lines.size());
  const std::size_t step = sink->step();
  for (std::size_t first = 0; first < lines.size(); first += step) {
    watch.at(first);
    const std::size_t count = std::min(step, lines.size() - first);
    const frf::Block block{std::span(lines).subspan(first, count), responses, references};
    values.resize(block.size());
    variance.resize(header.noise == frf::NoiseRecord::variance ? block.size() : 0);
    covariance.resize(reader.has_covariance() ? count * frf::pair_count(responses.size()) * references.size() : 0);
    reader.read(block, values, variance, std::span(records).subspan(first, count), covariance);
    sink->put({first, count, values, variance, covariance});
    level.add(values);
  }
  stop_if(control.interrupted);
  sink->finish();
  const std::vector<bool>& left_out = reader.options().left_out;
  const auto dropped = static_cast<std::size_t>(std::ranges::count(left_out, true));
  return {{}, reader.layout().conditions.size() - dropped, weighting::find_resonances(header.frequency_hz, level.values())};
}

std::vector<std::string> met(const std::vector<std::string>& conditions, const std::vector<bool>& left_out) {
  std::vector<std::string> out;
  for (std::size_t p = 0; p < conditions.size(); ++p) {
    if (left_out.empty() || !left_out[p]) out.push_back(conditions[p]);
  }
  return out;
}

void judge(CoupleResult& out) {
  out.unusable_lines = static_cast<std::size_t>(std::ranges::count(out.records, false, &coupling::LineRecord::usable));
  if (out.unusable_lines == 0) return;
  out.message = out.unusable_lines == out.lines
                    ? "No line is usable"
                    : std::to_string(out.unusable_lines) + " of " + std::to_string(out.lines) + " lines are not usable";
  out.message +=
      ": an FRF of a coupled DOF is missing, or the compatibility conditions are redundant. A `threshold` drops the redundant "
      "ones.";
  if (out.unusable_lines == out.lines) out.status = ident::Status::rank_deficient;
}

/// `with_all`: where the FRFs with all conditions go; empty without bounds.
CoupleResult coupled(const ident::CoupleScene& scene, const std::vector<coupling::Part>& parts, const MakeSink& with_all,
                     const MakeSink& to, const ident::Control& control) {
  CoupleResult result;
  coupling::Options options = scene.options;
  options.threads = control.threads;
  const std::string where = scene.file.string();
  coupling::Assembly assembly = scene.assembly;
  for (const ident::IdentifiedJoint& joint : scene.identified) {
    FoundJoint found = identify_joint(scene, joint, control);
    assembly.joints.push_back(std::move(found.joint));
    result.notes.push_back(std::move(found.note));
  }
  for (const coupling::Part& part : parts) {
    for (std::size_t s = 0; s < part.system->source_count(); ++s) {
      for (const std::string& doubt : source_doubts(part.system->source(s))) result.notes.push_back(part.name + ": " + doubt);
    }
  }
  std::vector<std::size_t> lines;
  if (scene.find_dependent || with_all) {
    coupling::Options mtc;
    mtc.method = coupling::Method::mtc;
    mtc.threads = control.threads;
    coupling::AssemblyReader reader(parts, assembly, mtc, where);
    lines = choose_lines(scene, reader.header().frequency_hz);
    result.survey = survey(reader, lines, control);
    result.dependencies = coupling::find_dependencies(reader.layout().condition_names, result.survey);
  }
  if (with_all) {
    coupling::AssemblyReader reader(parts, assembly, options, where);
    std::vector<coupling::LineRecord> unused;
    result.with_all = write(reader, lines, with_all, control, unused);
  }
  if (result.dependencies) options.left_out = result.dependencies->left_out();
  coupling::AssemblyReader reader(parts, assembly, options, where);
  if (lines.empty()) lines = choose_lines(scene, reader.header().frequency_hz);
  result.lines = lines.size();
  result.lines_without_partner = reader.lines_without_partner();
  result.responses = reader.header().response.size();
  result.references = reader.header().reference.size();
  for (const std::size_t line : lines) result.frequency_hz.push_back(reader.header().frequency_hz[line]);
  result.conditions = met(reader.layout().condition_names, options.left_out);
  result.result = write(reader, lines, to, control, result.records);
  judge(result);
  return result;
}

}  // namespace

ident::Path with_all_path(const ident::Path& out) {
  ident::Path path = out;
  path.replace_extension();
  path += ".all" + out.extension().string();
  return path;
}

CoupleResult couple(const ident::CoupleScene& scene, const ident::Path& out, bool bounds, const ident::Control& control) {
  const auto to_file = [](const ident::Path& path) -> MakeSink {
    return [path](const frf::FrfHeader& header, bool covariance) { return std::make_unique<FileSink>(path, header, covariance); };
  };
  ident::ModelsInUse models;
  CoupleResult result =
      coupled(scene, open_parts(scene, models), bounds ? to_file(with_all_path(out)) : MakeSink(), to_file(out), control);
  for (const ident::ModelInUse& each : models) {
    result.models.push_back(ident::used_models({each}, result.lines, each.dofs).front());
  }
  result.result.path = out;
  if (result.with_all) result.with_all->path = with_all_path(out);
  return result;
}

CoupledSets couple(const ident::CoupleScene& scene, std::vector<frf::FrfSet> parts, bool bounds, const ident::Control& control) {
  CoupledSets out;
  const auto to_memory = [](frf::FrfSet& set) -> MakeSink {
    return [&set](const frf::FrfHeader& header, bool) {
      set.header = header;
      return std::make_unique<MemorySink>(set);
    };
  };
  if (bounds) out.with_all.emplace();
  out.result = coupled(scene, parts_in_memory(scene, std::move(parts)), bounds ? to_memory(*out.with_all) : MakeSink(),
                       to_memory(out.frfs), control);
  return out;
}

}  // namespace jointid::tasks
