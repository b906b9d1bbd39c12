/** Small numerics that several rooms share. */
package sunbeam.precompute.numerics;
