/** Analysis of height maps: power spectrum, periods, their effect on color, and the scalar model's balance of energy. */
package sunbeam.precompute.analysis;
