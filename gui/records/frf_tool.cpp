#include "gui/records/frf_tool.hpp"

#include "base/error.hpp"
#include "frf/file/write.hpp"
#include "gui/look/said.hpp"
#include "gui/records/tool_values.hpp"
#include "gui/work/control_of.hpp"
#include "report/frf/frf_page.hpp"
#include "report/frf/frf_plots.hpp"
#include "report/frf/frf_text.hpp"
#include "tasks/frf/run_frf.hpp"

namespace jointid::gui {
namespace {

using Kind = ToolField::Kind;

constexpr std::size_t most_frfs_drawn = 64, most_points_drawn = 4000;

void read_channels(const ToolValues& values, tasks::FrfTask& task) {
  task.read.time = option_text(values, "--time");
  task.read.rate_hz = positive_of(values, "--rate");
  if (const auto channels = values.find("--channel"); channels != values.end()) {
    for (const QString& each : parted(channels->second)) task.read.channels.push_back(records::parse_channel(each.toStdString()));
  }
  if (const auto dofs = values.find("--reference"); dofs != values.end()) {
    for (const QString& each : dofs->second.split(QLatin1Char(',')))
      task.references.push_back(frf::Dof::parse(each.trimmed().toStdString()));
  }
}

tasks::FrfTask task_of(const std::vector<std::filesystem::path>& files, const ToolValues& values) {
  tasks::FrfTask task;
  task.files = files;
  read_channels(values, task);
  task.shaker = values.contains("--shaker");
  task.block_s = positive_of(values, "--block");
  records::FrfOptions& options = task.options;
  options.hammer.pretrigger_s = number_of(values, "--pretrigger").value_or(options.hammer.pretrigger_s);
  options.hammer.trigger = number_of(values, "--trigger").value_or(options.hammer.trigger);
  options.hammer.second_peak = number_of(values, "--second-blow").value_or(options.hammer.second_peak);
  options.force_window_s = positive_of(values, "--force-window");
  options.decay_time_s = positive_of(values, "--exponential");
  task.segments.overlap = number_of(values, "--overlap").value_or(task.segments.overlap);
  options.remove_mean = values.contains("--remove-mean");
  options.keep_faulty = values.contains("--keep-faulty");
  options.highest_hz = positive_of(values, "--highest").value_or(options.highest_hz);
  if (const std::string word = option_text(values, "--estimator"); !word.empty()) options.estimator = records::parse_estimator(word);
  for (const double number : numbers_of(values, "--reject")) {
    if (!(number >= 1.0)) throw InputError({ErrorKind::usage, "", "--reject", "is no number of a segment", "write 2,5"});
    options.reject.push_back(static_cast<std::size_t>(number));
  }
  return task;
}

/// As run_frf() reads them, for their traces.
std::vector<records::Record> records_of(const tasks::FrfTask& task) {
  std::vector<records::Record> out;
  for (const auto& file : task.files) {
    for (records::Record& record : records::read_records(file, task.read)) out.push_back(std::move(record));
  }
  return out;
}

QString summary(const tasks::FrfRun& run) {
  std::size_t left_out = 0;
  for (const records::Blow& blow : run.made.blows) left_out += blow.rejected.empty() ? 0U : 1U;
  const std::size_t all = run.made.blows.size();
  QStringList lines{q(report::estimate_text(run)) + Said::tr("; %1 of %2 segments averaged").arg(all - left_out).arg(all)};
  for (const std::string& note : report::notes(run)) lines << q(note);
  return lines.join(QLatin1Char('\n'));
}

Findings find_frfs(const std::vector<std::filesystem::path>& files, const ToolValues& values, const Worker::Watch& watch) {
  const tasks::FrfTask task = task_of(files, values);
  const auto run = std::make_shared<const tasks::FrfRun>(tasks::run_frf(task, control_of(watch)));
  Findings out;
  out.said = summary(*run);
  out.plots = {{Said::tr("FRF and coherence"), report::frf_plots(*run, most_frfs_drawn, most_points_drawn)},
               {Said::tr("record and windows"), report::trace_plots(*run, records_of(task), most_points_drawn)}};
  out.tables = {{Said::tr("segments"), rows_of(report::stretches_table(*run))},
                {Said::tr("coherences"), rows_of(report::coherence_table(*run))},
                {Said::tr("averages"), rows_of(report::averages_table(*run))}};
  out.outputs = {{"html", [run] { return report::frf_page(*run); }},
                 {"json", [run] { return report::frf_json(*run, {}); }},
                 {"csv", [run] { return report::stretches_csv(*run); }}};
  out.write_frfs = [run](const std::filesystem::path& file) { frf::write(run->made.set, file); };
  return out;
}

std::vector<ToolField> fields_of_channels() {
  return {{Kind::texts, "--channel", QStringLiteral("hammer=1:+Z N; a=4:+Z m/s^2"),
           Said::tr("Channels: COLUMN=DOF UNIT, parted by semicolons. Empty: as a universal file states them")},
          {Kind::number, "--reference", Said::tr("force at"), Said::tr("DOF of the force, or one for each file, parted by commas")},
          {Kind::column, "--time", Said::tr("time"), Said::tr("Column of the times, if its title does not state them")},
          {Kind::number, "--rate", Said::tr("samples per second"), Said::tr("Samples per second, if the file does not state them")}};
}

std::vector<ToolField> fields_of_segments() {
  return {{Kind::number, "--block", Said::tr("segment in s"), Said::tr("Length of a segment, s. Empty: each whole file is one impact")},
          {Kind::number, "--pretrigger", Said::tr("pretrigger in s"), Said::tr("Time before the trigger that belongs to the segment, s")},
          {Kind::number, "--trigger", Said::tr("trigger: 0.1"), Said::tr("An impact begins at this share of the largest force")},
          {Kind::number, "--second-blow", Said::tr("double impact: 0.1"),
           Said::tr("A force above this share of the peak is a double impact")},
          {Kind::number, "--force-window", Said::tr("force window in s"), Said::tr("Seconds after its peak for which the force counts")},
          {Kind::number, "--exponential", Said::tr("exponential in s"),
           Said::tr("Time constant of an exponential window, s. The damping that it adds is taken out again")},
          {Kind::number, "--reject", Said::tr("leave out: 2,5"), Said::tr("Segments to leave out, by their number in the table")},
          {Kind::flag, "--keep-faulty", Said::tr("keep faulty"), Said::tr("Also average overloads and double impacts")},
          {Kind::flag, "--shaker", Said::tr("shaker"), Said::tr("Segments of a long record in place of impacts")},
          {Kind::number, "--overlap", Said::tr("overlap: 0.5"), Said::tr("Share by which the segments of a shaker overlap")},
          {Kind::flag, "--remove-mean", Said::tr("remove the mean"), Said::tr("Subtract the mean of every segment")},
          {Kind::number, "--estimator", QStringLiteral("H1, H2, Hv"), Said::tr("Estimator: H1, H2 or Hv")},
          {Kind::number, "--highest", Said::tr("highest line in Hz"), Said::tr("Highest line of the FRFs, Hz")}};
}

}  // namespace

RecordTool frf_tool() {
  RecordTool tool;
  tool.name = "frf";
  tool.title = Said::tr("FRFs of impacts or a shaker");
  tool.command = QStringLiteral("jointid frf");
  tool.plot_hint = Said::tr("This page shows FRFs with coherence, the records with their windows, and why segments are left out. After "
                            "the first run it follows what you set. “To the scene…” writes the FRFs and names them in [data].");
  tool.takes_several = true;
  tool.fields = fields_of_channels();
  const std::vector<ToolField> segments = fields_of_segments();
  tool.fields.insert(tool.fields.end(), segments.begin(), segments.end());
  tool.run = find_frfs;
  tool.runs_again = true;
  return tool;
}

}  // namespace jointid::gui
