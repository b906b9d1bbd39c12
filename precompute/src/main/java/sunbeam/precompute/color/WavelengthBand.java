package sunbeam.precompute.color;

import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** Part of the visible band that a filter passes, or a spectral line, which is a nanometer wide. */
public record WavelengthBand(double firstNanometers, double lastNanometers) {
    private static final double LINE_NANOMETERS = 1;
    private static final String REMEDY = "; give a wavelength, 532nm, or a band, 500nm..600nm";
    public static final WavelengthBand VISIBLE = new WavelengthBand(CieTable.FIRST_NANOMETER, CieTable.LAST_NANOMETER);

    public WavelengthBand {
        if (!(firstNanometers >= CieTable.FIRST_NANOMETER && lastNanometers <= CieTable.LAST_NANOMETER)) {
            throw new IllegalArgumentException("reaches beyond 380 to 780 nm");
        }
        if (lastNanometers < firstNanometers) {
            throw new IllegalArgumentException("is reversed");
        }
        if (!(lastNanometers - firstNanometers >= LINE_NANOMETERS - 1e-6)) {
            throw new IllegalArgumentException("is narrower than 1 nm, which a single wavelength stands for");
        }
    }

    /** Parses {@code 532nm} or {@code 500nm..600nm}; throws IllegalArgumentException for other texts. */
    public static WavelengthBand parse(String text) {
        String[] ends = text.strip().split("\\.\\.", -1);
        if (ends.length > 2) {
            throw new IllegalArgumentException(Text.quoted(text) + " is neither a wavelength nor a band" + REMEDY);
        }
        double first = nanometers(ends[0]);
        double last = ends.length == 2 ? nanometers(ends[1]) : first + LINE_NANOMETERS / 2;
        if (ends.length == 1 && first >= CieTable.FIRST_NANOMETER && first <= CieTable.LAST_NANOMETER) {
            // A line at an end of the visible band is shifted inside.
            first = Math.max(
                    CieTable.FIRST_NANOMETER,
                    Math.min(CieTable.LAST_NANOMETER - LINE_NANOMETERS, first - LINE_NANOMETERS / 2));
            last = first + LINE_NANOMETERS;
        }
        try {
            return new WavelengthBand(first, last);
        } catch (IllegalArgumentException wrong) {
            throw new IllegalArgumentException(Text.quoted(text) + " " + wrong.getMessage() + REMEDY, wrong);
        }
    }

    /** Rounds to a thousandth, which {@link #toString} can write. */
    private static double nanometers(String text) {
        try {
            return Math.rint(1e12 * Lengths.parse(text)) / 1e3;
        } catch (IllegalArgumentException wrong) {
            throw new IllegalArgumentException(wrong.getMessage() + REMEDY, wrong);
        }
    }

    /** Returns the share of the nanometer around a wavelength that lies in the band; at 380 and 780, of half a nanometer. */
    double coverage(int nanometers) {
        double first = Math.max(CieTable.FIRST_NANOMETER, nanometers - 0.5);
        double last = Math.min(CieTable.LAST_NANOMETER, nanometers + 0.5);
        return Math.max(0, Math.min(last, lastNanometers) - Math.max(first, firstNanometers)) / (last - first);
    }

    @Override
    public String toString() {
        return lastNanometers - firstNanometers <= LINE_NANOMETERS + 1e-6
                ? number(0.5 * (firstNanometers + lastNanometers)) + "nm"
                : number(firstNanometers) + "nm.." + number(lastNanometers) + "nm";
    }

    private static String number(double nanometers) {
        return Text.format("%.3f", nanometers).replaceFirst("\\.?0+$", "");
    }

    /** Spectral bands at equal steps of 2 nm or more, with triangles between the neighbors' wavelengths as weights, which add up to 1. */
    public record SpectralBands(WavelengthBand range, int count) {
        /** Number of bands in one {@link CieTable}: its three channels. */
        public static final int TOGETHER = 3;

        private static final double LEAST_STEP = 2;

        public SpectralBands {
            int most = 1 + (int) ((range.lastNanometers() - range.firstNanometers()) / LEAST_STEP);
            if (count < 2 || count > most) {
                throw new IllegalArgumentException(count + " is out of range; "
                        + (most < 2 ? range + " is too narrow for any" : "give 2 to " + most));
            }
        }

        /** Nanometers. */
        public double step() {
            return (range.lastNanometers() - range.firstNanometers()) / (count - 1);
        }

        public double[] nanometers() {
            return IntStream.range(0, count)
                    .mapToDouble(band -> range.firstNanometers() + band * step())
                    .toArray();
        }

        public int tables() {
            return (count + TOGETHER - 1) / TOGETHER;
        }

        /** Returns the weights of the bands from {@code TOGETHER * number} on, as the channels of a table; zero beyond the last band. */
        public CieTable table(int number) {
            double[] centers = nanometers();
            double[][] weights = new double[Illuminant.LAST + 1][TOGETHER];
            for (int c = 0; c < TOGETHER; c++) {
                int band = TOGETHER * number + c;
                if (band < count) {
                    double[] triangle = triangle(centers[band]);
                    // The ends count half.
                    double integral = DoubleStream.of(triangle).sum() - 0.5 * (triangle[0] + triangle[Illuminant.LAST]);
                    for (int i = 0; i <= Illuminant.LAST; i++) {
                        weights[i][c] = triangle[i] / integral;
                    }
                }
            }
            // The integral of each weight function, in place of Y, is a nanometer.
            return new CieTable(weights, 1e-9, count + " bands, " + range, false);
        }

        private double[] triangle(double center) {
            return IntStream.rangeClosed(0, Illuminant.LAST)
                    .mapToDouble(i -> CieTable.FIRST_NANOMETER + i)
                    .map(at -> at < range.firstNanometers() || at > range.lastNanometers()
                            ? 0
                            : Math.max(0, 1 - Math.abs(at - center) / step()))
                    .toArray();
        }
    }
}
