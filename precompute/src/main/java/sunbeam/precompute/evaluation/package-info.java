/** Gratings measured by their light: responses in a plane of directions, ridges in them, and the grating equation. */
package sunbeam.precompute.evaluation;
