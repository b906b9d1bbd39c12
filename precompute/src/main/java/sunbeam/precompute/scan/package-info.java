/**
 * What every reader of instruments' files shares: bytes that are checked before they are trusted, channels with their own
 * scale, and the choice among them. The readers themselves stand in {@code scan.format}.
 */
package sunbeam.precompute.scan;
