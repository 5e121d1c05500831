#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "comparisons/evaluation/export/export_deck.hpp"
#include "fem/interface/elastic_models.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/sphere_mesh.hpp"

/// A small ball, decks of it, and what stands in one.
namespace rebound::deck_tests {

inline const Mesh& mesh() {
  static const Mesh made = generate_sphere_mesh({.radius = 0.0331, .cells = 60});
  return made;
}

inline FemProblem problem_of(ElasticModel elastic) {
  FemProblem problem;
  problem.sphere = {.mass = 0.0896, .diameter = 0.0662};
  problem.impact.speed = 15.0;
  problem.material = {.elastic = elastic, .youngs_modulus = 10e6, .poisson_ratio = 0.4};
  if (has_terms(elastic)) problem.material.terms = {{.exponent = 2.0}, {.exponent = -3.0}};
  return problem;
}

inline ExportedDeck deck_for(const char* target, const FemProblem& problem) {
  return export_deck(export_target(target), problem, mesh());
}

/// Numbers on the line below the one that begins with `keyword`.
inline std::vector<double> numbers_below(const std::string& text, const std::string& keyword) {
  std::istringstream lines(text.substr(text.find("\n" + keyword) + 1));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  std::vector<double> numbers;
  std::istringstream fields(line);
  for (std::string field; std::getline(fields, field, ',');)
    if (field.find_first_of("0123456789") != std::string::npos) numbers.push_back(std::stod(field));
  return numbers;
}

inline int count_of(const std::string& text, const std::string& what) {
  int count = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

inline double value_of(const std::string& text, const std::string& tag) {
  const auto at = text.find("<" + tag + ">");
  if (at == std::string::npos) throw std::runtime_error("no " + tag);
  return std::stod(text.substr(at + tag.size() + 2));
}

inline std::string refused_key(const char* target, const FemProblem& problem) {
  try {
    deck_for(target, problem);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    return error.location().key;
  }
  return "nothing refused";
}

}  // namespace rebound::deck_tests
