#include "ident/newton/loose_by_frequencies.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "ident/judgement/tell_errors.hpp"
#include "ident/newton/loose_path.hpp"
#include "ident/plan/interpret.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/scene/scene_failure.hpp"
#include "minimise/linear/linear_solution.hpp"
#include "models/matrix_model.hpp"
#include "models/model_file.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr const char* frequencies_key = "[identify] frequencies";
constexpr Index most_coordinates = 3000;  // the eigenvalue problem is dense

class LooseMethod final : public MethodPlan {
 public:
  SharedStiffness structure;

  void read_first_line(const Plan&) override {}
  void solve(const Plan& plan, const Control& control, Solution& out) override;
  std::string not_shared(const Plan&) const override { return "eigenfrequencies are fitted all at once"; }
};

/// Coordinates of all parts one after the other, and where the joint DOFs are among them.
class JoinedModels {
 public:
  explicit JoinedModels(const Plan& plan) : plan_(plan) {
    for (std::size_t s = 0; s < plan.scene.data.substructures.size(); ++s) add(s);
  }

  SharedStiffness joined() {
    SharedStiffness out{.mass = MatrixXd::Zero(size_, size_), .stiffness = MatrixXd::Zero(size_, size_), .of_joint = {}};
    Index first = 0;
    for (const auto& [mass, stiffness] : matrices_) {
      out.mass.block(first, first, mass.rows(), mass.rows()) = mass;
      out.stiffness.block(first, first, mass.rows(), mass.rows()) = stiffness;
      first += mass.rows();
    }
    out.of_joint.resize(plan_.restriction.unknowns.size());
    for (const restrictions::MatrixTerms& matrix : plan_.restriction.matrices) {
      if (matrix.kind != restrictions::Kind::stiffness) continue;
      for (const restrictions::Term& term : matrix.terms) {
        const Place a = place(term.row), b = place(term.column);
        out.of_joint[term.unknown].push_back({a.row, b.row, a.sign * b.sign * term.coefficient});
      }
      for (const restrictions::Known& known : matrix.known) {
        const Place a = place(known.row), b = place(known.column);
        out.stiffness(a.row, b.row) += a.sign * b.sign * known.value;
      }
    }
    return out;
  }

 private:
  struct Place {
    Index row = 0;
    double sign = 1.0;
  };

  [[noreturn]] void refuse_part(std::size_t source, const std::string& problem) const {
    fail(plan_.scene, frequencies_key, plan_.substructures->source(source).header().file + " " + problem,
         "describe the part by mass and stiffness (docs/model-parts.md)");
  }

  void add(std::size_t source) {
    const std::filesystem::path& file = plan_.scene.data.substructures[source].path;
    if (!models::is_model_file(file)) refuse_part(source, "is no model: loose joints by eigenfrequencies alone need one");
    const models::NamedModel named = models::read_model(file);
    const auto* const model = dynamic_cast<const models::MatrixModel*>(named.model.get());
    if (model == nullptr) refuse_part(source, "has modes: loose joints by eigenfrequencies alone need its matrices");
    const Dofs& dofs = plan_.substructures->source(source).header().response;
    if (dofs.size() != named.coordinates.coordinates.size()) refuse_part(source, "has virtual points in place of its coordinates");
    for (std::size_t k = 0; k < dofs.size(); ++k) {
      dofs_.push_back(dofs[k]);
      places_.push_back({size_ + at(named.coordinates.coordinates[k]), static_cast<double>(dofs[k].sign)});
    }
    matrices_.emplace_back(model->matrices().mass, model->matrices().stiffness);
    size_ += model->matrices().mass.rows();
    if (size_ > most_coordinates)
      refuse_part(source, "is one too many: the parts have more than " + std::to_string(most_coordinates) + " coordinates");
  }

  Place place(std::size_t joint_dof) const {
    const frf::Dof& dof = plan_.restriction.dofs[joint_dof];
    Place out = places_[frf::find_coordinate(dofs_, dof)];
    out.sign *= dof.sign;
    return out;
  }

  const Plan& plan_;
  Index size_ = 0;
  Dofs dofs_;
  std::vector<Place> places_;
  std::vector<std::pair<MatrixXd, MatrixXd>> matrices_;
};

void require_no_more(const Plan& plan) {
  const Scene& scene = plan.scene;
  const auto require = [&](bool goes, const std::string& what) {
    if (!goes) fail(scene, frequencies_key, "loose joints by eigenfrequencies alone do not go with " + what, "leave one of them out");
  };
  require(!plan.admissible, "bounds, ties and other constraints");
  require(scene.couple_first.pairs.empty(), "couple_first");
  require(scene.identify.start.empty() && scene.identify.starts == 0, "a start");
  require(plan.columns->size() == plan.restriction.unknowns.size(), "bands");
  const Solver solver = scene.identify.solver;
  require(solver == Solver::automatic || solver == Solver::newton, "solver \"" + name(solver) + "\"");
}

void require_shares(const Plan& plan) {
  for (const restrictions::Unknown& unknown : plan.restriction.unknowns) {
    if (unknown.kind == restrictions::Kind::stiffness) continue;
    fail(plan.scene, frequencies_key, "eigenfrequencies do not determine " + unknown.name,
         "give hysteretic_damping of the joints by numbers, or leave frequencies out");
  }
  if (plan.scene.identify.frequencies_hz.size() < 3)
    fail(plan.scene, frequencies_key, "fewer than three eigenfrequencies do not determine a loose joint", "give more of them");
}

std::string statement(const LooseFit& fit) {
  return "Loose joints by eigenfrequencies alone: the stated ones are " + digits(100.0 * fit.misfit, "%.2g") +
         " % rms off those of the structure with these joints, " + digits(100.0 * fit.before, "%.2g") + " % with all joints sound.";
}

void LooseMethod::solve(const Plan& plan, const Control& control, Solution& out) {
  constexpr double poor = 0.02;
  std::vector<double> frequencies = plan.scene.identify.frequencies_hz;
  std::ranges::sort(frequencies);
  std::size_t solutions = 0;
  LooseFit fit;
  {
    const Stopwatch watch(out.runtime_s.solve);
    try {
      fit = fit_loose_joints(structure, frequencies, [&] {
        stop_if(control.interrupted);
        if (control.progress) control.progress("eigenfrequencies", ++solutions, 0);
      });
    } catch (const InputError& error) {
      fail(plan.scene, frequencies_key, error.parts().problem, error.parts().remedy);
    }
  }
  minimise::LinearSolution linear;
  for (std::size_t c = 0; c < plan.columns->size(); ++c) linear.y.push_back((1.0 - fit.lost[at(c)]) / plan.unscale(c));
  linear.rank = linear.y.size();
  interpret(plan, linear, out);
  out.fit.iterations = fit.solutions;
  out.fit.equations_used = frequencies.size();
  for (std::size_t c = 0; c < out.unknowns.size(); ++c) {
    if (fit.lost[at(c)] == 0.0) continue;
    const double error = fit.std_error[at(c)];
    out.unknowns[c].std_error = error;
    out.unknowns[c].ci95 = {out.unknowns[c].value - normal_95 * error, out.unknowns[c].value + normal_95 * error};
  }
  out.warnings.push_back(statement(fit));
  if (fit.misfit > poor) {
    tell(out, Status::doubtful,
         "The stated eigenfrequencies are not those of the structure with any few loose joints: "
         "look whether one is missing among the lowest, or at the models of the parts.");
  }
}

}  // namespace

PlannedMethod plan_loose_by_frequencies(const Plan& plan) {
  require_no_more(plan);
  require_shares(plan);
  PlannedMethod out = undecided(plan);
  auto own = std::make_unique<LooseMethod>();
  own->structure = JoinedModels(plan).joined();
  out.solver = Solver::newton;
  out.cost.lines = plan.lines.size();
  out.cost.columns = plan.columns->size();
  out.left_out.emplace_back("all FRFs: the loose joints are determined by eigenfrequencies alone");
  out.method = std::move(own);
  return out;
}

}  // namespace jointid::ident
