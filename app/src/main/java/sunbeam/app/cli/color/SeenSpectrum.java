package sunbeam.app.cli.color;

import java.util.stream.IntStream;

/**
 * Relative radiance by wavelength, and the band that a color is made of: half of its light lies within, a quarter below and a
 * quarter above. A single grain of speckle, however bright, moves it little, which a width at half of the maximum cannot say.
 *
 * @param nanometres from 380 to 780
 * @param radiances there
 * @param from begin of the band, metres
 * @param to its end, metres
 */
record SeenSpectrum(SeenColor.View view, double[] nanometres, double[] radiances, double from, double to) {
    private static final int FIRST = 380;
    private static final int STEPS = 400;
    // The window alone makes an order 4 nm wide in sunlight.
    private static final int FINE = 4;

    /** Wavelengths at which a spectrum is evaluated, meters, ascending. */
    static double[] fineWavelengths() {
        return IntStream.rangeClosed(0, STEPS * FINE)
                .mapToDouble(i -> (FIRST + i / (double) FINE) * 1e-9)
                .toArray();
    }

    /** @param fine radiances at {@link #fineWavelengths} */
    static SeenSpectrum of(SeenColor.View view, double[] fine) {
        double[] wavelengths = fineWavelengths();
        double[] below = new double[fine.length];
        for (int i = 1; i < below.length; i++) {
            below[i] = below[i - 1] + 0.5 * (fine[i - 1] + fine[i]);
        }
        return new SeenSpectrum(
                view,
                IntStream.rangeClosed(FIRST, FIRST + STEPS).asDoubleStream().toArray(),
                IntStream.rangeClosed(0, STEPS)
                        .mapToDouble(nanometre -> fine[nanometre * FINE])
                        .toArray(),
                quantile(wavelengths, below, 0.25),
                quantile(wavelengths, below, 0.75));
    }

    /** Metres. */
    double width() {
        return to - from;
    }

    private static double quantile(double[] wavelengths, double[] below, double share) {
        double wanted = share * below[below.length - 1];
        int before = 0;
        while (before < below.length - 2 && below[before + 1] < wanted) {
            before++;
        }
        double step = below[before + 1] - below[before];
        double part = step > 0 ? (wanted - below[before]) / step : 0;
        return wavelengths[before] + part * (wavelengths[before + 1] - wavelengths[before]);
    }
}
