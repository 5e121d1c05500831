#pragma once

#include <string>

#include "comparisons/io/report/report.hpp"

namespace rebound::report_tests {

/// A report with every kind of block, of TEST DATA and saying so: linear Kelvin–Voigt
/// impacts in closed form, x = (v₀/ω_d) e^{−ζω₀t} sin ω_d t, of two made-up balls.
/// `ball_name` is the first ball's name, wherever a name can stand.
report::Report demo_report(const std::string& ball_name = "ball P");

}  // namespace rebound::report_tests
