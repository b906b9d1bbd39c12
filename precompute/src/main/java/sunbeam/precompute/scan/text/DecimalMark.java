package sunbeam.precompute.scan.text;

/** Decimal mark of a text; if it is a point, commas separate numbers. */
public enum DecimalMark {
    POINT,
    COMMA
}
