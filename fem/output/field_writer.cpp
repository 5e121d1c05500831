#include "fem/output/field_writer.hpp"

#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "fem/discretisation/field_geometry.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

std::ofstream open_for_writing(const std::filesystem::path& path) {
  std::ofstream file(path);
  if (!file)
    throw Error(ExitCode::input_output_failed, "cannot write the field file",
                {.file = path.string()});
  return file;
}

/// Gives a point vector field to deal.II's output as (r, z) components.
void add_vector_field(dealii::DataOut<2>& output, const dealii::DoFHandler<2>& dofs,
                      const std::vector<double>& field, const std::string& name,
                      std::vector<dealii::Vector<double>>& keep) {
  for (int component = 0; component < 2; ++component) {
    dealii::Vector<double>& values = keep.emplace_back(dofs.n_dofs());
    for (unsigned i = 0; i < dofs.n_dofs(); ++i) values[i] = field[2 * i + component];
    output.add_data_vector(dofs, values, name + (component == 0 ? "_r" : "_z"));
  }
}

}  // namespace

FieldWriter::FieldWriter(const Discretisation& body, const FemProblem& problem,
                         double expected_duration)
    : body_(body), directory_(problem.controls.field_directory) {
  if (problem.controls.field_frames <= 0) return;
  std::error_code error;
  std::filesystem::create_directories(directory_, error);
  if (error)
    throw Error(ExitCode::input_output_failed, "cannot make the field folder: " + error.message(),
                {.file = directory_});
  interval_ = expected_duration / problem.controls.field_frames;
}

void FieldWriter::write_due_frames(double time, const std::vector<double>& displacement,
                                   const std::vector<double>& velocity) {
  if (interval_ == 0.0 || time < next_) return;
  next_ += interval_;
  char name[32];
  std::snprintf(name, sizeof name, "frame-%04zu.vtu", frames_.size());
  dealii::DataOut<2> output;
  std::vector<dealii::Vector<double>> keep;
  keep.reserve(4);
  add_vector_field(output, body_.fields->dofs, displacement, "displacement", keep);
  add_vector_field(output, body_.fields->dofs, velocity, "velocity", keep);
  output.build_patches();
  auto file = open_for_writing(std::filesystem::path(directory_) / name);
  output.write_vtu(file);
  frames_.emplace_back(time, name);
}

void FieldWriter::write_collection() const {
  if (frames_.empty()) return;
  auto file = open_for_writing(std::filesystem::path(directory_) / "impact.pvd");
  dealii::DataOutBase::write_pvd_record(file, frames_);
}

}  // namespace rebound::fem
