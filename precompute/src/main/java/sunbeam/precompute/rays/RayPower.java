package sunbeam.precompute.rays;

import sunbeam.precompute.plan.GaussianArea;

/** The ensemble's average power at single places and wavelengths. Immutable, safe for use by several threads. */
public final class RayPower {
    // exp(-reach^2) of a bin is left out: 1e-10, as the finest tables of colors have it.
    private static final double REACH = 4.8;

    private final RaySpectrum spectrum;
    private final WindowedPowers powers;

    /** Power under a window that is no longer than the one that the spectrum was made for. */
    public RayPower(RaySpectrum spectrum, GaussianArea area) {
        this.spectrum = spectrum;
        this.powers = spectrum.under(area, REACH, false);
    }

    /**
     * Power, 1 for a flat mirror in specular direction.
     *
     * @param u of (u, v, w), as v and w in -2..2
     * @param wavelength metres, 380e-9 to 780e-9
     */
    public double at(double u, double v, double w, double wavelength) {
        double radius = Math.hypot(u, v);
        double[][] terms = new double[powers.terms()][1];
        powers.alongRay(
                radius == 0 ? 1 : u / radius, radius == 0 ? 0 : v / radius, new double[] {radius / wavelength}, terms);
        double[] coefficients = spectrum.coefficients(wavelength, Math.abs(w));
        double power = 0;
        for (int m = 0; m < terms.length; m++) {
            power += coefficients[m] * terms[m][0];
        }
        // A sum of terms may leave a dark direction a little below nothing.
        return Math.max(0, power);
    }
}
