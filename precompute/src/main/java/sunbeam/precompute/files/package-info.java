/** Checksums, file names and path restrictions for all file formats. */
package sunbeam.precompute.files;
