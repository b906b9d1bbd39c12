package sunbeam.precompute.analysis;

import java.util.Arrays;
import sunbeam.precompute.optics.HeightMap;

/** The phase of a wave from one band of rows to the next: where a scanner slips, or loses rows, few of the steps differ. */
final class RowPhase {
    private static final int BANDS = 48;
    // Periods along a row under a Hann window.
    private static final double FEWEST_IN_A_ROW = 3;

    private RowPhase() {}

    /**
     * What the middle one of the steps adds to the wave's frequency along y, cycles per metre; 0 where
     * lines run along the rows, in which no row by itself shows the wave, and of fewer than three rows.
     */
    static double slope(HeightMap level, SpatialFrequency wave) {
        int lag = Math.max(1, level.rows() / BANDS);
        int bands = level.rows() / lag;
        if (bands < 3 || Math.abs(wave.x()) * level.width() < FEWEST_IN_A_ROW) {
            return 0;
        }
        double[] phases = new double[bands];
        for (int band = 0; band < bands; band++) {
            double re = 0;
            double im = 0;
            for (int row = band * lag; row < (band + 1) * lag; row++) {
                for (int column = 0; column < level.columns(); column++) {
                    double hann = Math.sin(Math.PI * (column + 0.5) / level.columns());
                    double angle =
                            -2 * Math.PI * (wave.x() * column * level.pitchX() - wave.y() * row * level.pitchY());
                    re += hann * hann * level.at(column, row) * Math.cos(angle);
                    im += hann * hann * level.at(column, row) * Math.sin(angle);
                }
            }
            phases[band] = Math.atan2(im, re);
        }
        double[] steps = new double[bands - 1];
        for (int i = 0; i < steps.length; i++) {
            // Rows run downwards.
            steps[i] = Math.IEEEremainder(phases[i] - phases[i + 1], 2 * Math.PI);
        }
        Arrays.sort(steps);
        return steps[steps.length / 2] / (2 * Math.PI * lag * level.pitchY());
    }
}
