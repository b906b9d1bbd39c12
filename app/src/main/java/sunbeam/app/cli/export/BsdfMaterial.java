package sunbeam.app.cli.export;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import sunbeam.precompute.color.WavelengthBand;
import sunbeam.precompute.color.WavelengthBand.SpectralBands;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.numerics.Floats;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;

/**
 * A color grid in the RGL material format (Dupuy and Jakob 2018). For each first direction wi it has a slice: a map of half vectors h to
 * the unit square, and spectra over the square. The BRDF times the cosine of the second direction is spectrum / (4 wi.z h.z^2); this
 * division leaves the spectra smooth. Slices are ordered by the first direction's azimuth, then by its angle to the normal; all have the
 * same density of the square's rows over the half vector's azimuth.
 */
record BsdfMaterial(Shape shape, HalfVectors.Density azimuths, List<Slice> slices) {
    // Lower bound of the half vector's cosine in the divisor of the spectra.
    private static final double LEAST_COSINE = 0.05;
    private static final double NANOMETER = 1e-9;
    // Share of the square's rows that is distributed evenly over azimuths, so that dark azimuths have rows, too.
    private static final double EVEN_SHARE = 0.3;

    /**
     * Density of {@link HalfVectors}, spectra {@code [(band * side + row) * side + column]}, and the probability, not normalized, with which
     * readers sample each point of the square.
     */
    record Slice(float[] density, float[] spectra, float[] luminance) {}

    static BsdfMaterial of(Shape shape, List<ColorGrid> bands, TableMetadata metadata) {
        HalfVectors.Density azimuths = azimuths(metadata.grid(), shape.rows());
        List<Integer> numbers = IntStream.range(0, shape.slices()).boxed().toList();
        List<Slice> slices = metadata.setup().progress().map("Directions", numbers, number -> {
            double phi = shape.phi(number / shape.thetas());
            double theta = shape.theta(number % shape.thetas());
            HalfVectors map = HalfVectors.of(azimuths, phi, theta, shape.columns());
            Direction first = Direction.ofDegrees(Math.toDegrees(theta), Math.toDegrees(phi));
            double[] shares = DoubleStream.of(shape.bands().nanometers())
                    .map(nm -> metadata.divisor()
                            .map(found -> 1 / found.at(first, nm * NANOMETER))
                            .orElse(1.0))
                    .toArray();
            return new SliceBaker(shape, map, phi, theta, bands, shares).bake();
        });
        return new BsdfMaterial(shape, azimuths, slices);
    }

    /** Returns a density of rows that grows with the brightness of (u, v) at each azimuth. */
    private static HalfVectors.Density azimuths(ColorGrid grid, int rows) {
        double[] bright = new double[rows];
        double step = grid.shape().u().step();
        for (int row = 0; row < rows; row++) {
            double azimuth = HalfVectors.azimuth(row, rows);
            for (double r = 0; r < grid.shape().radius(); r += step) {
                double depth = Math.sqrt(4 - r * r);
                bright[row] += Math.sqrt(grid.xyz(-r * Math.cos(azimuth), -r * Math.sin(azimuth), -depth)[1]);
            }
        }
        double mean = Arrays.stream(bright, 0, rows - 1).average().orElseThrow();
        Arrays.setAll(bright, row -> mean > 0 ? EVEN_SHARE + (1 - EVEN_SHARE) * bright[row] / mean : 1);
        return HalfVectors.Density.of(bright);
    }

    /** Returns the factor 1 / h.z^2 by which readers multiply a spectrum, for the half vector's angle to the normal in radians. */
    static double normalFactor(double angle) {
        double cosine = Math.max(LEAST_COSINE, Math.cos(angle));
        return 1 / (cosine * cosine);
    }

    /** Evaluates the material as readers do: BRDF times the cosine of the second direction, 1/sr, for a wavelength in meters. */
    double eval(DirectionPair pair, double wavelength) {
        Direction wi = pair.wi();
        Direction sum = new Direction(-pair.u(), -pair.v(), -pair.w());
        double halfAngle = Math.atan2(Math.hypot(sum.x(), sum.y()), sum.z());
        double column = Math.sqrt(halfAngle * 2 / Math.PI) * (shape.columns() - 1);
        double row = (Math.atan2(sum.y(), sum.x()) + Math.PI) / (2 * Math.PI) * (shape.rows() - 1);
        double phi = (Math.atan2(wi.y(), wi.x()) + Math.PI) / (2 * Math.PI) * (shape.phis() - 1);
        double theta =
                Math.min(shape.thetas() - 1.0, Math.acos(Math.min(1, wi.z())) / shape.largest() * (shape.thetas() - 1));
        int below = Math.max(0, Math.min(shape.rows() - 2, (int) row));
        int first = below * shape.columns();
        float[] density = Floats.of(
                2 * shape.columns(),
                i -> between(phi, theta, slice -> slices.get(slice).density()[first + i]));
        double x = HalfVectors.row(density, shape.columns(), row - below).share(column) * (shape.side() - 1);
        double y = azimuths.share(row) * (shape.side() - 1);
        double[] bands = shape.bands().nanometers();
        double place = (wavelength / NANOMETER - bands[0]) / shape.bands().step();
        double band = Math.max(0, Math.min(bands.length - 1.0, place));
        double spectrum = between(phi, theta, slice -> at(slices.get(slice).spectra(), band, y, x));
        return spectrum * normalFactor(halfAngle) / (4 * wi.z());
    }

    private double between(double phi, double theta, IntToDoubleFunction value) {
        return ColorGrid.bilinear(
                phi, theta, shape.phis(), shape.thetas(), (i, j) -> value.applyAsDouble(i * shape.thetas() + j));
    }

    private double at(float[] values, double band, double y, double x) {
        int side = shape.side();
        int b = Math.max(0, Math.min(shape.bands().count() - 2, (int) band));
        int first = b * side * side;
        int second = first + side * side;
        return ColorGrid.mix(
                ColorGrid.bilinear(y, x, side, side, (i, j) -> values[first + i * side + j]),
                ColorGrid.bilinear(y, x, side, side, (i, j) -> values[second + i * side + j]),
                band - b);
    }

    /** @param shares factor of each band */
    private record SliceBaker(
            Shape shape, HalfVectors map, double phi, double theta, List<ColorGrid> bands, double[] shares) {
        // Least cosine of the second direction in the divisor of the luminance, which would be infinite at the horizon.
        private static final double LEAST_COSINE = 0.03;

        Slice bake() {
            int side = shape.side();
            float[] spectra = new float[shape.bands().count() * side * side];
            float[] luminance = new float[side * side];
            for (int i = 0; i < side; i++) {
                double row = map.azimuths().place((double) i / (side - 1));
                HalfVectors.Density along = HalfVectors.row(map.density(), shape.columns(), row);
                for (int j = 0; j < side; j++) {
                    double column = along.place((double) j / (side - 1));
                    luminance[i * side + j] = fill(spectra, i * side + j, row, column, along.at(column));
                }
            }
            return new Slice(map.density(), spectra, luminance);
        }

        /** Fills a sample's spectrum and returns its luminance. */
        private float fill(float[] spectra, int sample, double row, double column, double density) {
            double angle = HalfVectors.angle(column, shape.columns());
            double azimuth = HalfVectors.azimuth(row, shape.rows());
            double along = Math.sin(theta) * Math.cos(azimuth - phi);
            double half = along * Math.sin(angle) + Math.cos(theta) * Math.cos(angle);
            // The cosine of the second direction; below the horizon it is replaced by that on the horizon.
            double cosOther = Math.max(0, 2 * half * Math.cos(angle) - Math.cos(theta));
            double depth = Math.cos(theta) + cosOther;
            double length = 2 * Math.max(0, half) * Math.sin(angle);
            double cosThetaD = Math.min(1, Math.hypot(length, depth) / 2);
            CoherenceWindow window = bands.get(0).level().area().window();
            double factor = 4 / (normalFactor(angle) * bands.get(0).level().scale());
            double[] nanometers = shape.bands().nanometers();
            double sum = 0;
            for (int b = 0; b < nanometers.length; b += ColorGrid.CHANNELS) {
                double[] powers = bands.get(b / ColorGrid.CHANNELS)
                        .xyz(-length * Math.cos(azimuth), -length * Math.sin(azimuth), -depth);
                for (int c = 0; c < ColorGrid.CHANNELS && b + c < nanometers.length; c++) {
                    double wavelength = nanometers[b + c] * NANOMETER;
                    double unit = Gain.KERATIN.brdfTimesCosines(cosThetaD, -depth, window, wavelength);
                    double value = factor * shares[b + c] * unit * powers[c];
                    spectra[(b + c) * shape.side() * shape.side() + sample] = (float) value;
                    sum += value;
                }
            }
            // Solid angle of the second direction per area of the square, as readers compute it for the probability.
            double least = Math.max(
                    density,
                    LEAST_COSINE * map.azimuths().at(row) / map.azimuths().total());
            double solid = Math.sin(angle) * Math.sqrt(angle) * half / least;
            return cosOther > 0 ? (float) (sum * normalFactor(angle) * solid) : 0;
        }
    }

    /**
     * Numbers of samples along the axes of a tensor file, which grow as the orders get narrower: azimuths of the first direction and its
     * angles to the normal, from 0 to {@code largest}, radians; the side of the unit square that holds the second direction; azimuths
     * (rows) and angles (columns) of the half vector in the density of {@link HalfVectors}.
     */
    record Shape(int phis, int thetas, double largest, int side, int rows, int columns, SpectralBands bands) {
        // Largest angle of the first direction to the normal: beyond it the division by its cosine is unstable.
        private static final double LARGEST_ANGLE = Math.toRadians(88);
        private static final int LEAST_COLUMNS = 48;
        // Angle between first directions, radians, by the root of the grid's step: an order's place errs by its square.
        // This and the next factors are chosen on patch blaze so that each axis causes about the same part of the
        // error.
        private static final double DIRECTION_STEP = 1.3;
        // Samples along the square's side per texel of the grid along |(u, v)| from 0 to 2.
        private static final double SIDE = 0.65;
        // Texels of the grid between two rows at |(u, v)| = 1.
        private static final double ROW_STEP = 1.5;
        // Texels of the grid by which an order at |(u, v)| = 1 moves from one band to the next.
        private static final double BAND_STEP = 2;

        /** @param count number of bands; 0 for as many as the orders' width needs */
        static Shape of(GridShape shape, WavelengthBand range, int count) {
            double step = shape.u().step();
            double direction = DIRECTION_STEP * Math.sqrt(step);
            double largest = Math.min(LARGEST_ANGLE, shape.largestAngle());
            int side = Math.max(8, (int) Math.ceil(2 * SIDE / step));
            double width = range.lastNanometers() - range.firstNanometers();
            double bandStep = BAND_STEP * step * ColorTable.MIDDLE_WAVELENGTH * 1e9;
            int bands = count > 0
                    ? count
                    : Math.max(2, Math.min(1 + (int) (width / 2), 1 + (int) Math.ceil(width / bandStep)));
            int phis = 1 + (int) Math.ceil(2 * Math.PI / direction);
            int thetas = 1 + (int) Math.ceil(largest / direction);
            int rows = 1 + (int) Math.ceil(2 * Math.PI / (ROW_STEP * step));
            int columns = Math.max(LEAST_COLUMNS, side);
            return new Shape(phis, thetas, largest, side, rows, columns, new SpectralBands(range, bands));
        }

        int slices() {
            return phis * thetas;
        }

        double phi(int index) {
            return -Math.PI + 2 * Math.PI * index / (phis - 1);
        }

        double theta(int index) {
            return largest * index / (thetas - 1);
        }

        long floatCount() {
            return (long) slices() * ((long) side * side * (bands.count() + 1) + (long) rows * columns);
        }
    }
}
