/** Checksums, file names, path restrictions and refusals for all file formats. */
package sunbeam.precompute.files;
