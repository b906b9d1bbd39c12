package sunbeam.precompute.color;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.text.Sha256;

/**
 * CIE 1931 2-degree colour matching functions (CIE 018:2019) times the relative power of illuminant D65 (ISO/CIE
 * 11664-2), tabulated every nanometre from 380 to 780 nm and linear between.
 */
public final class CieTable {
    /** Shortest wavelength of the table, metres. */
    public static final double MINIMUM_WAVELENGTH = 380e-9;

    /** Longest wavelength of the table, metres. */
    public static final double MAXIMUM_WAVELENGTH = 780e-9;

    private static final String RESOURCE = "/sunbeam/color/cie1931_d65_1nm.csv";
    private final double[][] weighted;

    private CieTable(double[][] weighted) {
        this.weighted = weighted;
    }

    /** Reads the table that comes with Sunbeam. */
    public static CieTable load() {
        List<double[]> rows = new ArrayList<>();
        try (InputStream stream = CieTable.class.getResourceAsStream(RESOURCE);
                BufferedReader reader = new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8))) {
            reader.lines()
                    .filter(line -> !line.startsWith("#") && !line.startsWith("wavelength"))
                    .forEach(line -> rows.add(parse(line)));
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read " + RESOURCE, e);
        }
        return new CieTable(rows.toArray(double[][]::new));
    }

    private static double[] parse(String line) {
        String[] cells = line.split(",", -1);
        double illuminant = Double.parseDouble(cells[4]);
        return new double[] {
            Double.parseDouble(cells[1]) * illuminant,
            Double.parseDouble(cells[2]) * illuminant,
            Double.parseDouble(cells[3]) * illuminant
        };
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
        MessageDigest digest = Sha256.digest();
        for (double[] row : weighted) {
            ByteBuffer bytes = ByteBuffer.allocate(row.length * Double.BYTES);
            bytes.asDoubleBuffer().put(row);
            digest.update(bytes);
        }
        return Sha256.hexadecimal(digest);
    }

    /** Integral of S ybar over the band (trapezoid on the 1 nm table, exact for linear interpolation), in metres. */
    public double integralOfY() {
        double sum = 0;
        for (int i = 0; i + 1 < weighted.length; i++) {
            sum += 0.5 * (weighted[i][1] + weighted[i + 1][1]);
        }
        return sum * 1e-9;
    }
}
