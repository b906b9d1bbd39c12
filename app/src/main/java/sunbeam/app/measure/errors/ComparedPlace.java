package sunbeam.app.measure.errors;

import sunbeam.app.gpu.directions.DirectionsRenderer.Query;

/**
 * A place that a certificate looked at.
 *
 * @param query its directions, and its wavelength where powers are compared
 * @param comparison of what was computed there
 */
record ComparedPlace(Query query, Comparison comparison) {}
