package sunbeam.precompute.scan;

import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;

/** One surface, asymmetric, not square, in whole nanometers, as a file in every readable format, written as documented. */
final class TestScans {
    static final int COLUMNS = 7;
    static final int ROWS = 5;
    static final double WIDTH = 3.5e-6;
    static final double HEIGHT = 2e-6;

    private TestScans() {}

    /** Returns meters, row by row from the top. */
    static double[] meters() {
        double[] meters = new double[COLUMNS * ROWS];
        for (int i = 0; i < meters.length; i++) {
            int column = i % COLUMNS;
            meters[i] = 1e-9 * (100 * (i / COLUMNS) + column * column - 150);
        }
        return meters;
    }

    static byte[] file(String format) throws IOException {
        try (InputStream file = TestScans.class.getResourceAsStream("field/" + format)) {
            return file.readAllBytes();
        }
    }

    static ChannelList channels(ScanBytes bytes) throws IOException {
        return ScanFormat.find(bytes, Optional.empty()).orElseThrow().open(bytes);
    }
}
