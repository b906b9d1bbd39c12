package sunbeam.precompute.color;

import de.siegmar.fastcsv.reader.CommentStrategy;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.apache.commons.math3.util.MathArrays;
import sunbeam.precompute.files.Sha256;

/**
 * Color matching functions of an observer times the relative power of a light, at each nanometer from 380 to 780 nm, linear between.
 *
 * @param weighted {@code [nanometers - 380][channel]}: S xbar, S ybar and S zbar, where S is the light's power
 * @param integralOfY integral of S ybar over the band in meters; {@link #times} does not change it
 * @param isSmooth whether the light's spectrum is as smooth as daylight, unlike lines of lamps and lasers
 */
public record CieTable(double[][] weighted, double integralOfY, String description, boolean isSmooth) {
    /** Ends of the visible band, nanometers and meters. */
    public static final int FIRST_NANOMETER = 380;

    public static final int LAST_NANOMETER = 780;
    public static final double MINIMUM_WAVELENGTH = FIRST_NANOMETER / 1e9;
    public static final double MAXIMUM_WAVELENGTH = LAST_NANOMETER / 1e9;
    /** Width of the band in 1 / lambda, 1 / meters. */
    public static final double BAND_WIDTH = 1 / MINIMUM_WAVELENGTH - 1 / MAXIMUM_WAVELENGTH;

    private static final String RESOURCE = "/sunbeam/color/cie_1nm.csv";
    private static final List<NamedCsvRecord> ROWS = rows();

    /** The CIE's standard observers (CIE 018:2019). */
    public enum Observer {
        /** CIE 1931, a field of 2 degrees, by which sRGB is defined. */
        CIE1931("CIE 1931, 2 degrees", ""),
        /** CIE 1964, a field of 10 degrees. */
        CIE1964("CIE 1964, 10 degrees", "_10");

        private final String label;
        private final String suffix;

        Observer(String label, String suffix) {
            this.label = label;
            this.suffix = suffix;
        }

        public String label() {
            return label;
        }

        /** Returns a color matching function at each nanometer from 380 to 780 nm; 0 for X, 1 for Y, 2 for Z. */
        private double[] matching(int channel) {
            return column("xyz".charAt(channel) + "_bar" + suffix);
        }
    }

    private static List<NamedCsvRecord> rows() {
        try (CsvReader<NamedCsvRecord> rows = CsvReader.builder()
                .commentStrategy(CommentStrategy.SKIP)
                .ofNamedCsvRecord(CieTable.class.getResourceAsStream(RESOURCE), StandardCharsets.UTF_8)) {
            return rows.stream().toList();
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read " + RESOURCE, e);
        }
    }

    static double[] column(String name) {
        return ROWS.stream()
                .mapToDouble(row -> Double.parseDouble(row.getField(name)))
                .toArray();
    }

    /** Returns the table of the CIE 1931 observer under D65, which define sRGB. */
    public static CieTable load() {
        return of(Observer.CIE1931, Illuminant.of("D65"));
    }

    public static CieTable of(Observer observer, Illuminant light) {
        double[][] weighted = new double[Illuminant.LAST + 1][3];
        for (int channel = 0; channel < 3; channel++) {
            double[] matching = observer.matching(channel);
            for (int i = 0; i < weighted.length; i++) {
                weighted[i][channel] = matching[i] * light.power()[i];
            }
        }
        return new CieTable(
                weighted, integral(weighted, 1), light.name() + ", observer " + observer.label, light.isSmooth());
    }

    /** Returns the table for a light through a filter; {@link WavelengthBand#VISIBLE} filters nothing. */
    public static CieTable of(Observer observer, Illuminant light, WavelengthBand band) {
        return of(observer, band.equals(WavelengthBand.VISIBLE) ? light : light.through(band));
    }

    /** Returns S xbar, S ybar or S zbar (channel 0, 1, 2) at a wavelength in meters; zero outside 380..780 nm. */
    public double at(double wavelength, int channel) {
        double position = (wavelength - MINIMUM_WAVELENGTH) * 1e9;
        int last = weighted.length - 1;
        // Rounding must not push an end point of the band off the table.
        if (position < -1e-6 || position > last + 1e-6) {
            return 0;
        }
        position = Math.min(last, Math.max(0, position));
        int index = Math.min(last - 1, (int) position);
        double fraction = position - index;
        return weighted[index][channel] * (1 - fraction) + weighted[index + 1][channel] * fraction;
    }

    /** Returns the shortest wavelength with light, in meters. */
    public double shortestWavelength() {
        return MINIMUM_WAVELENGTH + Math.max(0, lit().min().orElseThrow() - 1) * 1e-9;
    }

    /** Returns the longest wavelength with light, in meters. */
    public double longestWavelength() {
        return MINIMUM_WAVELENGTH + Math.min(weighted.length - 1, lit().max().orElseThrow() + 1) * 1e-9;
    }

    private IntStream lit() {
        return IntStream.range(0, weighted.length)
                .filter(i -> Arrays.stream(weighted[i]).anyMatch(value -> value != 0));
    }

    public String digest() {
        Sha256 digest = new Sha256();
        for (double[] row : weighted) {
            ByteBuffer bytes = ByteBuffer.allocate(row.length * Double.BYTES);
            bytes.asDoubleBuffer().put(row);
            digest.add(bytes);
        }
        return digest.hex();
    }

    /** Returns this table with the light's spectrum times a function of the wavelength in meters; Y stays relative to the former light. */
    public CieTable times(DoubleUnaryOperator factor) {
        double[][] product = IntStream.range(0, weighted.length)
                .mapToObj(i -> MathArrays.scale(factor.applyAsDouble(MINIMUM_WAVELENGTH + i * 1e-9), weighted[i]))
                .toArray(double[][]::new);
        return new CieTable(product, integralOfY, description, isSmooth);
    }

    private static double integral(double[][] weighted, int channel) {
        double sum = 0;
        for (int i = 0; i + 1 < weighted.length; i++) {
            sum += 0.5e-9 * (weighted[i][channel] + weighted[i + 1][channel]);
        }
        return sum;
    }

    /** Returns X, Y, Z of the light over the band; Y is 1 without a factor of {@link #times}. */
    public double[] white() {
        return IntStream.range(0, 3)
                .mapToDouble(c -> integral(weighted, c) / integralOfY)
                .toArray();
    }
}
