package sunbeam.precompute.color;

import de.siegmar.fastcsv.reader.CommentStrategy;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import sunbeam.precompute.files.Sha256;

/**
 * CIE 1931 2-degree color matching functions (CIE 018:2019) times the relative power of illuminant D65 (ISO/CIE
 * 11664-2), tabulated every nanometre from 380 to 780 nm and linear between.
 */
public final class CieTable {
    /** Shortest wavelength of the table, metres. */
    public static final double MINIMUM_WAVELENGTH = 380e-9;

    /** Longest wavelength of the table, metres. */
    public static final double MAXIMUM_WAVELENGTH = 780e-9;

    private static final String RESOURCE = "/sunbeam/color/cie1931_d65_1nm.csv";
    private final double[][] weighted;
    private final double integralOfY;

    private CieTable(double[][] weighted, double integralOfY) {
        this.weighted = weighted;
        this.integralOfY = integralOfY;
    }

    /** Reads the table that comes with Sunbeam. */
    public static CieTable load() {
        try (CsvReader<NamedCsvRecord> rows = CsvReader.builder()
                .commentStrategy(CommentStrategy.SKIP)
                .ofNamedCsvRecord(CieTable.class.getResourceAsStream(RESOURCE), StandardCharsets.UTF_8)) {
            double[][] weighted = rows.stream().map(CieTable::weighted).toArray(double[][]::new);
            return new CieTable(weighted, integral(weighted));
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read " + RESOURCE, e);
        }
    }

    private static double[] weighted(NamedCsvRecord row) {
        double illuminant = Double.parseDouble(row.getField("d65"));
        return Stream.of("x_bar", "y_bar", "z_bar")
                .mapToDouble(name -> Double.parseDouble(row.getField(name)) * illuminant)
                .toArray();
    }

    /**
     * S xbar, S ybar and S zbar at a wavelength in metres, not normalised; zero outside 380..780 nm.
     *
     * @param channel 0 for X, 1 for Y, 2 for Z
     */
    public double at(double wavelength, int channel) {
        double position = (wavelength - MINIMUM_WAVELENGTH) * 1e9;
        int last = weighted.length - 1;
        // Rounding of metres to nanometres must not push an end point of the band off the table.
        if (position < -1e-6 || position > last + 1e-6) {
            return 0;
        }
        position = Math.min(last, Math.max(0, position));
        int index = Math.min(last - 1, (int) position);
        double fraction = position - index;
        return weighted[index][channel] * (1 - fraction) + weighted[index + 1][channel] * fraction;
    }

    /** SHA-256 of all values, in hexadecimal: equal for equal tables. */
    public String digest() {
        Sha256 digest = new Sha256();
        for (double[] row : weighted) {
            ByteBuffer bytes = ByteBuffer.allocate(row.length * Double.BYTES);
            bytes.asDoubleBuffer().put(row);
            digest.add(bytes);
        }
        return digest.hex();
    }

    /**
     * The same with the light's spectrum times a factor, which is not normalised away: white stays that of the light itself.
     *
     * @param factor of a wavelength in metres, at each nanometre; linear between
     */
    public CieTable times(DoubleUnaryOperator factor) {
        double[][] product = new double[weighted.length][3];
        for (int i = 0; i < product.length; i++) {
            double value = factor.applyAsDouble(MINIMUM_WAVELENGTH + i * 1e-9);
            for (int channel = 0; channel < 3; channel++) {
                product[i][channel] = value * weighted[i][channel];
            }
        }
        return new CieTable(product, integralOfY);
    }

    /**
     * Integral of S ybar over the band (trapezoid on the 1 nm table, exact for linear interpolation), in metres; of the light
     * before any factor.
     */
    public double integralOfY() {
        return integralOfY;
    }

    private static double integral(double[][] weighted) {
        double sum = 0;
        for (int i = 0; i + 1 < weighted.length; i++) {
            sum += 0.5 * (weighted[i][1] + weighted[i + 1][1]);
        }
        return sum * 1e-9;
    }
}
