/** Fourier tables as HDF5 files. */
package sunbeam.app.cli.precompute;
