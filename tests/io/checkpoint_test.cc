// A run's state through a file and back, on a mesh with hanging nodes and with
// a bar, on as many ranks as wrote it and on others.
#include <taut/base/exceptions.h>
#include <taut/io/checkpoint.h>
#include <taut/io/files.h>

#include <gtest/gtest.h>

#include <cmath>

#include "io/output_files.h"
#include "io/small_case.h"
#include "structure/devices.h"

namespace taut::io
{
namespace
{
using testing::is_first;
using testing::SharedFolder;

structure::Device make_device()
{
  structure::Device device;
  auto film = taut::testing::make_film(material::Gent{2e4, 60}, 1e-3, {{2, 2}});
  film.groups = {"left"};
  film.material.networks = {{material::NeoHookean{1e4}, .1},
                            {material::NeoHookean{1e4}, 1.}};
  device.films = {film};
  film.name = "second";
  film.groups = {"right"};
  film.material.networks.pop_back();
  device.films.push_back(film);
  device.supports = {
      taut::testing::make_support("west", {{true, true, true}}),
      taut::testing::make_support("east", {{true, false, true}})};
  device.electrodes = {
      taut::testing::make_electrode("left", Signal::constant(3000))};
  device.electrodes[0].control = structure::Electrode::Control::circuit;
  device.electrodes[0].series_resistance = 1e8;
  structure::RigidBar bar;
  bar.name = "bar";
  bar.groups = {"middle"};
  bar.mass = .01;
  device.bars = {bar};
  return device;
}

fe::MeshData make_mesh(const double length = .04)
{
  return taut::testing::make_rectangle(4, 3, 2, length, .03);
}

/// A device on a mesh of which `communicator` holds the parts.
struct Model
{
  explicit Model(const MPI_Comm communicator, const StoredRun* stored = nullptr)
      : mesh(make_mesh()), triangulation(communicator)
  {
    fe::create_triangulation(mesh, 0, triangulation);
    if (stored)
      restore_refinement(*stored, mesh, triangulation);
    else
      refine();
    structure = std::make_unique<structure::Structure>(make_device(), mesh,
                                                       triangulation);
  }

  /// Two levels into one corner.
  void refine()
  {
    for (const double reach : {.02, .008})
    {
      for (const auto& cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->center().norm() < reach)
          cell->set_refine_flag();
      triangulation.execute_coarsening_and_refinement();
    }
  }

  fe::MeshData mesh;
  fe::Triangulation triangulation;
  std::unique_ptr<structure::Structure> structure;
};

/// Any number that depends on the place alone: places differ by round-off
/// between ranks, so they are taken in units of 0.1 um.
double make_number(const std::array<double, 3>& place, const double seed)
{
  double sum = seed;
  for (const double x : place)
    sum = 1.7 * sum + std::round(1e7 * x);
  return std::sin(sum);
}

std::vector<double> make_state(structure::InertialSystem& system)
{
  const structure::Structure& structure = system.structure();
  std::vector<double> state;
  for (const double seed : {1., 2.})
    for (const auto entry : structure.free_unknowns())
      state.push_back(make_number(structure.nodes().mesh_position[entry / 3],
                                  seed + .1 * (entry % 3)));
  const fe::FilmCells& cells = structure.cells();
  for (unsigned int cell = 0; cell < cells.cells().size(); ++cell)
    for (unsigned int q = 0; q < cells.element().n_nodes; ++q)
      for (unsigned int i = 0; i < 3 * cells.n_networks(cell); ++i)
        state.push_back(make_number(cells.mesh_point(cell, q), 3. + i));
  for (std::size_t i = 0; i < system.layout().globals + system.layout().scalars;
       ++i)
    state.push_back(.1 * i);
  return state;
}

study::RunProgress make_progress()
{
  study::RunProgress progress;
  progress.time = .1;
  progress.steps = 7;
  progress.history_rows = 5;
  progress.field_frames = 2;
  progress.event_rows = 1;
  progress.armed_events = {false, true};
  progress.initial_energy = .25;
  progress.balance_absolute = 1e-9;
  progress.balance_scale = 2;
  return progress;
}

StoredRun store(Model& model)
{
  structure::InertialSystem system(*model.structure);
  return collect_run({}, make_progress(), system, make_state(system).data());
}

/// The stored run, restored on all ranks, is the state itself, bit by bit.
void expect_restored(const std::string& folder)
{
  const StoredRun stored = read_checkpoint(folder);
  Model model(MPI_COMM_WORLD, &stored);
  structure::InertialSystem system(*model.structure);
  const study::Checkpoint checkpoint = restore_state(stored, *model.structure);
  EXPECT_EQ(checkpoint.state, make_state(system));
  EXPECT_EQ(checkpoint.progress.time, .1);
  EXPECT_EQ(checkpoint.progress.steps, 7);
  EXPECT_EQ(checkpoint.progress.history_rows, 5u);
  EXPECT_EQ(checkpoint.progress.field_frames, 2u);
  EXPECT_EQ(checkpoint.progress.event_rows, 1u);
  EXPECT_EQ(checkpoint.progress.armed_events, (std::vector<bool>{false, true}));
  EXPECT_EQ(checkpoint.progress.initial_energy, .25);
  EXPECT_EQ(checkpoint.progress.balance_absolute, 1e-9);
  EXPECT_EQ(checkpoint.progress.balance_scale, 2);
}

TEST(Checkpoint, RestoresTheState)
{
  const SharedFolder folder("checkpoint");
  Model model(MPI_COMM_WORLD);
  ASSERT_GT(model.structure->dof_handler().n_dofs(), 0u);
  const StoredRun stored = store(model);
  if (is_first())
    write_checkpoint(folder.path(), stored);
  MPI_Barrier(MPI_COMM_WORLD);
  expect_restored(folder.path());
}

TEST(Checkpoint, WrittenOnOneRankIsReadOnAll)
{
  const SharedFolder folder("checkpoint_of_one");
  if (is_first())
  {
    Model model(MPI_COMM_SELF);
    write_checkpoint(folder.path(), store(model));
  }
  MPI_Barrier(MPI_COMM_WORLD);
  expect_restored(folder.path());
}

TEST(Checkpoint, WrittenOnAllIsReadOnOneRank)
{
  const SharedFolder folder("checkpoint_for_one");
  Model model(MPI_COMM_WORLD);
  const StoredRun stored = store(model);
  if (is_first())
  {
    const Model alone(MPI_COMM_SELF, &stored);
    structure::InertialSystem system(*alone.structure);
    EXPECT_EQ(restore_state(stored, *alone.structure).state,
              make_state(system));
  }
}

TEST(Checkpoint, AnotherMeshIsRefused)
{
  Model model(MPI_COMM_WORLD);
  const StoredRun stored =
      dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, store(model), 0);
  const fe::MeshData other = make_mesh(.05);
  fe::Triangulation triangulation(MPI_COMM_WORLD);
  fe::create_triangulation(other, 0, triangulation);
  EXPECT_THROW(restore_refinement(stored, other, triangulation), BadInput);
}

/// A refused file of a single process.
class CheckpointFile : public ::testing::Test
{
protected:
  CheckpointFile() : folder_("checkpoint_file")
  {
    if (!is_first())
      return;
    Model model(MPI_COMM_SELF);
    write_checkpoint(folder_.path(), store(model));
  }

  void expect_refused(const std::string& bytes, const std::string& reason)
  {
    replace_file(file(), bytes);
    try
    {
      read_checkpoint(folder_.path());
      FAIL() << "was accepted";
    }
    catch (const BadInput& error)
    {
      EXPECT_EQ(error.file(), file());
      EXPECT_NE(error.message().find(reason), std::string::npos)
          << error.message();
    }
  }
  std::string file() const
  {
    return folder_.get("state");
  }

  SharedFolder folder_;
};

TEST_F(CheckpointFile, CutOffIsRefused)
{
  if (!is_first())
    return;
  const std::string bytes = read_file(file());
  for (const double share : {.99, .5, .001})
    expect_refused(bytes.substr(0, 30 + share * (bytes.size() - 30)),
                   "cut off or damaged");
  expect_refused(bytes.substr(0, 20), "cut off or damaged");
}

TEST_F(CheckpointFile, DamagedIsRefused)
{
  if (!is_first())
    return;
  std::string bytes = read_file(file());
  bytes[bytes.size() / 2] ^= 1;
  expect_refused(bytes, "cut off or damaged");
}

TEST_F(CheckpointFile, OtherFormatIsRefused)
{
  if (!is_first())
    return;
  expect_refused("taut checkpoint 0\n" + read_file(file()), "this version");
  expect_refused("", "this version");
}

/// The message with which a run of small_case is not resumed with `overrides`;
/// empty if it is.
std::string resume_with(const std::vector<std::string>& overrides)
{
  const testing::CaseOnDisk on_disk(testing::small_case);
  StoredRun run;
  run.parameters = get_critical_parameters(read_case_file(on_disk.file()));
  try
  {
    check_parameters(run, read_case_file(on_disk.file(), overrides));
  }
  catch (const BadInput& error)
  {
    return error.what();
  }
  return "";
}

TEST(CheckpointParameters, ChangedPhysicsIsRefusedByName)
{
  for (const std::string change :
       {"Material rubber/Density = 999", "Film left/Thickness = 2e-3",
        "Film right/Pre-stretch = 1, 2", "Procedure/Start = unrelaxed",
        "Environment/Air drag = 1"})
  {
    const std::string message = resume_with({change});
    const std::string path = change.substr(0, change.find(" ="));
    EXPECT_NE(message.find("'" + path + "'"), std::string::npos) << message;
  }
}

TEST(CheckpointParameters, EndOutputAndToleranceMayChange)
{
  EXPECT_EQ(
      resume_with({"Procedure/End time = 3", "Output/History intervals = 7",
                   "Checkpoint/Every minutes = 1",
                   "Procedure/Integrator/Position tolerance = 1e-9"}),
      "");
}
} // namespace
} // namespace taut::io
