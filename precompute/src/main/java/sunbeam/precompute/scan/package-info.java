/** Readers of instruments' files: checked access to bytes, channels with units, and the choice of the height channel. */
package sunbeam.precompute.scan;
