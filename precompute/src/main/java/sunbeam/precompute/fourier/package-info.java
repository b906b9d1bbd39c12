/** Discrete Fourier transforms of any length, limited to a band of frequencies, built on the FFT of Apache Commons Math. */
package sunbeam.precompute.fourier;
