/** Discrete Fourier transforms of any length and of any band of frequencies, over Apache Commons Math. */
package sunbeam.precompute.fourier;
