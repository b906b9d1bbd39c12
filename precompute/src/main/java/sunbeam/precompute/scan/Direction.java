package sunbeam.precompute.scan;

/** Which way the tip went along a line while a channel was recorded. */
public enum Direction {
    /** Forward. */
    TRACE,
    /** Backward. */
    RETRACE,
    /** The file does not say. */
    UNKNOWN
}
