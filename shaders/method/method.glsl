// The one place that chooses a diffraction method. What methods share is included here, outside any condition.
#include "include/complex.glsl"
#include "include/expansion.glsl"
#include "include/spectrum.glsl"
#include "include/wavelengths.glsl"
#include "include/window.glsl"

#if METHOD == METHOD_FULL_BINS || METHOD == METHOD_FULL_ORDERS
#include "method/neighbourhood.glsl"
#endif

#if METHOD == METHOD_FULL_BINS
#include "method/full_bins.glsl"
#elif METHOD == METHOD_FULL_ORDERS
#include "method/full_orders.glsl"
#elif METHOD == METHOD_FULL_GRID
#include "method/full_grid.glsl"
#endif
