package sunbeam.app.cli.export;

import sunbeam.precompute.color.WavelengthBand;
import sunbeam.precompute.color.WavelengthBand.SpectralBands;
import sunbeam.precompute.colortable.ColorTable;

/**
 * Numbers of samples along the axes of a tensor file. They grow as the steps of the color grid, and so its orders, get narrower.
 *
 * @param phis number of azimuths of the first direction, from -180 to 180 degrees
 * @param thetas number of the first direction's angles to the normal, from 0 to {@code largest}, radians
 * @param side number of samples along each side of the unit square that holds the second direction
 * @param rows number of the half vector's azimuths in the density of {@link HalfVectors}
 * @param columns number of the half vector's angles to the normal in that density
 */
record BsdfShape(int phis, int thetas, double largest, int side, int rows, int columns, SpectralBands bands) {
    // Largest angle of the first direction to the normal, radians: beyond it the division by its cosine is unstable.
    private static final double LARGEST_ANGLE = Math.toRadians(88);
    private static final int LEAST_COLUMNS = 48;
    // Angle between first directions, radians, by the root of the grid's step: between them an order's place errs by
    // its square. By this factor and the next, measured on patch blaze, each axis causes about the same error.
    private static final double DIRECTION_STEP = 1.3;
    // Samples along the square's side per texel of the grid along |(u, v)| from 0 to 2.
    private static final double SIDE = 0.65;

    /** Texels of the grid between two rows at |(u, v)| = 1. */
    private static final double ROW_STEP = 1.5;
    // Texels of the grid by which an order at |(u, v)| = 1 moves from one band to the next.
    private static final double BAND_STEP = 2;

    /** @param count number of bands; 0 for as many as the orders' width needs */
    static BsdfShape of(GridShape shape, WavelengthBand range, int count) {
        double step = shape.u().step();
        double direction = DIRECTION_STEP * Math.sqrt(step);
        double largest = Math.min(LARGEST_ANGLE, shape.range().largest());
        int side = Math.max(8, (int) Math.ceil(2 * SIDE / step));
        double width = range.lastNanometers() - range.firstNanometers();
        double bandStep = BAND_STEP * step * ColorTable.MIDDLE_WAVELENGTH * 1e9;
        int bands =
                count > 0 ? count : Math.max(2, Math.min(1 + (int) (width / 2), 1 + (int) Math.ceil(width / bandStep)));
        return new BsdfShape(
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

    long floatCount() {
        return (long) slices() * ((long) side * side * (bands.count() + 1) + (long) rows * columns);
    }
}
