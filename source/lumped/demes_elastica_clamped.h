#pragma once

#include <taut/lumped/demes_elastica.h>

namespace taut::lumped
{
/// The elastica whose ends are held at a rotation while the film pulls at them.
class ClampedElastica
{
public:
  /// The elastica must outlive it.
  explicit ClampedElastica(const DemesElastica& elastica) : elastica_(elastica)
  {
  }

  /// Begins from a known shape.
  void start(const ElasticaShape& shape)
  {
    shape_ = shape;
  }
  /// Begins from nowhere: bends the straight frame to the end angle.
  /// Errors: StepRejected if there is no shape on the way.
  void start(double end_angle, double inner_stretch, double drive);

  /// The shape of an end angle near the last one; an inner stretch of 0 stands
  /// for a relaxed film. Errors: StepRejected if there is none.
  const ElasticaShape& solve(double end_angle, double inner_stretch,
                             double drive);

  /// -theta'' of a shape.
  double compute_moment(const ElasticaShape& shape) const;
  double compute_chord(const ElasticaShape& shape) const;
  double compute_stretch(const ElasticaShape& shape) const;
  /// p that the film exerts at a stretch.
  double compute_load(double stretch, double inner_stretch, double drive) const;

private:
  const DemesElastica& elastica_;
  ElasticaShape shape_;
};
} // namespace taut::lumped
