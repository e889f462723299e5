#pragma once

#include <taut/lumped/resonator_run.h>

#include <vector>

namespace taut::lumped
{
/// A condition watched during a run and where it happens.
struct ResonatorWatch
{
  ResonatorFailure failure;
  ResonatorPlace place;
};

/// The resonator as a system of ordinary differential equations.
class ResonatorMotion
{
public:
  /// The resonator must outlive it.
  explicit ResonatorMotion(const Resonator& resonator);
  virtual ~ResonatorMotion() = default;

  /// The state at the start of a run.
  virtual std::vector<double>
  make_state(const std::vector<double>& internal,
             const ResonatorRunOptions& options) = 0;
  virtual void compute_rate(double time, const double* y, double* rate) = 0;
  virtual ResonatorRow observe(double time, const double* y) = 0;
  virtual std::vector<ResonatorWatch> get_watches() const = 0;
  /// One value per watch, positive while nothing has failed.
  virtual void compute_watches(double time, const double* y,
                               double* values) = 0;
  /// See time::OdeProblem.
  virtual void begin_segment(double begin, double end, double* y);

protected:
  /// V* with the limit from the left at the end of the segment.
  double get_voltage(double time) const;
  double get_voltage_rate(double time) const;

  const Resonator& resonator_;
  FrozenResonator frozen_;

private:
  double begin_ = 0;
  double end_ = 0;
};

/// y = [internal stretches].
class QuasiStaticMotion : public ResonatorMotion
{
public:
  explicit QuasiStaticMotion(const Resonator& resonator);
  std::vector<double> make_state(const std::vector<double>& internal,
                                 const ResonatorRunOptions& options) override;
  void compute_rate(double time, const double* y, double* rate) override;
  ResonatorRow observe(double time, const double* y) override;
  std::vector<ResonatorWatch> get_watches() const override;
  void compute_watches(double time, const double* y, double* values) override;
  void begin_segment(double begin, double end, double* y) override;

private:
  /// Freezes the internal stretches and returns lambda_1A.
  double balance(double voltage, const double* internal);
  /// Where the next search for a balance starts.
  double guess_ = 0;
};

/// y = [lambda_1A, its rate, internal stretches, dissipated energy, work].
class InertialMotion : public ResonatorMotion
{
public:
  explicit InertialMotion(const Resonator& resonator);
  std::vector<double> make_state(const std::vector<double>& internal,
                                 const ResonatorRunOptions& options) override;
  void compute_rate(double time, const double* y, double* rate) override;
  ResonatorRow observe(double time, const double* y) override;
  std::vector<ResonatorWatch> get_watches() const override;
  void compute_watches(double time, const double* y, double* values) override;
  void begin_segment(double begin, double end, double* y) override;

private:
  double compute_charge(double stretch_1a, double voltage) const;

  double alpha_;
  /// Places of the energies in y.
  std::size_t dissipated_;
  std::size_t work_;
  bool started_ = false;
};
} // namespace taut::lumped
