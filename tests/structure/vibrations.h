#pragma once

#include <taut/structure/vibration_damping.h>

#include "structure/statics.h"

/// Modes of structures that tests build.
namespace taut::testing
{
/// A structure at rest under constant loads, its networks relaxed or just
/// stretched from the mesh's undeformed film.
class Resting
{
public:
  Resting(const structure::Device& device, const fe::MeshData& mesh,
          const bool relaxed = true)
      : model_(device, mesh)
  {
    state_ = system_.make_initial_state(
        0, relaxed ? structure::Start::relaxed : structure::Start::unrelaxed,
        true, make_options());
  }

  structure::StructureSystem& system()
  {
    return system_;
  }
  std::vector<double>& state()
  {
    return state_;
  }
  structure::Vibration make_vibration()
  {
    return structure::Vibration(*model_.structure,
                                system_.loads_at(0, state_.data()),
                                state_.data(), system_.internal(state_.data()));
  }
  /// The lowest squares of angular frequencies.
  std::vector<double> find_squares(const unsigned int count)
  {
    auto vibration = make_vibration();
    return find_squares(vibration, count);
  }
  static std::vector<double> find_squares(structure::Vibration& vibration,
                                          const unsigned int count)
  {
    time::ModeOptions options;
    options.count = count;
    const auto search = time::find_modes(vibration, options);
    EXPECT_TRUE(search.complete);
    std::vector<double> squares;
    for (const auto& mode : search.modes)
      squares.push_back(mode.square);
    return squares;
  }

private:
  static time::PathOptions make_options()
  {
    time::PathOptions options;
    options.newton.tolerance = 1e-13;
    return options;
  }

  Model model_;
  structure::QuasiStaticSystem system_{*model_.structure, make_options()};
  std::vector<double> state_;
};
} // namespace taut::testing
