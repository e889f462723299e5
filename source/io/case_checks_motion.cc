#include <taut/base/nearest_name.h>
#include <taut/io/case_checks.h>
#include <taut/study/motion_flow.h>

#include <fmt/format.h>

#include <algorithm>

namespace taut::io
{
namespace
{
using structure::Analysis;

/// What a motion can be of.
std::vector<std::string> list_moving(const study::Case& content)
{
  if (content.model != "film")
    return study::get_lumped_column_names(content);
  std::vector<std::string> names;
  for (const structure::Probe& probe : content.device.probes)
    names.push_back(probe.name);
  return names;
}

void check_column(const CaseText& text, const SectionPath& section,
                  const std::string& key, const std::string& name,
                  const study::Case& content)
{
  const auto known = list_moving(content);
  if (std::find(known.begin(), known.end(), name) != known.end())
    return;
  text.refuse(section, key,
              fmt::format("there is no {} '{}'; {}",
                          content.model == "film" ? "probe" : "column", name,
                          suggest(name, known)));
}

void check_motion_times(const CaseText& text,
                        const study::MotionDescription& motion,
                        const study::ProcedureDescription& procedure)
{
  const double left =
      procedure.end_time - std::max(motion.from, procedure.start_time);
  if (!(left > 0))
    text.refuse({"Motion"}, "From",
                fmt::format("nothing of the run is left after {} s: it ends at "
                            "{} s",
                            motion.from, procedure.end_time));
  if (motion.period > left)
    text.refuse({"Motion"}, "Period",
                fmt::format("the {} s that are looked at hold no period of {} "
                            "s",
                            left, motion.period));
}

void check_source(const CaseText& text, const study::Case& content)
{
  const bool demes = content.model == "demes";
  const Signal& source =
      demes ? content.lumped_demes.source : content.lumped_resonator.voltage;
  if (!source.is_constant() || source.value(0) != 0)
    text.refuse({demes ? "Lumped DEMES" : "Lumped resonator"},
                demes ? "Source" : "Voltage",
                "in a frequency response the source is the Offset and "
                "Amplitude of Procedure/Frequency response: set this to 0");
}

void check_response_range(const CaseText& text,
                          const study::FrequencyResponseDescription& response)
{
  const SectionPath section{"Procedure", "Frequency response"};
  if (response.points > 1 && !(response.to > response.from))
    text.refuse(section, "To",
                fmt::format("the highest frequency {} Hz must exceed the "
                            "lowest, {} Hz",
                            response.to, response.from));
  if (response.most_periods < response.least_periods)
    text.refuse(section, "Most periods",
                fmt::format("they are fewer than the {} Least periods",
                            response.least_periods));
  if (response.from_rest && !(response.observation_time * response.from >= 1))
    text.refuse(section, "Observation time",
                fmt::format("from rest each frequency is watched for at least "
                            "one period: {} s or more are needed",
                            1 / response.from));
  if (!response.from_rest && response.observation_time > 0)
    text.refuse(section, "Observation time",
                "it is for From rest = true; otherwise each frequency lasts "
                "until its motion has settled");
}
} // namespace

void check_motion(const CaseText& text, const study::Case& content)
{
  if (!content.motion)
    return;
  const study::MotionDescription& motion = *content.motion;
  if (content.procedure.analysis != Analysis::transient)
    text.refuse({"Motion"}, "",
                "only an analysis 'transient' has a motion to look at");
  check_column(text, {"Motion"}, "Of", motion.of, content);
  if (!motion.velocity.empty())
    check_column(text, {"Motion"}, "Velocity", motion.velocity, content);
  check_motion_times(text, motion, content.procedure);
  if (motion.lyapunov_exponent && content.model == "film")
    text.refuse({"Motion"}, "Lyapunov exponent",
                "a film is too large for it: set it to false, and take the "
                "lumped model (Model = resonator or demes) for the exponent");
}

void check_frequency_response(const CaseText& text, const study::Case& content)
{
  const auto& procedure = content.procedure;
  const SectionPath section{"Procedure", "Frequency response"};
  if (procedure.analysis != Analysis::frequency_response)
  {
    if (text.find(section))
      text.refuse(section, "", "it is only for Analysis = frequency response");
    return;
  }
  if (content.model == "film")
    text.refuse({"Procedure"}, "Analysis",
                "a frequency response is for lumped models: set Model = "
                "resonator or demes, or run this film as 'transient' under a "
                "sine voltage at each frequency with 'taut study'");
  check_source(text, content);
  check_response_range(text, procedure.frequency_response);
  if (!procedure.frequency_response.of.empty())
    check_column(text, section, "Of", procedure.frequency_response.of, content);
}
} // namespace taut::io
