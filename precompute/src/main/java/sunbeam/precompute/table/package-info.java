/** Fourier tables of a patch's expansion terms: how they are made and written for other programs. */
package sunbeam.precompute.table;
