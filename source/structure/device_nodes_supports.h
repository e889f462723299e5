#pragma once

#include <taut/base/exceptions.h>
#include <taut/structure/device_nodes.h>

#include <string>

namespace taut::structure
{
/// Throws BadInput that points to an entry of the description.
[[noreturn]] inline void refuse(const Named& entry, const std::string& message)
{
  throw BadInput(message, "", entry.source_line, entry.name);
}

/// Holds what the supports of the device hold, of films and frames. `bar_of`:
/// index of the bar by local node, or -1.
/// Errors: BadInput, see make_device_nodes.
void apply_supports(const Device& device, const fe::MeshData& mesh,
                    const dealii::DoFHandler<2, 3>& dof_handler,
                    const std::vector<int>& bar_of, DeviceNodes& result);
} // namespace taut::structure
