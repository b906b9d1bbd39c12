package sunbeam.app.cli.export;

import sunbeam.precompute.color.SpectralBands;
import sunbeam.precompute.color.WavelengthBand;
import sunbeam.precompute.colortable.ColorTable;

/**
 * Sampling of a tensor file for a table with orders of some width.
 *
 * @param phis azimuths of one direction, from -180 to 180 degrees
 * @param thetas its angles to the normal, from 0 on
 * @param largest largest of these angles, radians
 * @param side samples of the other direction, along both axes of the unit square
 * @param rows azimuths of the half vector, rows of the square's density
 * @param columns angles of the half vector
 * @param bands of wavelengths
 */
record MeasuredShape(int phis, int thetas, double largest, int side, int rows, int columns, SpectralBands bands) {
    // Largest angle; beyond it division by the cosine is unstable.
    private static final double LARGEST_ANGLE = Math.toRadians(88);
    private static final int LEAST_COLUMNS = 48;
    // Chosen on blaze so that each axis has about the same share of the error. Factor of sqrt(step): an order's place
    // between two first
    // directions errs by the square of their distance.
    private static final double DIRECTION_STEP = 1.3;
    // Samples of the square per texel of (u, v) along a radius of 2.
    private static final double SIDE = 0.65;
    private static final double ROW_STEP = 1.5;
    // Distance of rows at |(u, v)| = 1, as a share of an order's width in wavelengths.
    private static final double BAND_STEP = 2;

    /** @param count of the bands, 0: as many as orders need */
    static MeasuredShape of(GridShape shape, WavelengthBand range, int count) {
        double step = shape.u().step();
        double direction = DIRECTION_STEP * Math.sqrt(step);
        double largest = Math.min(LARGEST_ANGLE, shape.range().largest());
        int side = Math.max(8, (int) Math.ceil(2 * SIDE / step));
        double width = range.lastNanometers() - range.firstNanometers();
        double bandStep = BAND_STEP * step * ColorTable.MIDDLE_WAVELENGTH * 1e9;
        int bands =
                count > 0 ? count : Math.max(2, Math.min(1 + (int) (width / 2), 1 + (int) Math.ceil(width / bandStep)));
        return new MeasuredShape(
                1 + (int) Math.ceil(2 * Math.PI / direction),
                1 + (int) Math.ceil(largest / direction),
                largest,
                side,
                1 + (int) Math.ceil(2 * Math.PI / (ROW_STEP * step)),
                Math.max(LEAST_COLUMNS, side),
                new SpectralBands(range, bands));
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

    long numbers() {
        return (long) slices() * ((long) side * side * (bands.count() + 1) + (long) rows * columns);
    }
}
