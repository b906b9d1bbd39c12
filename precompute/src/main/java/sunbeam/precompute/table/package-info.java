/** Fourier tables of a patch's expansion terms, and their files for other programs. */
package sunbeam.precompute.table;
