#include <fmt/format.h>

#include "comparisons/evaluation/convert/codes/gazebo.hpp"

namespace rebound {
namespace {

std::string sdf_lines(const CodeContact& contact) {
  return fmt::format(
      "<!-- in the world -->\n"
      "<physics type=\"ode\">\n"
      "  <max_step_size>{:.9g}</max_step_size>\n"
      "  <ode><constraints><contact_max_correcting_vel>{:.4g}</contact_max_correcting_vel>"
      "</constraints></ode>\n"
      "</physics>\n"
      "<!-- in the collision of the ball -->\n"
      "<surface>\n"
      "  <bounce><restitution_coefficient>0</restitution_coefficient></bounce>\n"
      "  <friction><ode><mu>0</mu><mu2>0</mu2></ode></friction>\n"
      "  <contact>\n"
      "    <ode>\n"
      "      <kp>{:.9g}</kp>\n"
      "      <kd>{:.9g}</kd>\n"
      "      <max_vel>{:.4g}</max_vel>\n"
      "      <min_depth>0</min_depth>\n"
      "    </ode>\n"
      "  </contact>\n"
      "</surface>\n",
      contact.step, gazebo_max_speed(contact), contact.at("stiffness"), gazebo_kd(contact),
      gazebo_max_speed(contact));
}

}  // namespace

// SDFormat specification, element surface: contact/ode kp, kd, max_vel (default 0.01 m/s, which
// would hold the ball back), min_depth; how they are used: gazebo.hpp.
OtherCode sdf_code() {
  return {.name = "sdf",
          .title = "SDFormat, surface contact as Gazebo Classic's ODE reads it",
          .convention = "linear-restitution",
          .separation = SeparationRule::zero_force,
          .force = gazebo_force,
          .source = "SDFormat specification, surface; gazebo/physics/ode/ODEPhysics.cc",
          .cautions = {"set on the ball alone; the wall keeps the defaults, whose damping of "
                       "1 N.s/m is taken off",
                       "errors below are those of its steps, too"},
          .stepping = ContactStepping::implicit,
          .settings = gazebo_settings,
          .lines = sdf_lines};
}

}  // namespace rebound
