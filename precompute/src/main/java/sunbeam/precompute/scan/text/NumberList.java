package sunbeam.precompute.scan.text;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.Locale;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanLimits;

/** A known count of numbers in a text, with decimal points. */
public final class NumberList {
    private NumberList() {}

    /**
     * The numbers, NaN for missing samples.
     *
     * @param line that the stream stands in, for messages
     * @throws ScanException when there are fewer, or something else
     */
    public static double[] read(InputStream in, long count, long line) throws IOException {
        NumberStream stream = new NumberStream(in, false, line);
        // Grows with what is there: a header may claim more than the file has.
        double[] numbers = new double[(int) Math.min(count, 1 << 16)];
        for (int i = 0; i < Math.min(count, 3 * ScanLimits.MOST_SAMPLES); i++) {
            if (!stream.next()) {
                throw new ScanException(String.format(
                        Locale.ROOT,
                        "has %d numbers where its header announces %d; copy or export it again",
                        i,
                        count));
            }
            if (i == numbers.length) {
                numbers = Arrays.copyOf(numbers, (int) Math.min(count, 2L * numbers.length));
            }
            numbers[i] = stream.value();
        }
        return numbers;
    }
}
