package sunbeam.app.cli.color;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Relative radiance by wavelength, and the band that makes the color: half of the light lies within it, a quarter below and a quarter
 * above. Unlike a width at half maximum, this band hardly changes with a single bright grain of speckle.
 *
 * @param nanometers wavelengths from 380 to 780 nm, in steps of 1 nm
 * @param radiances relative radiance at these wavelengths
 * @param from shortest wavelength of the band, meters
 * @param to longest wavelength of the band, meters
 */
record ViewSpectrum(ViewColor.View view, double[] nanometers, double[] radiances, double from, double to) {
    private static final int FIRST = 380;

    private static final int STEPS = 400;
    // Evaluations per nanometer: light as coherent as sunlight has orders 4 nm wide.
    private static final int PER_NANOMETER = 4;

    static double[] fineWavelengths() {
        return IntStream.rangeClosed(0, STEPS * PER_NANOMETER)
                .mapToDouble(i -> (FIRST + i / (double) PER_NANOMETER) * 1e-9)
                .toArray();
    }

    /** @param fine radiances at {@link #fineWavelengths} */
    static ViewSpectrum of(ViewColor.View view, double[] fine) {
        double[] wavelengths = fineWavelengths();
        double[] below = new double[fine.length];
        for (int i = 1; i < below.length; i++) {
            below[i] = below[i - 1] + 0.5 * (fine[i - 1] + fine[i]);
        }
        return new ViewSpectrum(
                view,
                IntStream.rangeClosed(FIRST, FIRST + STEPS).asDoubleStream().toArray(),
                IntStream.rangeClosed(0, STEPS)
                        .mapToDouble(nanometer -> fine[nanometer * PER_NANOMETER])
                        .toArray(),
                quantile(wavelengths, below, 0.25),
                quantile(wavelengths, below, 0.75));
    }

    double width() {
        return to - from;
    }

    Map<String, Object> band() {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("width_m", width());
        values.put("quarter_m", from);
        values.put("three_quarters_m", to);
        return values;
    }

    Map<String, Object> fields() {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("strip", view.strip());
        values.put("theta_i_deg", view.thetaIDegrees());
        values.put("theta_r_deg", view.thetaRDegrees());
        values.putAll(band());
        values.put(
                "wavelength_m",
                Arrays.stream(nanometers).map(length -> length / 1e9).toArray());
        values.put("relative_radiance", radiances);
        return values;
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
