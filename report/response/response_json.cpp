#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/complex.hpp"
#include "report/json_value.hpp"
#include "report/response/response_text.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

using response::HarmonicSolution;

Json harmonics_json(const Eigen::MatrixXcd& rows, Eigen::Index column) {
  Json out = Json::array();
  for (Eigen::Index n = 0; n < rows.rows(); ++n) out.push_back({value(rows(n, column).real()), value(rows(n, column).imag())});
  return out;
}

Json point_json(const HarmonicSolution& point, const tasks::ResponseResult& run) {
  Json out = {{"frequency", value(hertz(point.omega))}, {"converged", point.converged}};
  if (!point.converged) return out;
  out["harmonics"] = point.harmonics;
  for (std::size_t i = 0; i < run.dofs.size(); ++i) out["responses"].push_back(harmonics_json(point.response, at(i)));
  for (std::size_t j = 0; j < run.joints.size(); ++j) {
    out["joints"].push_back({{"motion", harmonics_json(point.joint_motion, at(j))},
                             {"force", harmonics_json(point.joint_force, at(j))},
                             {"loss", value(point.loss(at(j)))}});
  }
  out["next_harmonics"] = value(point.next);
  out["newton_steps"] = point.steps;
  for (const response::DroppedHarmonic& dropped : point.dropped) {
    out["dropped"].push_back(
        {{"harmonic", dropped.harmonic}, {"force", value(dropped.force)}, {"motion", value(dropped.motion)}});
  }
  return out;
}

Json stability_json(const tasks::PointStability& stability) {
  Json out = {{"known", stability.known && !stability.another}};
  if (!stability.known) return out;
  out["stable"] = stability.stable;
  out["difference"] = value(stability.difference);
  out["residual_force_free"] = stability.residual_force_free;
  out["multipliers"] = Json::array();
  for (const Complex mu : stability.multipliers) out["multipliers"].push_back({value(mu.real()), value(mu.imag())});
  return out;
}

Json column_json(const Eigen::MatrixXd& rows, Eigen::Index column) {
  Json out = Json::array();
  for (Eigen::Index i = 0; i < rows.rows(); ++i) out.push_back(value(rows(i, column)));
  return out;
}

/// Harmonics as points have them, and the parameter.
Json curve_json(const tasks::CurveRun& curve, const tasks::ResponseResult& run) {
  const auto list = [&](const std::vector<double>& parameters, const std::vector<HarmonicSolution>& points) {
    Json out = Json::array();
    for (std::size_t i = 0; i < points.size(); ++i) {
      Json point = point_json(points[i], run);
      point["parameter"] = value(parameters[i]);
      out.push_back(std::move(point));
    }
    return out;
  };
  const response::ResponseCurve& found = curve.found;
  return {{"along", curve.curve.along},
          {"joint", curve.curve.parameter ? Json(run.joints[curve.curve.parameter->joint]) : Json()},
          {"frequency", value(curve.curve.frequency_hz)},
          {"complete", found.end == response::CurveEnd::reached},
          {"points", list(found.parameters, found.points)},
          {"peaks", list(found.peak_parameters, found.peaks)},
          {"turning_points", list(found.turning_parameters, found.turning_points)}};
}

Json equivalent_json(const tasks::EquivalentRow& row) {
  Json out = {{"amplitude", value(row.amplitude)}};
  for (const response::EquivalentJoint& joint : row.joints) {
    out["joints"].push_back({{"stiffness", value(joint.stiffness)}, {"damping", value(joint.damping)}});
  }
  if (!row.mode) return out;
  out["mode"] = {{"converged", row.mode->converged},
                 {"omega", value(row.mode->omega)},
                 {"loss_factor_joints", value(row.mode->loss_factor_joints)},
                 {"loss_factor_viscous", value(row.mode->loss_factor_viscous)}};
  return out;
}

Json transient_json(const tasks::TransientRun& run) {
  Json out = {{"name", run.name}, {"complete", run.motion.complete}, {"times", run.motion.times}, {"events", run.motion.events}};
  for (Eigen::Index i = 0; i < run.motion.x.cols(); ++i) out["responses"].push_back(column_json(run.motion.x, i));
  for (Eigen::Index j = 0; j < run.motion.q.cols(); ++j) {
    out["joints"].push_back({{"motion", column_json(run.motion.q, j)}, {"force", column_json(run.motion.f, j)}});
  }
  return out;
}

Json clamped_json(const tasks::ClampedPeak& peak) {
  return {{"load", value(peak.load)},
          {"amplitude", value(peak.amplitude)},
          {"frequency", peak.amplitude ? value(peak.frequency_hz) : Json()},
          {"complete", peak.complete}};
}

Json clamping_json(const tasks::ClampingRun& clamping) {
  Json out = {{"force", clamping.level}, {"nominal", value(clamping.nominal)}, {"peaks", Json::array()}, {"best", Json()}};
  for (const tasks::ClampedPeak& peak : clamping.peaks) out["peaks"].push_back(clamped_json(peak));
  if (!clamping.best) return out;
  out["best"] = clamped_json(*clamping.best);
  out["at_end"] = clamping.at_end;
  out["within_tenth"] = {value(clamping.within_tenth[0]), value(clamping.within_tenth[1])};
  return out;
}

}  // namespace

std::string response_json(const tasks::ResponseScene& scene, const tasks::ResponseResult& run) {
  Json out = {{"status", all_converged(run) ? "ok" : "not_converged"},
              {"force_dof", scene.force_dof.name},
              {"dofs", run.dofs},
              {"joints", run.joints},
              {"levels", Json::array()},
              {"doubts", run.doubts}};
  for (const tasks::LevelResponse& level : run.levels) {
    Json one = {{"force", level.level}, {"complete", level.complete}, {"points", Json::array()}};
    for (std::size_t i = 0; i < level.points.size(); ++i) {
      Json point = point_json(level.points[i], run);
      if (!level.deviations.empty() && level.points[i].converged) {
        for (std::size_t dof = 0; dof < run.dofs.size(); ++dof) {
          point["response_deviations"].push_back(harmonics_json(level.deviations[i].parts, at(dof)));
        }
      }
      if (i < level.left_out.size() && level.left_out[i].size() > 0) {
        for (std::size_t dof = 0; dof < run.dofs.size(); ++dof)
          point["left_out"].push_back(column_json(level.left_out[i], at(dof)));
      }
      if (!level.stability.empty()) point["stability"] = stability_json(level.stability[i]);
      one["points"].push_back(std::move(point));
    }
    one["peak"] = level.peak ? point_json(*level.peak, run) : Json();
    one["peak_deviation"] = value(level.peak_deviation);
    one["peak_mode"] = Json();
    if (level.peak_mode)
      one["peak_mode"] = {{"omega", value(level.peak_mode->omega)}, {"damping", value(level.peak_mode->ratio)}};
    one["peak_stability"] = level.peak_stability ? stability_json(*level.peak_stability) : Json();
    one["peak_loops"] = Json::array();
    for (const response::JointLoop& loop : level.loops) {
      one["peak_loops"].push_back({{"motion", column_json(loop.displacement, 0)}, {"force", column_json(loop.force, 0)}});
    }
    one["turning_points"] = Json::array();
    for (const HarmonicSolution& turn : level.turning_points) one["turning_points"].push_back(point_json(turn, run));
    out["levels"].push_back(std::move(one));
  }
  for (const tasks::CurveRun& curve : run.curves) out["curves"].push_back(curve_json(curve, run));
  for (const tasks::EquivalentRow& row : run.equivalents) out["equivalents"].push_back(equivalent_json(row));
  for (const tasks::ClampingRun& clamping : run.clampings) out["clamping"].push_back(clamping_json(clamping));
  for (const tasks::TransientRun& transient : run.transients) out["transients"].push_back(transient_json(transient));
  return json_text(out);
}

std::string history_csv(const tasks::ResponseResult& run) {
  std::vector<std::string> titles = {"motion", "time [s]"};
  for (const std::string& dof : run.dofs) titles.push_back("x(" + dof + ") [m]");
  for (const std::string& joint : run.marched) titles.insert(titles.end(), {"q(" + joint + ") [m]", "f(" + joint + ") [N]"});
  std::string text = csv_line(titles);
  for (const tasks::TransientRun& each : run.transients) {
    const response::Transient& motion = each.motion;
    for (std::size_t i = 0; i < motion.times.size(); ++i) {
      std::vector<std::string> cells = {each.name, csv_number(motion.times[i])};
      for (Eigen::Index x = 0; x < motion.x.cols(); ++x) cells.push_back(csv_number(motion.x(at(i), x)));
      for (Eigen::Index j = 0; j < motion.q.cols(); ++j) {
        cells.insert(cells.end(), {csv_number(motion.q(at(i), j)), csv_number(motion.f(at(i), j))});
      }
      text += csv_line(cells);
    }
  }
  return text;
}

std::string response_csv(const tasks::ResponseResult& run) {
  std::string text = csv_line(
      {"force [N]", "frequency [Hz]", "harmonic", "dof", "re [m]", "im [m]", "std dev re [m]", "std dev im [m]", "left out [m]"});
  for (const tasks::LevelResponse& level : run.levels) {
    for (std::size_t i = 0; i < level.points.size(); ++i) {
      const HarmonicSolution& point = level.points[i];
      if (!point.converged) continue;
      for (Eigen::Index n = 0; n < point.response.rows(); ++n) {
        for (std::size_t dof = 0; dof < run.dofs.size(); ++dof) {
          const Complex x = point.response(n, at(dof));
          std::optional<double> re, im, bar;
          if (i < level.left_out.size() && level.left_out[i].size() > 0) bar = level.left_out[i](n, at(dof));
          if (!level.deviations.empty()) {
            re = level.deviations[i].parts(n, at(dof)).real();
            im = level.deviations[i].parts(n, at(dof)).imag();
          }
          text += csv_line({csv_number(level.level), csv_number(hertz(point.omega)),
                            fmt::format("{}", point.harmonics[static_cast<std::size_t>(n)]), run.dofs[dof], csv_number(x.real()),
                            csv_number(x.imag()), csv_number(re), csv_number(im), csv_number(bar)});
        }
      }
    }
  }
  return text;
}

}  // namespace jointid::report
