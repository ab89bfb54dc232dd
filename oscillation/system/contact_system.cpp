#include "oscillation/system/contact_system.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "dense/cholesky.hpp"

namespace jointid::oscillation {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

[[noreturn]] void wrong(const std::string& place, const std::string& problem) {
  throw InputError({ErrorKind::usage, "", place, problem, ""});
}

void check(const Mechanics& m, const Drive& drive, const Friction& friction) {
  const Index n = m.contact.size();
  const auto square = [n](const MatrixXd& a) { return a.rows() == n && a.cols() == n; };
  if (n == 0 || !square(m.mass) || !square(m.damping) || !square(m.stiffness))
    wrong("matrices", "are not as large as the contact vector");
  if ((m.constant.size() != 0 && m.constant.size() != n) || (m.forcing.size() != 0 && m.forcing.size() != n))
    wrong("loads", "have another size");
  if (!dense::cholesky(m.mass)) wrong("mass", "is not positive definite");
  if (!(m.contact.squaredNorm() > 0.0)) wrong("contact", "is 0 everywhere");
  if (!(drive.angular_frequency >= 0.0)) wrong("angular_frequency", "is below 0");
  if (!(friction.kinetic >= 0.0) || !(friction.statical >= friction.kinetic)) wrong("friction", "needs 0 ≤ μ_K ≤ μ_S");
  if (friction.decay && !(*friction.decay > 0.0)) wrong("decay", "is not above 0");
  if (friction.contact_stiffness && !(*friction.contact_stiffness > 0.0)) wrong("contact_stiffness", "is not above 0");
  if (friction.contact_stiffness && friction.decay) wrong("decay", "of a compliant contact: its law is Coulomb's");
  const double steep = std::abs(friction.tilt);
  if (!(steep + std::atan(friction.statical) < std::numbers::pi / 2.0))
    wrong("tilt", "locks the contact: tan(tilt) is 1/μ_S or more");
  if (!(steep <= std::atan(friction.kinetic))) wrong("tilt", "lets the contact slide by its load alone: tan(tilt) is above μ_K");
}

}  // namespace

double tilted(double coefficient, double tilt, Mode slip) {
  return tilt == 0.0 ? coefficient : std::tan(std::atan(coefficient) + sign(slip) * tilt);
}

ContactSystem::ContactSystem(const Mechanics& m, const Drive& drive, const Friction& law)
    : friction(law), degrees_(m.contact.size()) {
  check(m, drive, law);
  for (const Mode slip : {Mode::backward, Mode::stick, Mode::forward}) {
    kinetic_[place(slip)] = tilted(law.kinetic, law.tilt, slip);
    statical_[place(slip)] = tilted(law.statical, law.tilt, slip);
  }
  const Index n = degrees_, one = 2 * n, sine = one + 1, cosine = one + 2, spring = one + 3;
  MatrixXd a = MatrixXd::Zero(size(), size());
  a.topRows(n).middleCols(n, n).setIdentity();
  a.middleRows(n, n).leftCols(n) = -dense::solve_positive(m.mass, m.stiffness);
  a.middleRows(n, n).middleCols(n, n) = -dense::solve_positive(m.mass, m.damping);
  if (m.constant.size() > 0) a.block(n, one, n, 1) = dense::solve_positive(m.mass, MatrixXd(m.constant));
  if (m.forcing.size() > 0) a.block(n, cosine, n, 1) = dense::solve_positive(m.mass, MatrixXd(m.forcing));
  a(sine, cosine) = drive.angular_frequency;
  a(cosine, sine) = -drive.angular_frequency;

  push = VectorXd::Zero(size());
  push.segment(n, n) = dense::solve_positive(m.mass, MatrixXd(m.contact));
  normal = VectorXd::Zero(size());
  normal(one) = law.normal;
  normal.head(n) = law.normal_slope * m.contact;
  VectorXd r = VectorXd::Zero(size());  // ḋ − ẏ
  r(one) = drive.velocity;
  r(cosine) = drive.amplitude * drive.angular_frequency;
  r.segment(n, n) = -m.contact;

  const MatrixXd identity = MatrixXd::Identity(size(), size());
  on_slip = identity;
  for (const Mode slip : {Mode::backward, Mode::forward}) {
    drift[place(slip)] = a + sign(slip) * kinetic(slip) * push * normal.transpose();
    relative[place(slip)] = r;
    if (law.contact_stiffness) {
      relative[place(slip)].segment(n, n) *= 1.0 + sign(slip) * kinetic(slip) * law.normal_slope / *law.contact_stiffness;
      on_stick[place(slip)] = identity;
      on_stick[place(slip)].row(spring) = sign(slip) * kinetic(slip) / *law.contact_stiffness * normal.transpose();
    } else {
      on_stick[place(slip)] = identity - push * r.transpose() / r.dot(push);
    }
  }
  relative[place(Mode::stick)] = r;
  on_stick[place(Mode::stick)] = identity;
  if (law.contact_stiffness) {
    stick_force = *law.contact_stiffness * VectorXd::Unit(size(), spring);
    drift[place(Mode::stick)] = a + push * stick_force.transpose();
    drift[place(Mode::stick)].row(spring) = r.transpose();
    on_slip(spring, spring) = 0.0;
  } else {
    stick_force = -a.transpose() * r / r.dot(push);
    drift[place(Mode::stick)] = on_stick[place(Mode::forward)] * a;
  }
}

VectorXd ContactSystem::state(const VectorXd& q, const VectorXd& v) const {
  if (q.size() != degrees_ || v.size() != degrees_) wrong("start", "has another number of coordinates than the system");
  VectorXd z = VectorXd::Zero(size());
  z.head(degrees_) = q;
  z.segment(degrees_, degrees_) = v;
  z(2 * degrees_) = z(2 * degrees_ + 2) = 1.0;
  return z;
}

VectorXd ContactSystem::field(Mode mode, const VectorXd& z) const {
  VectorXd out = drift[place(mode)] * z;
  if (mode != Mode::stick && is_falling()) out += (force(mode, z) - sign(mode) * kinetic(mode) * normal.dot(z)) * push;
  return out;
}

double ContactSystem::force(Mode mode, const VectorXd& z) const {
  if (mode == Mode::stick) return stick_force.dot(z);
  double mu = kinetic(mode);
  if (is_falling())
    mu += (statical(mode) - kinetic(mode)) * std::exp(-*friction.decay * sign(mode) * relative[place(mode)].dot(z));
  return sign(mode) * mu * normal.dot(z);
}

std::vector<Index> ContactSystem::free(Mode mode) const {
  std::vector<Index> out;
  for (Index i = 0; i < 2 * degrees_; ++i) out.push_back(i);
  if (!is_rigid() && mode == Mode::stick) out.push_back(2 * degrees_ + 3);
  return out;
}

}  // namespace jointid::oscillation
