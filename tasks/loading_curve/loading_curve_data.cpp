#include "tasks/loading_curve/loading_curve_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "frf/file/columns.hpp"
#include "frf/file/table_remarks.hpp"
#include "frf/set/unit_label.hpp"
#include "friction/path/loops.hpp"
#include "records/file/stated_unit.hpp"
#include "records/file/time_title.hpp"

namespace jointid::tasks {
namespace {

using friction::Curve;
using friction::CurveKind;
using friction::Record;

/// A column by what was given, or by the words of its name.
struct Wanted {
  const char* option;
  const char* what;
  const std::string& given;
  std::vector<std::string_view> words, without = {};
};

const frf::NumberColumn& chosen(const frf::Columns& columns, const Wanted& wanted) {
  if (!wanted.given.empty()) return columns.column(wanted.given);
  if (const frf::NumberColumn* found = columns.find(wanted.words, wanted.without)) return columns.column(found->name);
  throw InputError({ErrorKind::data, columns.file, "", fmt::format("no column is named as {}", wanted.what),
                    fmt::format("name it with {}; the columns are {}", wanted.option, columns.names())});
}

/// One column is not two quantities.
void require_different(const frf::Columns& columns, const frf::NumberColumn& one, const char* of_one,
                       const frf::NumberColumn& other, const char* of_other) {
  if (&one != &other) return;
  throw InputError({ErrorKind::data, columns.file, "column " + one.name, fmt::format("is {} and {} at once", of_one, of_other),
                    "name a column for each; the columns are " + columns.names()});
}

/// Exponents that a unit must have.
struct Dimension {
  int length, time, force;
};

struct UnitOption {
  const char* option;
  const std::string& given;
  const char* examples;
};

[[noreturn]] void refuse_unread(const frf::Columns& columns, const frf::NumberColumn& column, const frf::UnreadUnit& unread,
                                const UnitOption& unit) {
  throw InputError({ErrorKind::data, columns.file, "column " + column.name,
                    fmt::format("states no unit, and {} states '{}'", unread.place, frf::shown_label(unread.unit)),
                    fmt::format("write the unit into the title, or give it: {}, e.g. {}", unit.option, unit.examples)});
}

/// The values in SI units: of the unit that the column states, or of the one that is given, which must not contradict it.
std::vector<double> si_values(const frf::Columns& columns, const frf::NumberColumn& column, const UnitOption& unit,
                              const std::vector<Dimension>& allowed) {
  std::vector<double> values = column.values;
  const bool is_time = allowed.front().time == 1;
  const std::string stated = is_time ? records::stated_time_unit(column) : column.unit,
                    label = unit.given.empty() ? stated : unit.given;
  const auto is_allowed = [&](const frf::Unit& of) {
    return std::ranges::any_of(
        allowed, [&](const Dimension& d) { return of.length == d.length && of.time == d.time && of.force == d.force; });
  };
  if (!is_time && frf::states_no_unit(stated)) {
    if (const auto sensor = frf::unapplied_sensitivity(columns)) refuse_unread(columns, column, *sensor, unit);
  }
  if (frf::states_no_unit(label)) {
    if (const auto unread = frf::unread_unit(columns, is_allowed)) refuse_unread(columns, column, *unread, unit);
    return values;
  }
  const auto parsed = frf::parse_unit(label);
  if (!parsed || !is_allowed(*parsed)) {
    const std::string hint = frf::unit_hint(label);
    throw InputError({unit.given.empty() ? ErrorKind::data : ErrorKind::usage, unit.given.empty() ? columns.file : "",
                      unit.given.empty() ? "column " + column.name : unit.option,
                      "'" + frf::shown_label(label) + "' is no unit of it" + (hint.empty() ? "" : " (" + hint + ")"),
                      fmt::format("give {}, e.g. {}", unit.option, unit.examples)});
  }
  if (!unit.given.empty()) records::require_agreement(stated, {unit.given}, columns.file, "column " + column.name);
  for (double& value : values) value *= parsed->si;
  return values;
}

/// Throws InputError for a number that is no measured displacement or force.
void require_measurable(const frf::Columns& columns, const frf::NumberColumn& column, const std::vector<double>& values) {
  constexpr double most = 1e30;
  const auto found = std::ranges::find_if(values, [](double value) { return std::isfinite(value) && std::abs(value) > most; });
  if (found == values.end()) return;
  throw InputError({ErrorKind::data, columns.file, "column " + column.name,
                    fmt::format("sample {} is {:g}, above 1e30", found - values.begin() + 1, *found),
                    "correct it, or leave its cell empty"});
}

/// Turns what the library throws about data into an error that names the file.
template <class Act>
auto of_file(const std::string& file, Act&& act) {
  try {
    return act();
  } catch (const InputError& error) {
    if (!error.parts().file.empty()) throw;
    throw InputError({ErrorKind::data, file, "", error.parts().problem, "check the columns, their units and their signs"});
  }
}

const std::vector<Dimension> motion = {{1, 0, 0}, {0, 0, 0}}, rate = {{1, -1, 0}, {0, -1, 0}}, load = {{0, 0, 1}, {1, 0, 1}};

class Reader {
 public:
  explicit Reader(const LoadingCurveTask& task) : task_(task) {}

  LoadingCurveData read() {
    for (std::size_t i = 0; i < task_.files.size(); ++i) {
      const std::size_t before = out_.curves.size();
      add(task_.files[i]);
      for (std::size_t c = before; c < out_.curves.size(); ++c) finish(out_.curves[c], i);
    }
    return std::move(out_);
  }

 private:
  void add(const std::filesystem::path& path) {
    const frf::Columns columns = frf::read_columns(path);
    const std::string name = path.stem().string();
    if (!task_.energy.empty() || !task_.stiffness.empty()) {
      out_.curves.push_back(series(columns, name));
      return;
    }
    Record record = directed(record_of(columns), path.filename().string());
    if (task_.specimen_stiffness) record = friction::without_elastic(std::move(record), *task_.specimen_stiffness);
    if (!task_.specimen.empty()) record = without_specimen(std::move(record));
    add_record(record, path, name);
  }

  const frf::NumberColumn& displacement_column(const frf::Columns& columns) const {
    const Wanted wanted{"--displacement",
                        "a displacement",
                        task_.displacement,
                        {"displacement", "disp", "position", "pos", "deformation", "angle", "rotation", "amplitude", "u", "x",
                         "extension", "stroke", "slip", "weg", "standardweg", "verschiebung", "spostamento", "desplazamiento"}};
    return chosen(columns, wanted);
  }

  const frf::NumberColumn& velocity_column(const frf::Columns& columns) const {
    return chosen(columns, {"--displacement", "a velocity", task_.displacement, {"velocity", "vel", "speed", "v"}});
  }

  const frf::NumberColumn& time_column(const frf::Columns& columns) const {
    const frf::NumberColumn* found = task_.time.empty() ? records::find_times(columns) : nullptr;
    return found != nullptr ? columns.column(found->name) : chosen(columns, {"--time", "a time", task_.time, {"time", "t"}});
  }

  std::vector<double> displacement(const frf::Columns& columns) const {
    return si_values(columns, displacement_column(columns), {"--unit", task_.unit, "mm"}, motion);
  }

  std::vector<double> integrated_velocity(const frf::Columns& columns) const {
    const frf::NumberColumn &velocity = velocity_column(columns), &time = time_column(columns);
    require_different(columns, velocity, "velocity", time, "time");
    const auto v = si_values(columns, velocity, {"--unit", task_.unit, "mm/s"}, rate);
    const auto t = si_values(columns, time, {"--time-unit", task_.time_unit, "ms"}, {{0, 1, 0}});
    return of_file(columns.file, [&] { return friction::integrated(t, v); });
  }

  Record record_of(const frf::Columns& columns) const {
    const frf::NumberColumn& motions = task_.velocity ? velocity_column(columns) : displacement_column(columns);
    const Wanted force{
        "--force",
        "a force",
        task_.force,
        {"force", "friction", "tangential", "torque", "moment", "f", "load", "kraft", "standardkraft", "forza", "fuerza"},
        {"normal", "normalkraft"}};
    const frf::NumberColumn& forces = chosen(columns, force);
    require_different(columns, motions, "displacement", forces, "force");
    if (task_.velocity) require_different(columns, time_column(columns), "time", forces, "force");
    Record record{task_.velocity ? integrated_velocity(columns) : displacement(columns),
                  si_values(columns, forces, {"--force-unit", task_.force_unit, "uN"}, load)};
    require_measurable(columns, forces, record.force);
    require_measurable(columns, motions, record.displacement);
    if (record.displacement.size() != record.force.size()) {
      throw InputError({ErrorKind::data, columns.file, "",
                        fmt::format("{} displacements and {} forces", record.displacement.size(), record.force.size()),
                        "choose columns of one length"});
    }
    return friction::finite_samples(record);
  }

  Record directed(Record record, const std::string& file) {
    const bool turn = task_.sign == "-1" || (task_.sign == "auto" && friction::work(record) < 0.0);
    if (!turn) return record;
    out_.notes.push_back(file + ": forces times -1" + (task_.sign == "auto" ? ", as the joint would give energy otherwise" : ""));
    return friction::with_force_times(std::move(record), -1.0);
  }

  Record without_specimen(Record record) const {
    const frf::Columns columns = frf::read_columns(task_.specimen);
    return of_file(columns.file, [&] { return friction::without_elastic(std::move(record), record_of(columns)); });
  }

  void add_record(const Record& record, const std::filesystem::path& path, const std::string& name) {
    std::vector<friction::Loop> loops;
    if (task_.kind != "loading" && !record.displacement.empty()) {
      const auto [low, high] = std::ranges::minmax(record.displacement);
      loops = friction::loops(record, 0.5 * (high - low));
    }
    if (loops.empty() && task_.kind == "loops") {
      throw InputError({ErrorKind::data, path.string(), "", "holds no whole cycle between reversals over half the stroke",
                        "check the displacement column, or fit it with --kind loading"});
    }
    if (loops.empty()) {
      note_start(record, path.filename().string());
      out_.curves.push_back(friction::loading_curve(name, record));
      return;
    }
    out_.loops = true;
    out_.notes.push_back(fmt::format("{}: {} loops, each about its centre", path.filename().string(), loops.size()));
    for (std::size_t i = 0; i < loops.size(); ++i) {
      const std::string number = task_.files.size() == 1 ? fmt::format("loop {}", i + 1) : fmt::format("{} loop {}", name, i + 1);
      out_.curves.push_back(friction::loop_curve(number, friction::centred(loops[i])));
    }
  }

  /// A loading curve is one from rest, at 0 and 0.
  void note_start(const Record& record, const std::string& file) {
    constexpr double far = 0.2;
    if (record.displacement.empty()) return;
    const auto [low, high] = std::ranges::minmax(record.displacement);
    const double nearest = std::ranges::min(record.displacement, {}, [](double u) { return std::abs(u); });
    if (std::abs(nearest) > far * (high - low))
      out_.notes.push_back(
          fmt::format("{}: the displacements go from {:g} to {:g} m. A loading curve begins at rest, at 0: take the "
                      "offset out of displacements and forces",
                      file, low, high));
  }

  Curve series(const frf::Columns& columns, const std::string& name) const {
    Curve curve;
    curve.name = name;
    curve.u = displacement(columns);
    const auto named = [&](const std::string& column, const std::vector<Dimension>& allowed, const std::string& unit) {
      require_different(columns, displacement_column(columns), "amplitude", columns.column(column), "a quantity over it");
      return si_values(columns, columns.column(column), {"--force-unit", unit, "N/mm"}, allowed);
    };
    if (!task_.energy.empty()) {
      curve.kind = CurveKind::energy;
      curve.value = named(task_.energy, {{1, 0, 1}}, "");
    } else {
      curve.kind = CurveKind::equivalent;
      require_different(columns, columns.column(task_.stiffness), "stiffness", columns.column(task_.damping), "damping");
      curve.value = named(task_.stiffness, {{-1, 0, 1}, {1, 0, 1}}, task_.force_unit);
      curve.damping = named(task_.damping, {{-1, 0, 1}, {1, 0, 1}}, task_.force_unit);
    }
    return curve;
  }

  void finish(Curve& curve, std::size_t file) const {
    const auto& loads = task_.normal_loads;
    if (!loads.empty()) curve.normal_load = loads.size() == 1 ? loads[0] : loads[file];
    if (!task_.ring.empty()) {
      curve.displacement_unit = "rad";
      curve.force_unit = "N·m";
    }
    of_file(task_.files[file].string(), [&] { friction::validate(curve); });
  }

  const LoadingCurveTask& task_;
  LoadingCurveData out_;
};

}  // namespace

LoadingCurveData read_curves(const LoadingCurveTask& task) { return Reader(task).read(); }

}  // namespace jointid::tasks
