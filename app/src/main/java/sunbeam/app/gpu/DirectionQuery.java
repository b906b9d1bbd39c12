package sunbeam.app.gpu;

import sunbeam.precompute.optics.DirectionPair;

/** Directions and wavelength in meters, which is ignored where colors are evaluated. */
public record DirectionQuery(DirectionPair pair, double wavelength) {}
