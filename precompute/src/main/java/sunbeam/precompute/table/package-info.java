/** Fourier tables of a patch's expansion terms: how they are made, kept in files and found again. */
package sunbeam.precompute.table;
