package sunbeam.precompute.analysis;

import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.prepare.Levelling;

/**
 * Whether a wave is what is left of one of twice its period, of which every second row is shifted by half. Its own wave then turns from
 * row to row by half a turn more than it should, as one of two samples a period does, and only its even overtones go on. With the
 * sign of every second row changed it stands where it belongs, at half of the wave's frequency.
 */
final class HalfShiftedRows {
    // Its amplitude over that of the wave: the second overtone of a saw has half of the first's.
    private static final double LEAST = 1;
    private static final int FEWEST_ROWS = 8;
    // What a Hann window spreads one frequency over, on both sides.
    private static final double SAME_BINS = 4;

    private HalfShiftedRows() {}

    /**
     * Looks for it.
     *
     * @param map without missing samples
     * @param peak of its spectrum
     * @param told of that peak
     */
    static boolean in(HeightMap map, SpectrumPeak peak, PeriodEstimate told) {
        double frequencyX = peak.frequencyX() / peak.frequency() / told.period();
        double frequencyY = peak.frequencyY() / peak.frequency() / told.period();
        if (map.rows() < FEWEST_ROWS || isItself(map, frequencyX, frequencyY)) {
            return false;
        }
        HeightMap level = map.levelled(Levelling.PLANE);
        double wave = Math.max(
                amplitude(level, frequencyX, frequencyY, false),
                amplitude(level, peak.frequencyX(), peak.frequencyY(), false));
        return amplitude(level, 0.5 * frequencyX, 0.5 * frequencyY, true) >= LEAST * wave;
    }

    /** Of three rows a period, half of the frequency and half a turn a row are the wave's own mirror image. */
    private static boolean isItself(HeightMap map, double frequencyX, double frequencyY) {
        return Math.hypot(1.5 * frequencyX * map.width(), 1.5 * Math.abs(frequencyY) * map.height() - 0.5 * map.rows())
                < SAME_BINS;
    }

    /** Of a frequency under a Hann window, up to a constant; where asked, of heights of which every second row changes its sign. */
    private static double amplitude(HeightMap map, double frequencyX, double frequencyY, boolean alternating) {
        double[] cosines = new double[map.columns()];
        double[] sines = new double[map.columns()];
        for (int column = 0; column < map.columns(); column++) {
            double angle = 2 * Math.PI * frequencyX * column * map.pitchX();
            cosines[column] = taper(column, map.columns()) * Math.cos(angle);
            sines[column] = taper(column, map.columns()) * Math.sin(angle);
        }
        double real = 0;
        double imaginary = 0;
        for (int row = 0; row < map.rows(); row++) {
            double cosine = 0;
            double sine = 0;
            for (int column = 0; column < map.columns(); column++) {
                cosine += cosines[column] * map.at(column, row);
                sine += sines[column] * map.at(column, row);
            }
            // Rows run downwards, y upwards.
            double angle = -2 * Math.PI * frequencyY * row * map.pitchY();
            double weight = taper(row, map.rows()) * (alternating && row % 2 == 1 ? -1 : 1);
            real += weight * (cosine * Math.cos(angle) - sine * Math.sin(angle));
            imaginary += weight * (cosine * Math.sin(angle) + sine * Math.cos(angle));
        }
        return Math.hypot(real, imaginary);
    }

    private static double taper(int at, int samples) {
        return Math.pow(Math.sin(Math.PI * (at + 0.5) / samples), 2);
    }
}
