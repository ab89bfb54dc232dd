#include "tasks/study/run_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "frf/hdf5/record_journal.hpp"
#include "scene/kind.hpp"
#include "study/study_records.hpp"

namespace jointid::tasks {

std::map<std::string, std::string> study_texts(const std::string& scene_text) {
  const std::string contents = scene::contents_of(scene_text, "scene");
  return {{"scene_hash", fmt::format("{:016x}", frf::checksum(std::as_bytes(std::span(contents))))},
          {"jointid_version", JOINTID_VERSION}};
}

StudyResult run_study(const std::shared_ptr<const study::TrialData>& data, const study::StudyOptions& options,
                      const study::StudyControl& control) {
  const auto team = ident::make_team_of_one();
  return tasks::run_study(data, options, *team, control);
}

StudyResult run_study(const std::shared_ptr<const study::TrialData>& data, const study::StudyOptions& options, ident::Team& team,
                      const study::StudyControl& control) {
  StudyResult result{data->scene.title, options.out.string(), options.seed, study::run_study(data, options, team, control), {},
                     data->notes};
  if (const auto& [number, count] = options.part; count > 1) {
    result.notes.push_back(fmt::format("part {} of {}: {} of {} trials; `jointid study --merge` puts all parts together", number, count,
                                       result.run.done, options.trials));
  }
  if (team.rank() == 0 && result.run.complete) result.statistics = study::study_statistics(options.out);
  return result;
}

StudyResult merge_study(const std::vector<ident::Path>& files, const ident::Path& out, const std::string& scene_text) {
  study::MergedStudy merged = study::merge_parts(files, out);
  if (!scene_text.empty() && study_texts(scene_text).at("scene_hash") != merged.scene_hash) {
    throw InputError({ErrorKind::usage, files.front().string(), "--merge", "its study is of another scene",
                      "give the scene that the parts were run with"});
  }
  StudyResult result{std::move(merged.title), out.string(), merged.seed, {}, study::study_statistics(out), std::move(merged.notes)};
  result.run.complete = true;
  result.run.done = merged.trials;
  return result;
}

std::string study_doubt(const study::StudyStatistics& statistics) {
  std::string text;
  for (const study::QualityStatistics& matrix : statistics.quality) {
    if (!(matrix.rms_over_trials > 1.0)) continue;
    std::string name = matrix.matrix;
    std::ranges::replace(name, '_', ' ');
    text += (text.empty() ? "" : "; ") + name +
            fmt::format(" is off by {:.0f} % rms over the trials", 100.0 * matrix.rms_over_trials);
  }
  if (!text.empty()) return text + ": one solution does not determine it";
  const auto scatters = [](const study::UnknownStatistics& unknown) { return unknown.std_deviation > std::abs(unknown.mean); };
  const auto count = static_cast<std::size_t>(std::ranges::count_if(statistics.unknowns, scatters));
  if (2 * count <= statistics.unknowns.size()) return "";
  return fmt::format("{} of {} unknowns scatter by more than their mean: one solution does not determine them", count,
                     statistics.unknowns.size());
}

}  // namespace jointid::tasks
