package sunbeam.app.commands.export;

import java.util.List;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Gain;

/**
 * Spectra of one direction of a {@link MeasuredMaterial}.
 *
 * @param map of the direction
 * @param slice its number
 * @param bands tables of the spectrum
 */
record MeasuredSlice(MeasuredShape shape, HalfVectors map, int slice, List<ColorGrid> bands) {
    // Of the other direction, in what light is drawn by.
    private static final double LEAST_COSINE = 0.03;
    private static final double NANOMETER = 1e-9;

    /**
     * Fills arrays of a slice.
     *
     * @param spectra by band, row and column
     * @param luminance by row and column
     */
    void fill(float[] spectra, float[] luminance) {
        int side = shape.side();
        for (int i = 0; i < side; i++) {
            double row = map.azimuths().place((double) i / (side - 1));
            LinearDensity along = HalfVectors.row(map.density(), shape.columns(), row);
            for (int j = 0; j < side; j++) {
                double column = along.place((double) j / (side - 1));
                fill(i * side + j, row, column, along.at(column), spectra, luminance);
            }
        }
    }

    private void fill(int sample, double row, double column, double density, float[] spectra, float[] luminance) {
        double theta = shape.theta(slice % shape.thetas());
        double angle = HalfVectors.angle(column, shape.columns());
        double azimuth = HalfVectors.azimuth(row, shape.rows());
        double along = Math.sin(theta) * Math.cos(azimuth - shape.phi(slice / shape.thetas()));
        double half = along * Math.sin(angle) + Math.cos(theta) * Math.cos(angle);
        // Of (u, v, w); where the other direction is below the horizon, what is on it.
        double cosOther = Math.max(0, 2 * half * Math.cos(angle) - Math.cos(theta));
        double depth = Math.cos(theta) + cosOther;
        double length = 2 * Math.max(0, half) * Math.sin(angle);
        double squared = (length * length + depth * depth) / 4;
        CoherenceWindow window = bands.get(0).level().area().window();
        double kirchhoff = 2 * squared * window.sigmaMetres() / depth;
        double factor = 16
                * Math.PI
                * Gain.reflectance(Math.min(1, Math.sqrt(squared)))
                * kirchhoff
                * kirchhoff
                / (MeasuredMaterial.normals(angle) * bands.get(0).level().scale());
        double[] nanometers = shape.bands().nanometers();
        double sum = 0;
        for (int b = 0; b < nanometers.length; b += ColorGrid.CHANNELS) {
            double[] powers = bands.get(b / ColorGrid.CHANNELS)
                    .xyz(-length * Math.cos(azimuth), -length * Math.sin(azimuth), -depth);
            for (int c = 0; c < ColorGrid.CHANNELS && b + c < nanometers.length; c++) {
                double wavelength = nanometers[b + c] * NANOMETER;
                double value = factor * powers[c] / (wavelength * wavelength);
                spectra[(b + c) * shape.side() * shape.side() + sample] = (float) value;
                sum += value;
            }
        }
        // Solid angles of the other direction per part of the square; readers divide by the same.
        boolean seen = cosOther > 0;
        double least = Math.max(
                density, LEAST_COSINE * map.azimuths().at(row) / map.azimuths().total());
        double solid = Math.sin(angle) * Math.sqrt(angle) * half / least;
        luminance[sample] = seen ? (float) (sum * MeasuredMaterial.normals(angle) * solid) : 0;
    }
}
