#include "gui/records/record_tools.hpp"

#include <optional>

#include "base/error.hpp"
#include "gui/look/paths.hpp"
#include "gui/look/said.hpp"
#include "gui/records/frf_tool.hpp"
#include "gui/records/tool_values.hpp"
#include "gui/work/control_of.hpp"
#include "report/pod/pod_page.hpp"
#include "report/pod/pod_plots.hpp"
#include "report/pod/pod_report.hpp"
#include "report/series/align_report.hpp"
#include "report/series/contact_report.hpp"
#include "report/series/delay_report.hpp"
#include "report/series/strain_report.hpp"
#include "tasks/pod/run_pod.hpp"

namespace jointid::gui {
namespace {

using Kind = ToolField::Kind;
using Files = std::vector<std::filesystem::path>;

std::vector<std::string> columns_of(const ToolValues& values, const char* option) {
  std::vector<std::string> out;
  const auto place = values.find(option);
  if (place == values.end()) return out;
  for (const QString& column : place->second.split(',')) out.push_back(column.toStdString());
  return out;
}

/// Throws InputError where none is chosen.
std::string chosen_column(const ToolValues& values, const char* option) {
  std::string column = option_text(values, option);
  if (column.empty()) throw InputError({ErrorKind::usage, "", option, "is not chosen", "choose the column"});
  return column;
}

/// Throws InputError where it is not given, with what to do.
double required(std::optional<double> value, const char* option, const char* remedy) {
  if (!value) throw InputError({ErrorKind::usage, "", option, "is not given", remedy});
  return *value;
}

QString said(const std::string& summary, const std::vector<std::string>& remarks) {
  QStringList lines{q(summary)};
  for (const std::string& remark : remarks) lines << q(remark);
  return lines.join('\n');
}

Findings find_modes(const Files& files, const ToolValues& values, const Worker::Watch& watch) {
  tasks::PodTask task;
  task.files = files;
  task.channels = columns_of(values, "--channels");
  task.mass = option_text(values, "--mass"), task.stiffness = option_text(values, "--stiffness"),
  task.compare = option_text(values, "--compare");
  task.keep_mean = values.contains("--keep-mean");
  const auto found = std::make_shared<const tasks::PodResult>(tasks::run_pod(task, control_of(watch)));
  Findings out;
  const std::vector<std::string> remarks = report::pod_remarks(*found);
  out.said = said(report::pod_summary(*found), remarks);
  out.plots = {{Said::tr("modes"), report::pod_shape_plots(found->pod)},
               {Said::tr("values"), report::pod_value_plots(found->pod)}};
  out.tables = {{Said::tr("values"), rows_of(report::pod_values_table(found->pod))},
                {Said::tr("modes"), rows_of(report::pod_shapes_table(*found))}};
  if (found->cosines.size() > 0)
    out.tables.emplace_back(Said::tr("comparison with other modes"), rows_of(report::pod_comparison_table(*found)));
  out.tables.emplace_back(Said::tr("remarks"), remark_rows(remarks));
  out.outputs = {{"html", [found] { return report::pod_page(*found); }},
                 {"json", [found] { return report::pod_json(*found); }},
                 {"csv", [found] { return report::pod_csv(*found); }}};
  return out;
}

Findings find_delays(const Files& files, const ToolValues& values, const Worker::Watch& watch) {
  tasks::DelayTask task;
  task.file = files.front();
  task.channel = option_text(values, "--channel");
  task.rate_hz = positive_of(values, "--rate");
  task.samples = whole_of(values, "--samples", task.samples, 100, 200'000);
  task.delay = whole_of(values, "--delay", task.delay, 0, 100'000);
  task.dimension = whole_of(values, "--dimension", task.dimension, 0, 20);
  task.theiler = whole_of(values, "--theiler", task.theiler, 0, 100'000);
  const auto found = std::make_shared<const tasks::DelayResult>(tasks::run_delay(task, control_of(watch)));
  Findings out;
  out.said = said(report::delay_summary(*found), found->remarks);
  out.plots = {{Said::tr("delay and dimension"), report::delay_plots(*found)},
               {Said::tr("divergence"), report::divergence_plots(*found)}};
  out.tables = {{Said::tr("results"), rows_of(report::answers_table(*found))},
                {Said::tr("false nearest neighbours"), rows_of(report::neighbours_table(*found))},
                {Said::tr("recurrences"), rows_of(report::recurrences_table(*found))},
                {Said::tr("remarks"), remark_rows(found->remarks)}};
  out.outputs = {{"html", [found] { return report::delay_page(*found); }},
                 {"json", [found] { return report::delay_json(*found); }},
                 {"csv", [found] { return report::delay_csv(*found); }}};
  return out;
}

Findings find_contact_law(const Files& files, const ToolValues& values, const Worker::Watch& watch) {
  tasks::ContactTask task;
  task.file = files.front();
  task.velocity = chosen_column(values, "--velocity");
  task.force = chosen_column(values, "--force");
  task.normal = option_text(values, "--normal");
  task.load = positive_of(values, "--load").value_or(0.0);
  task.stick_speed =
      required(positive_of(values, "--stick-speed"), "--stick-speed", "give the speed in m/s below which a sample sticks");
  task.rate_hz = positive_of(values, "--rate");
  task.force_delay = number_of(values, "--force-delay").value_or(0.0);
  const auto found = std::make_shared<const tasks::ContactResult>(tasks::run_contact(task, control_of(watch)));
  Findings out;
  const std::vector<std::string> remarks = report::contact_remarks(*found);
  out.said = said(report::contact_summary(*found), remarks);
  out.plots = {{Said::tr("friction over velocity"), report::contact_law_plots(*found)}};
  out.tables = {{Said::tr("law"), rows_of(report::contact_table(*found))}, {Said::tr("remarks"), remark_rows(remarks)}};
  out.outputs = {{"html", [found] { return report::contact_page(*found); }},
                 {"json", [found] { return report::contact_json(*found); }},
                 {"csv", [found] { return report::contact_csv(*found); }}};
  return out;
}

Findings find_displacements(const Files& files, const ToolValues& values, const Worker::Watch&) {
  tasks::StrainTask task;
  task.file = files.front();
  task.channels = columns_of(values, "--channels");
  task.length = required(positive_of(values, "--length"), "--length", "give the length of the beam in m");
  task.thickness = required(positive_of(values, "--thickness"), "--thickness", "give the thickness of the beam in m");
  task.gauges = numbers_of(values, "--gauges");
  if (task.gauges.empty())
    throw InputError({ErrorKind::usage, "", "--gauges", "is not given", "give the places of the gauges in m from the clamp"});
  task.points = numbers_of(values, "--points");
  task.shapes = whole_of(values, "--shapes", 0, 0, 100);
  task.static_shapes = values.contains("--static-shapes");
  const auto found = std::make_shared<const tasks::StrainResult>(tasks::run_strain(task));
  Findings out;
  const std::vector<std::string> remarks = report::strain_remarks(*found);
  out.said = said(report::strain_summary(*found) + ".", remarks);
  const report::PlotGroup plots = report::strain_plots(*found);
  out.plots = {{Said::tr("displacements"), plots}};
  out.tables = {{Said::tr("points"), rows_of(report::strain_table(*found))}, {Said::tr("remarks"), remark_rows(remarks)}};
  const auto csv = [found] {
    std::string text = report::displacements_title(*found);
    tasks::find_displacements(*found, *tasks::open_gauges(found->task),
                              [&](const Eigen::MatrixXd& block) { text += report::displacements_csv(block); });
    return text;
  };
  out.outputs = {{"html", [found, plots] { return report::strain_page(*found, plots); }},
                 {"json", [found] { return report::strain_json(*found); }},
                 {"csv", csv}};
  return out;
}

Findings find_late_channels(const Files& files, const ToolValues& values, const Worker::Watch& watch) {
  tasks::AlignTask task;
  task.file = files.front();
  task.reference = chosen_column(values, "--reference");
  task.frequency_hz = required(positive_of(values, "--frequency"), "--frequency", "give the frequency of the motion in Hz");
  task.harmonics = whole_of(values, "--harmonics", task.harmonics, 1, 50);
  task.rate_hz = positive_of(values, "--rate");
  const auto found = std::make_shared<const tasks::AlignResult>(tasks::run_align(task, control_of(watch)));
  Findings out;
  const std::vector<std::string> remarks = report::align_remarks(*found);
  out.said = said(report::align_summary(*found), remarks);
  out.plots = {{Said::tr("three periods"), report::align_plots(*found)}};
  out.tables = {{Said::tr("delays"), rows_of(report::delays_table(*found))}, {Said::tr("remarks"), remark_rows(remarks)}};
  out.outputs = {{"html", [found] { return report::align_page(*found); }},
                 {"json", [found] { return report::align_json(*found); }},
                 {"csv", [found] { return report::align_csv(*found); }}};
  return out;
}

RecordTool pod_tool() {
  return {"pod",
          Said::tr("Proper orthogonal modes"),
          QStringLiteral("jointid pod"),
          Said::tr("This page shows the proper orthogonal modes of the channels, with their shares of the mean square. Several "
                   "files count as further samples."),
          true,
          {{Kind::columns, "--channels", Said::tr("channels"), Said::tr("Channels. None chosen: all but the time")},
           {Kind::file, "--mass", Said::tr("mass matrix"),
            Said::tr("File of the mass matrix of the channels, the inner product of the modes")},
           {Kind::file, "--stiffness", Said::tr("stiffness matrix"),
            Said::tr("File of the stiffness matrix. With the mass matrix it gives cosines and MAC with the normal modes")},
           {Kind::file, "--compare", Said::tr("other modes"),
            Said::tr("File of modes: one column per mode, one row per channel. Gives cosines and MAC")},
           {Kind::flag, "--keep-mean", Said::tr("keep the mean"), Said::tr("Do not remove the mean of each channel")}},
          find_modes};
}

RecordTool delay_tool() {
  return {
      "delay",
      Said::tr("Delay and dimension"),
      QStringLiteral("jointid series delay"),
      Said::tr("This page shows mutual information, false nearest neighbours, correlation sum and divergence of one channel."),
      false,
      {{Kind::column, "--channel", Said::tr("channel"), Said::tr("Channel. None chosen: the only one beside the time")},
       {Kind::number, "--rate", Said::tr("samples per second"), Said::tr("Samples per second, if the file does not state them")},
       {Kind::number, "--samples", QStringLiteral("20000"),
        Said::tr("Number of samples from the start. The run time grows with its square")},
       {Kind::number, "--delay", Said::tr("delay"), Said::tr("Delay in samples. Empty: first minimum of the mutual information")},
       {Kind::number, "--dimension", Said::tr("dimension"),
        Said::tr("Dimension. Empty: the smallest with at most 1 % false nearest neighbours")},
       {Kind::number, "--theiler", Said::tr("Theiler window"),
        Said::tr("Smallest distance of neighbours in time, in samples. Empty: twice delay times dimension")}},
      find_delays};
}

RecordTool contact_tool() {
  return {
      "friction",
      Said::tr("Friction of a contact"),
      QStringLiteral("jointid series friction"),
      Said::tr("This page shows the friction coefficient over the relative velocity, and the fitted law."),
      false,
      {{Kind::column, "--velocity", Said::tr("relative velocity"), Said::tr("Column of the relative velocity, m/s")},
       {Kind::column, "--force", Said::tr("friction force"),
        Said::tr("Column of the friction force, N, with the sign of the velocity while it slips")},
       {Kind::column, "--normal", Said::tr("normal load"), Said::tr("Column of the normal load, N, unless it is constant")},
       {Kind::number, "--load", Said::tr("constant load in N"), Said::tr("Constant normal load, N, instead of a column")},
       {Kind::number, "--stick-speed", Said::tr("sticks below m/s"),
        Said::tr("Slower samples count as sticking, m/s. Choose it above the noise of the velocity")},
       {Kind::number, "--force-delay", Said::tr("delay of force in s"),
        Said::tr("Time delay of the force, s; `jointid series align` finds it")},
       {Kind::number, "--rate", Said::tr("samples per second"), Said::tr("Samples per second, if the file does not state them")}},
      find_contact_law};
}

RecordTool strain_tool() {
  return {"strain",
          Said::tr("Displacements from strain gauges"),
          QStringLiteral("jointid series strain"),
          Said::tr("This page shows the displacements of a clamped beam, and their sensitivity to errors of the strains."),
          false,
          {{Kind::columns, "--channels", Said::tr("gauges' channels"),
            Said::tr("Channels of the strain gauges. None chosen: all but the time")},
           {Kind::number, "--length", Said::tr("length in m"), Said::tr("Length of the beam, m")},
           {Kind::number, "--thickness", Said::tr("thickness in m"),
            Said::tr("Thickness of the beam, m. The strain is half of it times the curvature")},
           {Kind::number, "--gauges", Said::tr("gauges at m"),
            Said::tr("Positions of the gauges, m from the clamp, in the order of their channels: 0.05,0.1")},
           {Kind::number, "--points", Said::tr("points at m"), Said::tr("Positions of the displacements, m. Empty: the tip")},
           {Kind::number, "--shapes", Said::tr("shapes"), Said::tr("Number of shapes of the beam. Empty: that of the gauges")},
           {Kind::flag, "--static-shapes", Said::tr("static shapes"),
            Said::tr("Two of the shapes are those of a tip force and a tip moment")}},
          find_displacements};
}

RecordTool align_tool() {
  return {
      "align",
      Said::tr("Time delays of channels"),
      QStringLiteral("jointid series align"),
      Said::tr("This page shows the channels of a periodic record, as measured and without their time delays."),
      false,
      {{Kind::column, "--reference", Said::tr("reference"), Said::tr("Column without a time delay")},
       {Kind::number, "--frequency", Said::tr("frequency in Hz"), Said::tr("Frequency of the motion, Hz")},
       {Kind::number, "--harmonics", Said::tr("harmonics"), Said::tr("Harmonics fitted together. Empty: 3")},
       {Kind::number, "--rate", Said::tr("samples per second"), Said::tr("Samples per second, if the file does not state them")}},
      find_late_channels};
}

}  // namespace

std::vector<RecordTool> record_tools() { return {pod_tool(), delay_tool(), contact_tool(), strain_tool(), align_tool(), frf_tool()}; }

}  // namespace jointid::gui
