package sunbeam.precompute.patch;

/**
 * What is wrong with a scan as it was measured, for people.
 *
 * @param words what
 * @param remedy the options that leave it out or take it away; empty where none does
 * @param unmeasured 0..1: share of the scan's rows that are no measurement
 */
public record PatchFault(String words, String remedy, double unmeasured) {
    /** One line, without a full stop. */
    public String line() {
        return words + (remedy.isEmpty() ? "" : "; " + remedy);
    }
}
