package sunbeam.precompute.scan.text;

/** Decimal mark of a text; the other character separates numbers. */
public enum DecimalMark {
    POINT,
    COMMA
}
