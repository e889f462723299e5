#pragma once

#include "event_watch.h"

namespace taut::structure
{
/// An event of films that happens where a margin of their points falls through
/// zero.
class FilmWatch : public EventWatch
{
public:
  /// Errors: BadInput for a film that the device lacks.
  FilmWatch(StructureSystem& system, const EventDescription& event);

  double compute_margin(double time, const double* state) override;
  EventReport report(double time, const double* state) override;

protected:
  /// Of every point of this rank.
  virtual std::vector<double> compute_point_margins(double time,
                                                    const double* state) = 0;
  /// What the report says of a margin at a point of this rank.
  virtual void describe(std::size_t point, double time, const double* state,
                        EventReport& report) = 0;
  const Film& get_film(std::size_t cell) const;

private:
  std::vector<double>
  compute_film_margins(const std::vector<double>& margins) const;
  /// Index of this rank's point of these films with the smallest margin; the
  /// number of all points if it has none.
  std::size_t find_worst(const std::vector<double>& margins,
                         const std::vector<std::size_t>& films) const;

  /// The films it looks at.
  std::vector<std::size_t> films_;
};

/// Tension loss, wrinkling, slackness.
class TensionWatch : public FilmWatch
{
public:
  using FilmWatch::FilmWatch;

private:
  std::vector<double> compute_point_margins(double time,
                                            const double* state) override;
  void describe(std::size_t point, double time, const double* state,
                EventReport& report) override;
};

class BreakdownWatch : public FilmWatch
{
public:
  using FilmWatch::FilmWatch;

private:
  std::vector<double> compute_point_margins(double time,
                                            const double* state) override;
  void describe(std::size_t point, double time, const double* state,
                EventReport& report) override;
};
} // namespace taut::structure
