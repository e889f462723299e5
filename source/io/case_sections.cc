#include <taut/io/case_sections.h>

namespace taut::io
{
void declare_case(Declarations& all, const CaseText& text, CaseDraft& draft)
{
  study::Case& content = draft.content;
  all.section({}, "the case")
      .optional("Title", content.device.title, io::text("any text"),
                "what is simulated, for reports")
      .optional("Model", content.model, one_of({"film", "resonator"}),
                "finite elements of a device, or the lumped model of a "
                "resonator");
  const Entry* model = text.find({}, "Model");
  if (model && model->value == "resonator")
  {
    all.allow_section({}, "Lumped resonator", false);
    declare_lumped_resonator(all, content.lumped_resonator);
  }
  else
  {
    declare_materials(all, text, draft.materials);
    declare_device(all, text, draft);
  }
  declare_study(all, text, draft);
}
} // namespace taut::io
