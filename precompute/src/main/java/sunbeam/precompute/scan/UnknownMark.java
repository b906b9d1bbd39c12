package sunbeam.precompute.scan;

/** Refusal of a text whose commas may be decimal marks or separate thousands. */
public final class UnknownMark extends ScanException {
    private static final long serialVersionUID = 1;

    UnknownMark() {
        super("has commas and points in a line, as thousands separators are; export it without them");
    }
}
