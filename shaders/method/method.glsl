// The one place that chooses a diffraction method. What methods share is included here, outside any condition.
#include "include/complex.glsl"
#include "include/expansion.glsl"
#include "include/spectrum.glsl"
#include "include/wavelengths.glsl"
#include "include/window.glsl"

#if METHOD == METHOD_FULL_BINS || METHOD == METHOD_FULL_RAYS || METHOD == METHOD_FULL_ORDERS || METHOD == METHOD_NMM || METHOD == METHOD_NMM_THESIS
#include "method/neighbourhood.glsl"
#endif

#if METHOD == METHOD_FULL_GRID || METHOD == METHOD_PQ
#include "method/grid_tables.glsl"
#endif

#if METHOD == METHOD_FULL_BINS
#include "method/full_bins.glsl"
#elif METHOD == METHOD_FULL_RAYS
#include "method/full_rays.glsl"
#elif METHOD == METHOD_FULL_ORDERS
#include "method/full_orders.glsl"
#elif METHOD == METHOD_FULL_GRID
#include "method/full_grid.glsl"
#elif METHOD == METHOD_NMM
#include "method/nmm.glsl"
#elif METHOD == METHOD_NMM_THESIS
#include "method/nmm_thesis.glsl"
#elif METHOD == METHOD_PQ
#include "method/pq.glsl"
#elif METHOD == METHOD_GEM
#include "method/gem.glsl"
#endif
