package sunbeam.precompute.scan.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Set;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.text.Quoted;

/**
 * Numbers of a text, one after the other, in constant memory. They are separated by blanks, tabs, semicolons or, where
 * it is no decimal mark, commas; an empty field between two separators is a missing sample.
 */
final class NumberStream {
    private static final Set<String> MISSING = Set.of(
            "nan",
            "-nan",
            "nan(ind)",
            "-nan(ind)",
            "inf",
            "-inf",
            "+inf",
            "infinity",
            "-infinity",
            "bad",
            "---",
            "--",
            "#n/a",
            "n/a");
    private static final int LONGEST_WORD = 100;
    /** A long holds all numbers of 18 digits. */
    private static final long MOST_MANTISSA = 99_999_999_999_999_999L;

    private static final long EXACT_MANTISSA = 1L << 53;
    private static final double[] POWERS_OF_TEN = new double[23];

    static {
        for (int i = 0; i < POWERS_OF_TEN.length; i++) {
            POWERS_OF_TEN[i] = Double.parseDouble("1e" + i);
        }
    }

    private final InputStream in;
    private final boolean decimalComma;
    private final byte[] buffer = new byte[1 << 16];
    private final byte[] word = new byte[LONGEST_WORD];
    private int position;
    private int limit;
    private int wordLength;
    private long line;
    private double value;
    private boolean firstOfLine;
    private boolean lineBegins = true;

    /**
     * @param in at the begin of a line
     * @param line number of that line, for messages
     */
    NumberStream(InputStream in, boolean decimalComma, long line) {
        this.in = in;
        this.decimalComma = decimalComma;
        this.line = line;
    }

    /**
     * Goes to the next number; false when there is none.
     *
     * @throws ScanException when there is something else
     */
    boolean next() throws IOException {
        boolean separated = false;
        for (int c = read(); c >= 0; c = read()) {
            if (c == '\n' || c == '\r') {
                line += c == '\n' ? 1 : 0;
                lineBegins = true;
                separated = false;
            } else if (c == ';' || (c == ',' && !decimalComma)) {
                if (separated) {
                    return found(Double.NaN);
                }
                // The separator after the number before has been passed already.
                separated = true;
            } else if (c != ' ' && c != '\t' && c != '"' && c != '\f') {
                position--;
                readWord();
                return found(parse());
            }
        }
        return false;
    }

    private boolean found(double number) {
        value = number;
        firstOfLine = lineBegins;
        lineBegins = false;
        return true;
    }

    /** The number, NaN for a missing sample. */
    double value() {
        return value;
    }

    /** Whether the number is the first of its line. */
    boolean firstOfLine() {
        return firstOfLine;
    }

    /** The line that the number stands in. */
    long line() {
        return line;
    }

    private int read() throws IOException {
        if (position == limit) {
            limit = in.read(buffer);
            position = 0;
            if (limit <= 0) {
                limit = 0;
                return -1;
            }
        }
        return buffer[position++];
    }

    /** Everything up to a separator or line's end, which is left to be read, save a semicolon or comma. */
    private void readWord() throws IOException {
        wordLength = 0;
        for (int c = read(); c >= 0; c = read()) {
            if (c == ' '
                    || c == '\t'
                    || c == '\n'
                    || c == '\r'
                    || c == '"'
                    || c == ';'
                    || (c == ',' && !decimalComma)) {
                if (c == '\n' || c == '\r') {
                    position--;
                }
                dropSeparator();
                return;
            }
            if (wordLength == LONGEST_WORD) {
                throw new ScanException(String.format(
                        Locale.ROOT,
                        "has a word of more than %d characters in line %d, which is no number",
                        LONGEST_WORD,
                        line));
            }
            word[wordLength++] = (byte) c;
        }
    }

    /** Of 1,5, 2,5 the comma before the blank. */
    private void dropSeparator() {
        if (decimalComma && wordLength > 1 && word[wordLength - 1] == ',') {
            wordLength--;
        }
    }

    private double parse() {
        int i = 0;
        boolean negative = word[0] == '-';
        if (negative || word[0] == '+') {
            i++;
        }
        long mantissa = 0;
        int digits = 0;
        int power = 0;
        boolean fraction = false;
        for (; i < wordLength; i++) {
            int c = word[i];
            if (c >= '0' && c <= '9' && mantissa <= MOST_MANTISSA) {
                mantissa = 10 * mantissa + (c - '0');
                digits++;
                power -= fraction ? 1 : 0;
            } else if ((c == '.' || (c == ',' && decimalComma)) && !fraction) {
                fraction = true;
            } else {
                break;
            }
        }
        if (i < wordLength && digits > 0 && (word[i] == 'e' || word[i] == 'E')) {
            int exponent = exponent(i + 1);
            if (exponent == Integer.MIN_VALUE) {
                return slowly();
            }
            power += exponent;
            i = wordLength;
        }
        boolean exact = mantissa <= EXACT_MANTISSA && Math.abs(power) < POWERS_OF_TEN.length;
        if (i < wordLength || digits == 0 || !exact) {
            return slowly();
        }
        double magnitude = power < 0 ? mantissa / POWERS_OF_TEN[-power] : mantissa * POWERS_OF_TEN[power];
        return negative ? -magnitude : magnitude;
    }

    /** Integer.MIN_VALUE when the word does not end with an exponent of up to three digits. */
    private int exponent(int from) {
        int i = from;
        boolean negative = i < wordLength && word[i] == '-';
        if (negative || (i < wordLength && word[i] == '+')) {
            i++;
        }
        int exponent = 0;
        int first = i;
        for (; i < wordLength && word[i] >= '0' && word[i] <= '9' && i - first < 3; i++) {
            exponent = 10 * exponent + (word[i] - '0');
        }
        return i < wordLength || i == first ? Integer.MIN_VALUE : negative ? -exponent : exponent;
    }

    private double slowly() {
        String text = new String(word, 0, wordLength, StandardCharsets.ISO_8859_1);
        if (MISSING.contains(text.toLowerCase(Locale.ROOT))) {
            return Double.NaN;
        }
        return HeaderText.number(text)
                .orElseThrow(() -> new ScanException(String.format(
                        Locale.ROOT, "has %s in line %d, where a number should be", Quoted.of(text), line)));
    }
}
