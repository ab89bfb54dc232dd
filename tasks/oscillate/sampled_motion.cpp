#include "tasks/oscillate/sampled_motion.hpp"

#include <cmath>

namespace jointid::tasks {
namespace {

using oscillation::ContactSystem;
using oscillation::Event;
using oscillation::Mode;
using oscillation::Piece;
using oscillation::StickSlip;

constexpr std::size_t most_break_aways = 1000, most_turns = 1'000'000;

Eigen::MatrixXd rows_of(const std::vector<SeenForm>& forms, Eigen::Index degrees) {
  Eigen::MatrixXd out(at(forms.size()), degrees);
  for (std::size_t k = 0; k < forms.size(); ++k) out.row(at(k)) = forms[k].row;
  return out;
}

std::string per_second(const std::string& unit) { return unit == "m" ? "m/s" : unit + "/s"; }

/// Fills a SampledMotion while the system moves.
class Sampler {
 public:
  Sampler(const OscillateScene& scene, const ContactSystem& system)
      : scene_(scene),
        system_(system),
        forms_(seen_forms(scene.system)),
        judged_(judged_form(scene.system)),
        seen_(rows_of(forms_, system.degrees())),
        count_(static_cast<std::size_t>(scene.motion.length / scene.motion.step + 0.5)) {
    out_.seen = forms_.size();
    out_.columns.push_back({"time", "s"});
    for (const SeenForm& form : forms_) out_.columns.push_back({form.name, form.unit});
    for (const SeenForm& form : forms_) out_.columns.push_back({"d" + form.name + "/dt", per_second(form.unit)});
    out_.columns.insert(out_.columns.end(), {{"relative velocity", "m/s"}, {"friction", "N"}, {"normal", "N"}});
    out_.columns.push_back({judged_.name, judged_.unit});
    out_.samples.resize(at(count_), at(out_.columns.size()));
    out_.q.resize(system.degrees(), at(count_));
  }

  void watch(StickSlip& motion) {
    motion.on_piece = [this](const Piece& piece) { take(piece); };
    motion.on_event = [this](const Event& event) { take(event); };
  }

  SampledMotion finish(const StickSlip& motion, oscillation::MotionEnd status) {
    out_.status = status;
    out_.samples.conservativeResize(at(next_), Eigen::NoChange);
    out_.q.conservativeResize(Eigen::NoChange, at(next_));
    out_.end = motion.state();
    out_.end_mode = motion.mode();
    out_.section.resize(at(section_.size()), 2 * seen_.rows());
    for (std::size_t k = 0; k < section_.size(); ++k) out_.section.row(at(k)) = section_[k].transpose();
    return std::move(out_);
  }

 private:
  double time(std::size_t sample) const { return scene_.motion.transient + scene_.motion.step * static_cast<double>(sample); }

  Eigen::VectorXd seen_at(const Eigen::VectorXd& z) const {
    Eigen::VectorXd out(2 * seen_.rows());
    out << seen_ * z.head(system_.degrees()), seen_ * z.segment(system_.degrees(), system_.degrees());
    return out;
  }

  void take(const Piece& piece) {
    if (piece.mode == Mode::stick) out_.stick_share += piece.length / scene_.motion.length;
    for (; next_ < count_ && time(next_) <= piece.start + piece.length; ++next_) {
      const Eigen::VectorXd z = piece.at(time(next_) - piece.start);
      const Eigen::VectorXd seen = seen_at(z), q = z.head(system_.degrees());
      out_.samples.row(at(next_)) << time(next_), seen.transpose(), system_.relative[1].dot(z), system_.force(piece.mode, z),
          system_.normal.dot(z), judged_.row * q;
      out_.q.col(at(next_)) = q;
    }
    if (!scene_.system.is_driven()) return;
    const double cycle = 1.0 / scene_.system.frequency_hz;
    for (double turn = std::ceil(piece.start / cycle - 1e-9);
         turn * cycle < piece.start + piece.length - 1e-9 * cycle && section_.size() < most_turns; turn += 1.0)
      section_.push_back(seen_at(piece.at(std::max(turn * cycle - piece.start, 0.0))));
  }

  void take(const Event& event) {
    ++out_.events;
    if (event.from != Mode::stick) return;
    if (out_.break_aways.size() < most_break_aways) out_.break_aways.push_back(event);
    if (!scene_.system.is_driven() && section_.size() < most_turns) section_.push_back(seen_at(event.state));
  }

  const OscillateScene& scene_;
  const ContactSystem& system_;
  std::vector<SeenForm> forms_;
  SeenForm judged_;
  Eigen::MatrixXd seen_;
  std::size_t count_, next_ = 0;
  std::vector<Eigen::VectorXd> section_;
  SampledMotion out_;
};

}  // namespace

SampledMotion sampled_motion(const OscillateScene& scene, const ContactSystem& system, const std::function<void(double)>& share,
                             const std::function<bool()>& interrupted) {
  StickSlip motion(system, system.state(scene.q, scene.v));
  const double end = scene.motion.transient + scene.motion.length;
  motion.interrupted = [&] {
    share(motion.time() / end);
    return interrupted && interrupted();
  };
  Sampler sampler(scene, system);
  oscillation::MotionEnd status = motion.advance(scene.motion.transient);
  sampler.watch(motion);
  if (status == oscillation::MotionEnd::ok) status = motion.advance(end);
  return sampler.finish(motion, status);
}

}  // namespace jointid::tasks
