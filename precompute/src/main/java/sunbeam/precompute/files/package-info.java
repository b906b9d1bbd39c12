/** What files of any kind share: checksums, and which other files they may name. */
package sunbeam.precompute.files;
