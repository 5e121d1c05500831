#include <fmt/format.h>

#include "comparisons/evaluation/convert/codes/gazebo.hpp"

namespace rebound {
namespace {

std::string urdf_lines(const CodeContact& contact) {
  const double k = contact.at("stiffness"), d = contact.at("damping");
  return fmt::format(
      "<!-- Bullet: in the ball's link -->\n"
      "<contact>\n"
      "  <stiffness value=\"{:.9g}\"/>\n"
      "  <damping value=\"{:.9g}\"/>\n"
      "</contact>\n"
      "<!-- Gazebo Classic: beside the link named ball -->\n"
      "<gazebo reference=\"ball\">\n"
      "  <kp>{:.9g}</kp>\n"
      "  <kd>{:.9g}</kd>\n"
      "  <maxVel>{:.4g}</maxVel>\n"
      "  <minDepth>0</minDepth>\n"
      "</gazebo>\n",
      k, std::max(0.0, d - 0.1), k, gazebo_kd(contact), gazebo_max_speed(contact));
}

}  // namespace

// URDF itself has no compliance: <contact> is Bullet's extension (Extras and examples
// URDFParser: stiffness, damping), <gazebo reference> that of Gazebo Classic, which turns kp, kd,
// maxVel and minDepth into those of SDFormat.
OtherCode urdf_code() {
  return {
      .name = "urdf",
      .title = "URDF with the extensions of Bullet and of Gazebo Classic",
      .convention = "linear-restitution",
      .separation = SeparationRule::zero_force,
      .force = gazebo_force,
      .source = "Bullet's and Gazebo's extensions of URDF",
      .cautions = {"URDF has no contact of its own: these are two engines' extensions",
                   "Gazebo's world needs contact_max_correcting_vel as high as maxVel, too: it is "
                   "100 m/s where nothing is said",
                   "set on the ball alone, with the default damping of the wall taken off",
                   "errors below are those of its steps, too"},
      .stepping = ContactStepping::implicit,
      .settings = gazebo_settings,
      .lines = urdf_lines};
}

}  // namespace rebound
