package sunbeam.precompute.analysis;

import sunbeam.precompute.optics.HeightMap;

/** The direction in which a surface spreads most of its colors: across the lines of a grating. */
public final class PrincipalDirection {
    // Coarser waves send light beside the mirror direction, where it has no color.
    private static final double COARSEST_PERIOD = 5e-6;
    // Finer ones send light along the normal nowhere.
    private static final double FINEST_PERIOD = 380e-9;
    // A smaller patch is taken for one period; of a larger one, the border must not count.
    private static final double SMALLEST_PIECE = 10e-6;

    private PrincipalDirection() {}

    /**
     * The principal axis of the heights' power spectrum between periods of 380 nm and 5 um, each wave weighted by its power
     * times its frequency; of all waves where those have no power.
     *
     * @return degrees counter-clockwise from +x, above -90 to 90; 0 where no direction stands out
     */
    public static double azimuthDegrees(HeightMap map) {
        boolean piece = Math.min(map.width(), map.height()) >= SMALLEST_PIECE;
        HeightSpectrum spectrum =
                HeightSpectrum.of(map, piece ? HeightSpectrum.Edges.TAPERED : HeightSpectrum.Edges.PERIODIC);
        double[] sums = sums(spectrum, 1 / COARSEST_PERIOD, 1 / FINEST_PERIOD);
        if (sums[2] == 0) {
            sums = sums(spectrum, 0, Double.MAX_VALUE);
        }
        // Rounding alone prefers no direction.
        if (Math.hypot(sums[0], sums[1]) <= 1e-9 * sums[2]) {
            return 0;
        }
        double angle = Math.toDegrees(0.5 * Math.atan2(sums[1], sums[0]));
        return angle <= -90 ? angle + 180 : angle + 0.0;
    }

    /** Weights times cos and sin of twice the azimuth, and weights. */
    private static double[] sums(HeightSpectrum spectrum, double lowest, double highest) {
        double[] sums = new double[3];
        for (int i = 0; i < spectrum.power().length; i++) {
            SpatialFrequency wave = spectrum.frequency(i);
            double frequency = wave.length();
            if (frequency > 0 && frequency >= lowest && frequency <= highest) {
                double weight = spectrum.power()[i] / frequency;
                sums[0] += weight * (wave.x() * wave.x() - wave.y() * wave.y());
                sums[1] += weight * 2 * wave.x() * wave.y();
                sums[2] += weight * frequency * frequency;
            }
        }
        return sums;
    }
}
