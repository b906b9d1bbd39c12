package sunbeam.precompute.setting;

/**
 * Resource of the machine that a choice exceeds.
 *
 * @param words end of a sentence that begins with "this plan": what the choice needs, and what there is
 * @param heapBytes size of Java's heap that would suffice, bytes; 0 for limits of graphics drivers, which no option moves
 */
public record Excess(String words, long heapBytes) {
    public static Excess ofDriver(String words) {
        return new Excess(words, 0);
    }

    /** True if a larger heap would do. */
    public boolean isOfMemory() {
        return heapBytes > 0;
    }
}
