#pragma once

#include <taut/structure/description.h>

namespace taut::structure
{
/// The device with the fibres of its films in their materials, unstrained in
/// the mesh.
Device add_fibres(Device device);
} // namespace taut::structure
