#include <taut/io/case_sections.h>

namespace taut::io
{
namespace
{
void declare_motion_keys(Section section, study::MotionDescription& motion)
{
  section
      .required("Of", motion.of, text("the name of a column of history.csv"),
                "what moves: a probe of a film, or a column of a lumped model")
      .optional("Velocity", motion.velocity, text("the name of a column"),
                "its rate, likewise; none is that of a lumped model's "
                "coordinate, else the derivative through the rows")
      .optional("Period", motion.period, number(not_negative(), "s"),
                "of the drive, at whose multiples the section is taken, which "
                "are rows of history.csv, too; 0 takes it where Of passes its "
                "mean upwards")
      .optional("From", motion.from, number(any(), "s"),
                "the transient before is left out")
      .optional("Tolerance", motion.tolerance,
                number(between(0, 0.1), "dimensionless"),
                "what repeats within this part of half the motion's range is "
                "the same")
      .optional("Lyapunov exponent", motion.lyapunov_exponent, yes_no(),
                "whether the largest one is computed, of a lumped model");
}

void declare_response_keys(Section section,
                           study::FrequencyResponseDescription& response)
{
  using Direction = study::FrequencyResponseDescription::Direction;
  section
      .required("From", response.from, number(positive(), "Hz"),
                "lowest frequency of the source")
      .required("To", response.to, number(positive(), "Hz"), "highest")
      .optional("Points", response.points, count(1, 100000),
                "number of frequencies")
      .optional("Spacing", response.is_logarithmic,
                choice<bool>({{"linear", false}, {"logarithmic", true}}),
                "of the frequencies")
      .optional("Direction", response.direction,
                choice<Direction>({{"up", Direction::up},
                                   {"down", Direction::down},
                                   {"both", Direction::both}}),
                "whether the frequency rises or falls; both shows jumps")
      .optional("Offset", response.offset, number(any(), "V"),
                "constant part of the source (V, or C under charge)")
      .required("Amplitude", response.amplitude, number(any(), "V"),
                "of its sine (V, or C under charge); the film feels the square "
                "of both, which holds the frequency and twice it")
      .optional("Of", response.of, text("the name of a column"),
                "what is watched; none is the angle of a DEMES and the bar's "
                "displacement of a resonator")
      .optional("Least periods", response.least_periods, count(24, 1000000),
                "of the source at each frequency")
      .optional("Most periods", response.most_periods, count(24, 1000000),
                "after which a motion counts as not settled")
      .optional("Settled within", response.settled_within,
                number(between(0, 0.1), "dimensionless"),
                "what is still to come of mean and amplitude, over the "
                "amplitude, when a motion counts as settled")
      .optional("From rest", response.from_rest, yes_no(),
                "whether each frequency starts at rest and is watched for the "
                "Observation time, instead of going on from the one before "
                "until it has settled")
      .optional("Observation time", response.observation_time,
                number(not_negative(), "s"), "of each frequency from rest");
}
} // namespace

void declare_motion(Declarations& all, const CaseText& text,
                    study::Case& content)
{
  all.allow_section({}, "Motion", false);
  // An option may add the section to a case without one.
  if (!text.find({"Motion"}) && !text.find({"Motion"}, "Of"))
    return;
  content.motion.emplace();
  declare_motion_keys(
      all.section({"Motion"}, "what is found out about the motion of a run"),
      *content.motion);
}

void declare_frequency_response(Declarations& all, const CaseText& text,
                                study::ProcedureDescription& procedure)
{
  const SectionPath path{"Procedure", "Frequency response"};
  all.allow_section({"Procedure"}, "Frequency response", false);
  const Entry* analysis = text.find({"Procedure"}, "Analysis");
  if (text.find(path) || (analysis && analysis->value == "frequency response"))
    declare_response_keys(
        all.section(path, "the settled motions of a lumped model over the "
                          "frequency of its source"),
        procedure.frequency_response);
}
} // namespace taut::io
