#pragma once

#include <taut/material/elastomer.h>

namespace taut::material
{
/// Checks every number of an elastomer. Errors: BadInput that names the spring
/// or network (counted from 1), the quantity, its value and what is allowed.
void validate(const Elastomer& elastomer);
} // namespace taut::material
