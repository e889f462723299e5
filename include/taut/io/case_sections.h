#pragma once

#include <taut/io/declarations.h>
#include <taut/study/case.h>

/// Which sections and keys a case file has.
namespace taut::io
{
struct NamedSpring : structure::Named
{
  std::string law;
  material::Spring spring;
};

struct NamedNetwork : structure::Named
{
  std::string law;
  material::Network network{};
  std::string relaxation_law = "constant";
};

struct NamedFibreFamily : structure::Named
{
  std::string law;
  material::FibreFamily family{};
  double angle = 0; ///< of the fibres from the first material axis (rad)
};

struct MaterialDraft : structure::Named
{
  material::Dielectric dielectric;
  std::string permittivity_law = "constant";
  double density = 0; ///< (kg/m^3)
  material::ThermalLaws thermal;
  material::HumidityLaws humidity_laws;
  std::vector<NamedSpring> springs;
  std::vector<NamedNetwork> networks;
  std::vector<NamedFibreFamily> fibre_families;
};

/// What of a frame is not yet in its description.
struct FrameDraft
{
  std::string section = "rectangle";
  structure::RectangularSection rectangle;
  /// None is half the thickness (m).
  std::optional<double> offset = 0.;
};

using ProbePoint = std::optional<std::array<double, 3>>;

/// A case while it is read: names are not yet resolved.
struct CaseDraft
{
  study::Case content;
  std::vector<MaterialDraft> materials;
  /// Per film.
  std::vector<std::string> film_materials;
  /// Per frame.
  std::vector<FrameDraft> frames;
  /// Per probe.
  std::vector<ProbePoint> probe_points;
  std::string comparison_model = "resonator";
  study::ComparisonDescription comparison;
  study::DemesComparisonDescription demes_comparison;
};

/// Declares everything that `text` may hold, bound to `draft`, whose lists get
/// their final size here. Errors: BadInput where the kind of a section decides
/// about its keys and is wrong.
void declare_case(Declarations& all, const CaseText& text, CaseDraft& draft);

/// Declares every section there is, with NAME in place of names: for the
/// documentation.
void declare_everything(Declarations& all, CaseDraft& draft);

/// The parts of declare_case.
void declare_materials(Declarations& all, const CaseText& text,
                       std::vector<MaterialDraft>& materials);
void declare_device(Declarations& all, const CaseText& text, CaseDraft& draft);
void declare_frames(Declarations& all, const CaseText& text, CaseDraft& draft);
void declare_observation(Declarations& all, const CaseText& text,
                         CaseDraft& draft);
void declare_study(Declarations& all, const CaseText& text, CaseDraft& draft);
void declare_motion(Declarations& all, const CaseText& text,
                    study::Case& content);
void declare_frequency_response(Declarations& all, const CaseText& text,
                                study::ProcedureDescription& procedure);
void declare_lumped_resonator(Declarations& all,
                              study::LumpedResonatorDescription& resonator);
void declare_lumped_demes(Declarations& all,
                          study::LumpedDemesDescription& demes);
} // namespace taut::io
