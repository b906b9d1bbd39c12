package sunbeam.precompute.scan.text;

import sunbeam.precompute.scan.ScanException;

/**
 * Whether commas between whole numbers may be decimal marks as well as separators: 1,50,2,25 is 1.50 and 2.25 where whoever wrote it
 * used them for both. Every second number is a fraction then: it has no sign, though others have; or always as many digits, though
 * others have not.
 */
final class CommaHalves {
    // By chance, of numbers of either sign or of two lengths, once in 2^20.
    private static final int SIGNS = 20;
    // Nobody writes 05 who means 5.
    private static final int LEADING_ZEROS = 3;

    // Of every second number: 0 before the first.
    private int digits;
    private int leadingZeros;
    private int otherDigits;
    private boolean digitsVary;
    private int signs;

    private CommaHalves() {}

    /**
     * Looks at lines of whole numbers between commas.
     *
     * @param text all or the first lines of it
     * @param start of the first line of numbers
     * @throws ScanException where they may be halves
     */
    static void refuse(byte[] text, int start) {
        CommaHalves halves = new CommaHalves();
        int field = 0;
        int from = start;
        for (int i = start; i < text.length; i++) {
            boolean lineEnds = text[i] == '\n' || text[i] == '\r';
            if (text[i] != ',' && !lineEnds) {
                continue;
            }
            boolean empty = i == from;
            if (!empty && !halves.take(text, from, i, field)) {
                return;
            }
            field += empty ? 0 : 1;
            if (lineEnds && !empty && field % 2 == 1) {
                // A whole number of numbers has halves in pairs.
                return;
            }
            field = lineEnds ? 0 : field;
            from = i + 1;
        }
        if (halves.areLikely()) {
            throw new ScanException(
                    "has commas that may be decimal marks or separators: every second number looks like a fraction,"
                            + " so 1,5 may be one number or two; export it with decimal points, or with semicolons between the numbers");
        }
    }

    private boolean areLikely() {
        return signs >= SIGNS || leadingZeros >= LEADING_ZEROS || (!digitsVary && otherDigits >= SIGNS);
    }

    /** False where this cannot be what it is looked for. */
    private boolean take(byte[] text, int from, int end, int field) {
        boolean sign = text[from] == '-' || text[from] == '+';
        int length = end - from - (sign ? 1 : 0);
        if (field % 2 == 0) {
            signs += sign ? 1 : 0;
            otherDigits += digits != 0 && length != digits ? 1 : 0;
            return true;
        }
        digits = digits == 0 ? length : digits;
        digitsVary |= length != digits;
        leadingZeros += length > 1 && text[from] == '0' ? 1 : 0;
        return !sign;
    }
}
