/**
 * Common parts of the readers of instruments' files: checked access to bytes, channels with units, and the choice of the height channel.
 * The readers are in {@code scan.format}.
 */
package sunbeam.precompute.scan;
