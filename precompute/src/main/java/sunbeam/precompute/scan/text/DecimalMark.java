package sunbeam.precompute.scan.text;

/** What separates a number's whole part from its fraction in a text; the other separates numbers. */
public enum DecimalMark {
    POINT,
    COMMA
}
