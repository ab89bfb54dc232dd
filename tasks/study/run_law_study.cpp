#include "tasks/study/run_law_study.hpp"

#include "laws/task/trial_file.hpp"
#include "scene/kind.hpp"

namespace jointid::tasks {

std::optional<laws::LawStudy> run_law_study(const laws::LawScene& scene, const LawTrialsFile& trials,
                                            laws::LawStudyOptions options, ident::Team& team) {
  laws::AssumedStates assumed;
  std::optional<laws::TrialFile> file;  // of the leader
  ident::start_together(team, [&] {
    assumed = laws::assumed_states(scene);
    if (team.rank() > 0) return;
    const laws::TrialFileKey key{scene::contents_of(trials.scene_text, "scene"), options.seed,
                                 laws::law_study_plan(scene, assumed)};
    file.emplace(trials.path, key, trials.resume);
  });
  if (file) {
    options.known = file->known();
    options.made = [&](const laws::LawTrial& trial) { file->add(trial); };
    if (options.progress) options.progress(file->known().size(), options.trials);
  }
  return laws::study_laws_together(scene, assumed, options, team);
}

laws::LawStudy run_law_study(const laws::LawScene& scene, const LawTrialsFile& trials, laws::LawStudyOptions options) {
  const auto team = ident::make_team_of_one();
  return *tasks::run_law_study(scene, trials, std::move(options), *team);
}

}  // namespace jointid::tasks
