// The one place that chooses a diffraction method. What all methods share is included here, outside any condition.
#include "include/complex.glsl"
#include "include/expansion.glsl"
#include "include/wavelengths.glsl"
#include "include/window.glsl"

#if METHOD == METHOD_FULL
#include "method/full.glsl"
#endif
