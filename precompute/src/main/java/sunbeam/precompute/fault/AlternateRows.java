package sunbeam.precompute.fault;

import java.util.Arrays;
import java.util.List;
import sunbeam.precompute.fourier.Band;
import sunbeam.precompute.fourier.BandTransform;
import sunbeam.precompute.fourier.ComplexVector;

/**
 * Rows of which every second is shifted sideways, as where trace and retrace are mixed. The strongest wave along the rows then turns
 * by one phase from each even row to the next, and by another from each odd one. On a surface it turns by the same from any row
 * to the next, so that both means agree. A shift by half of its period cannot be seen: a wave of two samples a period looks alike.
 */
final class AlternateRows {
    static final String WORDS =
            "every second row lies shifted sideways against those between, as where trace and retrace are"
                    + " mixed (save one of them alone)";

    // Waves that fit fewer times along a row are tilt and bow.
    private static final int FEWEST_PERIODS = 3;
    private static final int FEWEST_COLUMNS = 16;
    private static final int FEWEST_ROWS = 32;
    // In the middle of the scan: their means are known to a twentieth of the wave.
    private static final int MOST_ROWS = 512;
    // Difference of both means over the wave's power, 2 |sin| of the phase that the shift makes: a shift by 1.6 % of
    // the
    // period. Walls that samples round to one side or the other make 0.1.
    private static final double LEAST = 0.2;
    // In standard errors of that difference.
    private static final double STANDS_OUT = 8;
    // Of the pairs of rows: a scan that was stretched has each row several times, and its rows alternate for that.
    private static final double MOST_COPIES = 0.25;
    // Of the wave's power: rounding.
    private static final double SAME = 1e-10;

    private final Measured scan;
    private final int firstRow;
    private final int rows;

    AlternateRows(Measured scan) {
        this.scan = scan;
        this.rows = Math.min(scan.rows(), MOST_ROWS);
        this.firstRow = (scan.rows() - rows) / 2;
    }

    /** One or none. */
    List<ScanFault> faults() {
        boolean large = scan.columns() >= FEWEST_COLUMNS && rows >= FEWEST_ROWS;
        return large && isShifted(strongestWave()) ? List.of(ScanFault.ofAllRows(WORDS)) : List.of();
    }

    /** Complex amplitudes of the wave that is strongest over all rows, one for each row. */
    private ComplexVector strongestWave() {
        Band band = Band.of(FEWEST_PERIODS, scan.columns() / 2);
        BandTransform transform = new BandTransform(scan.columns(), band);
        ComplexVector waves = ComplexVector.zeros(rows * band.count());
        ComplexVector work = transform.workspace();
        double[] power = new double[band.count()];
        for (int row = 0; row < rows; row++) {
            Arrays.fill(work.real(), 0);
            Arrays.fill(work.imaginary(), 0);
            take(firstRow + row, work.real());
            transform.transform(work, waves, row * band.count(), 1);
            for (int bin = 0; bin < band.count(); bin++) {
                power[bin] += squared(waves, row * band.count() + bin);
            }
        }
        int strongest = 0;
        for (int bin = 1; bin < band.count(); bin++) {
            strongest = power[bin] > power[strongest] ? bin : strongest;
        }
        ComplexVector wave = ComplexVector.zeros(rows);
        for (int row = 0; row < rows; row++) {
            wave.real()[row] = waves.real()[row * band.count() + strongest];
            wave.imaginary()[row] = waves.imaginary()[row * band.count() + strongest];
        }
        return wave;
    }

    /** A row less its mean and slope under a Hann window; nothing of one that lacks samples. */
    private void take(int row, double[] target) {
        int columns = scan.columns();
        double mean = 0;
        double moment = 0;
        for (int column = 0; column < columns; column++) {
            mean += scan.at(column, row) / columns;
            moment += scan.at(column, row) * (column - 0.5 * (columns - 1));
        }
        if (!Double.isFinite(mean)) {
            return;
        }
        double slope = 12 * moment / (columns * ((double) columns * columns - 1));
        for (int column = 0; column < columns; column++) {
            double rest = scan.at(column, row) - mean - slope * (column - 0.5 * (columns - 1));
            target[column] = rest * Math.pow(Math.sin(Math.PI * (column + 0.5) / columns), 2);
        }
    }

    private boolean isShifted(ComplexVector wave) {
        Turns[] turns = {new Turns(), new Turns()};
        double power = 0;
        int copies = 0;
        for (int row = 0; row + 1 < rows; row++) {
            double here = squared(wave, row);
            double away = Math.pow(wave.real()[row + 1] - wave.real()[row], 2)
                    + Math.pow(wave.imaginary()[row + 1] - wave.imaginary()[row], 2);
            copies += here > 0 && away < SAME * here ? 1 : 0;
            power += here / (rows - 1);
            turns[row % 2].add(wave, row);
        }
        double difference = Math.hypot(turns[0].real() - turns[1].real(), turns[0].imaginary() - turns[1].imaginary());
        double error = Math.sqrt(turns[0].squaredError() + turns[1].squaredError());
        return copies < MOST_COPIES * rows && difference > LEAST * power && difference > STANDS_OUT * error;
    }

    private static double squared(ComplexVector wave, int at) {
        return wave.real()[at] * wave.real()[at] + wave.imaginary()[at] * wave.imaginary()[at];
    }

    /** Products of a row's conjugate amplitude with the next one's. */
    private static final class Turns {
        private int count;
        private double sumReal;
        private double sumImaginary;
        private double squares;

        void add(ComplexVector wave, int row) {
            double[] re = wave.real();
            double[] im = wave.imaginary();
            double real = re[row] * re[row + 1] + im[row] * im[row + 1];
            double imaginary = re[row] * im[row + 1] - im[row] * re[row + 1];
            count++;
            sumReal += real;
            sumImaginary += imaginary;
            squares += real * real + imaginary * imaginary;
        }

        double real() {
            return sumReal / count;
        }

        double imaginary() {
            return sumImaginary / count;
        }

        /** Of the mean. */
        double squaredError() {
            return Math.max(0, squares / count - real() * real() - imaginary() * imaginary()) / count;
        }
    }
}
