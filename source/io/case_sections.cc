#include <taut/io/case_sections.h>

namespace taut::io
{
namespace
{
/// A case with one section of every kind, and one spring of every law.
const char* const film_prototype = R"(
subsection Material NAME
  subsection Spring neo-Hookean
    set Law = neo-Hookean
  end
  subsection Spring Mooney-Rivlin
    set Law = Mooney-Rivlin
  end
  subsection Spring Gent
    set Law = Gent
  end
  subsection Spring Yeoh
    set Law = Yeoh
  end
  subsection Spring Arruda-Boyce
    set Law = Arruda-Boyce
  end
  subsection Network NAME
    set Law = neo-Hookean
  end
  subsection Network NAME (stress-activated)
    set Law = neo-Hookean
    set Relaxation law = stress-activated
  end
  subsection Network NAME (stretch-activated)
    set Law = neo-Hookean
    set Relaxation law = stretch-activated
  end
  subsection Fibre family quadratic
    set Law = quadratic
  end
  subsection Fibre family exponential
    set Law = exponential
  end
  subsection Dielectric
    set Permittivity = constant
  end
end
subsection Material NAME (stretch-dependent permittivity)
  subsection Dielectric
    set Permittivity = stretch-dependent
  end
end
subsection Film NAME
end
subsection Electrode NAME
end
subsection Support NAME
end
subsection Bar NAME
end
subsection Frame NAME
end
subsection Frame NAME (general section)
  set Section = stiffnesses
end
subsection Hinge NAME
end
subsection Rigid body NAME
end
subsection Point mass NAME
end
subsection Point load NAME
end
subsection Pressure NAME
end
subsection Edge load NAME
end
subsection Probe NAME
end
subsection Event NAME
end
subsection Comparison
end
subsection Motion
end
subsection Procedure
  subsection Frequency response
  end
end
)";
} // namespace

void declare_case(Declarations& all, const CaseText& text, CaseDraft& draft)
{
  study::Case& content = draft.content;
  all.section({}, "the case")
      .optional("Title", content.device.title, io::text("any text"),
                "what is simulated, for reports")
      .optional("Model", content.model, one_of({"film", "resonator", "demes"}),
                "finite elements of a device, or the lumped model of a "
                "resonator or of a DEMES");
  const Entry* model = text.find({}, "Model");
  if (model && model->value == "resonator")
  {
    all.allow_section({}, "Lumped resonator", false);
    declare_lumped_resonator(all, content.lumped_resonator);
  }
  else if (!model || model->value != "demes")
  {
    declare_materials(all, text, draft.materials);
    declare_device(all, text, draft);
  }
  declare_study(all, text, draft);
}

void declare_everything(Declarations& all, CaseDraft& draft)
{
  declare_case(all, CaseText::parse(film_prototype, "prototype.prm"), draft);
  declare_lumped_resonator(all, draft.content.lumped_resonator);
  declare_lumped_demes(all, draft.content.lumped_demes);
}
} // namespace taut::io
