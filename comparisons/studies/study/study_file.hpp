#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/visitor.hpp"
#include "fem/interface/material.hpp"

namespace rebound {

/// A Prony branch of the material that a study fits, on the long-term modulus.
struct StudyBranch {
  double ratio = 0.0;            ///< start, or value when not fitted [-]
  double relaxation_time = 0.0;  ///< start, or value when not fitted [s]
  bool fit_ratio = true;
  bool fit_time = true;
};

/// How a study models the balls by finite elements.
struct StudyFem {
  ElasticModel elastic{};
  double poisson_ratio = 0.4;
  int cells = 4000;                 ///< of the reference runs
  int coarse_cells = 1000;          ///< of the second run, whose distance is the numerical spread
  int calibration_cells = 400;      ///< of the runs inside a fit
  double shortest_travel = 0.5e-3;  ///< range of the platen fit in the data [m]
  double longest_travel = 2.5e-3;
  double contact_threshold = 10.0;  ///< where the data set states none [N]
  /// Shares of the value, where a data set states no uncertainty.
  double mean_deflection_uncertainty = 0.05;
  double pooled_peak_uncertainty = 0.15;
  std::vector<StudyBranch> branches;
};

struct StudyCore {
  std::string label;  ///< as shown, e.g. "A"
  std::string data;   ///< data-set folder, relative to the study file
};

/// A synthetic experiment with something hidden, and the model that does not
/// know of it.
struct StudyExperiment {
  std::string label;      ///< as shown, e.g. "hidden relaxation"
  std::string synthesis;  ///< synthesis file, relative to the study file
  std::string model;      ///< impact file whose [model] is believed, likewise
};

/// A whole study file: which balls, which FE model.
struct StudyFile {
  std::string title;
  std::string reproduce;  ///< folder of the paper's data whose numbers are checked; empty: none
  StudyFem fem;
  std::vector<StudyCore> cores;
  std::vector<StudyExperiment> experiments;  ///< diagnosed after the cores
};

void describe(Visitor& visit, StudyBranch& branch);
void describe(Visitor& visit, StudyFem& fem);
void describe(Visitor& visit, StudyCore& core);
void describe(Visitor& visit, StudyExperiment& experiment);
void describe(Visitor& visit, StudyFile& study);

/// Reads a study file; data folders become paths that can be opened from here.
/// Errors: Error(bad_input) also for no cores, no branches, two cores of one label.
StudyFile read_study(const Document& document);

}  // namespace rebound
