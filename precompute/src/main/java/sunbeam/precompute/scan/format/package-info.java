/** Readers of instruments' files, one per format, and their list. */
package sunbeam.precompute.scan.format;
