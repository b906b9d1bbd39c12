package sunbeam.precompute.scan.text;

import java.io.IOException;
import java.io.Reader;
import java.util.Arrays;
import java.util.Locale;
import java.util.Set;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;
import sunbeam.precompute.text.Quoted;

/**
 * Numbers of a text, one after the other, in constant memory. They are separated by blanks, tabs, semicolons or, where
 * it is no decimal mark, commas; an empty field between two separators is a missing sample.
 */
public final class NumberStream {
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

    private final Reader in;
    private final boolean decimalComma;
    private final char[] buffer = new char[1 << 14];
    private final StringBuilder word = new StringBuilder();
    private int position;
    private int limit;
    private long line;
    private double value;
    private boolean firstOfLine;
    private boolean lineBegins = true;

    /**
     * @param in at the begin of a line
     * @param line number of that line, for messages
     */
    public NumberStream(Reader in, boolean decimalComma, long line) {
        this.in = in;
        this.decimalComma = decimalComma;
        this.line = line;
    }

    /**
     * The next numbers, NaN for missing samples.
     *
     * @throws ScanException when there are fewer, or something else
     */
    public double[] read(long count) throws IOException {
        // Grows with what is there: a header may claim more than the file has.
        double[] numbers = new double[(int) Math.min(count, 1 << 16)];
        for (int i = 0; i < Math.min(count, ScanLimits.MOST_SAMPLES); i++) {
            if (!next()) {
                throw new ScanException(String.format(
                        Locale.ROOT,
                        "has %d numbers where its header announces %d; copy or export it again",
                        i,
                        count));
            }
            if (i == numbers.length) {
                numbers = Arrays.copyOf(numbers, (int) Math.min(count, 2L * numbers.length));
            }
            numbers[i] = value;
        }
        return numbers;
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
            } else if (isSeparator(c)) {
                if (separated) {
                    return found(Double.NaN);
                }
                // The separator after the number before has been passed already.
                separated = true;
            } else if (!isBlank(c)) {
                position--;
                readWord();
                return found(parse());
            }
        }
        return false;
    }

    private boolean isSeparator(int c) {
        return c == ';' || (c == ',' && !decimalComma);
    }

    private static boolean isBlank(int c) {
        return c == ' ' || c == '\t' || c == '"' || c == '\f';
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
            limit = Math.max(0, in.read(buffer));
            position = 0;
            if (limit == 0) {
                return -1;
            }
        }
        return buffer[position++];
    }

    /** Everything up to a separator or line's end, which is left to be read, save a separator. */
    private void readWord() throws IOException {
        word.setLength(0);
        for (int c = read(); c >= 0; c = read()) {
            if (c == '\n' || c == '\r') {
                position--;
            }
            if (c == '\n' || c == '\r' || isBlank(c) || isSeparator(c)) {
                break;
            }
            if (word.length() == LONGEST_WORD) {
                throw new ScanException(String.format(
                        Locale.ROOT,
                        "has a word of more than %d characters in line %d, which is no number",
                        LONGEST_WORD,
                        line));
            }
            word.append(c == ',' ? '.' : (char) c);
        }
        // Of 1,5, 2,5 the comma before the blank.
        if (decimalComma && word.length() > 1 && word.charAt(word.length() - 1) == '.') {
            word.setLength(word.length() - 1);
        }
    }

    private double parse() {
        String text = word.toString();
        // Double.parseDouble alone takes 1d, 0x1p3 and Infinity, too.
        if (text.chars().allMatch(c -> (c >= '0' && c <= '9') || "+-.eE".indexOf(c) >= 0)) {
            try {
                return Double.parseDouble(text);
            } catch (NumberFormatException none) {
                // Told below.
            }
        }
        if (MISSING.contains(text.toLowerCase(Locale.ROOT))) {
            return Double.NaN;
        }
        throw new ScanException(String.format(
                Locale.ROOT,
                "has %s in line %d, where a number should be; remove it, or say which mark its decimals have",
                Quoted.of(text),
                line));
    }
}
