/** The readers of instruments' files, one a format, and the one list of them. */
package sunbeam.precompute.scan.format;
