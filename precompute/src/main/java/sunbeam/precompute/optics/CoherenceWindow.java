package sunbeam.precompute.optics;

/** Gaussian coherence window exp(-r^2 / (2 sigma^2)), amplitude 1 at its center; sigma, meters, is a quarter of the coherence length. */
public record CoherenceWindow(double sigmaMeters) {
    /** Sunlight's coherence length, meters (thesis, draft 001, section 2.2.2). */
    public static final double SUNLIGHT_COHERENCE_LENGTH = 65e-6;
    // Meters; scatter of longer surface waves counts as gloss.
    private static final double LONGEST_WAVE = 5e-6;

    public static CoherenceWindow ofCoherenceLength(double meters) {
        return new CoherenceWindow(meters / 4);
    }

    public double coherenceLength() {
        return 4 * sigmaMeters;
    }

    /** Returns a mirror's radiance relative to sunlight's: the reflected solid angle falls with the square of the coherence length. */
    public double mirrorRadiance() {
        double ratio = coherenceLength() / SUNLIGHT_COHERENCE_LENGTH;
        return ratio * ratio;
    }

    /** Returns the standard deviation of the window's spectrum, 1 / (2 pi sigma), in cycles per meter. */
    public double sigmaFrequency() {
        return 1 / (2 * Math.PI * sigmaMeters);
    }

    /** Returns the standard deviation of the power's spectrum, in cycles per meter: power is the square of an amplitude. */
    public double sigmaFrequencyOfPower() {
        return sigmaFrequency() / Math.sqrt(2);
    }

    /** Returns the standard deviation in (u, v) of a sharp order's power at a wavelength in meters. */
    public double sigmaOfOrder(double wavelength) {
        return wavelength * sigmaFrequency() / Math.sqrt(2);
    }

    /** Returns the amplitude of the window, or of its spectrum, relative to the center's, at a distance in its standard deviations. */
    public static double amplitude(double deviations) {
        return Math.exp(-0.5 * deviations * deviations);
    }

    /** Returns the square of {@link #amplitude}. */
    public static double power(double deviations) {
        return Math.exp(-deviations * deviations);
    }

    /** Returns the distance, in standard deviations, at which the amplitude falls to a share of the center's. */
    public static double reach(double share) {
        return Math.sqrt(-2 * Math.log(share));
    }

    /** Returns the |(u, v)| at which the specular peak of the longest wavelength, meters, ends: at five standard deviations. */
    public double specularReach(double longestWavelength) {
        return 5 * sigmaFrequency() * longestWavelength;
    }

    /**
     * Returns the |(u, v)| below which only gloss is seen, and no orders (docs/color.md): the specular peak of the longest wavelength, meters, and
     * light scattered by waves longer than both 5 um and two periods of the surface (meters; 0 if none is known).
     */
    public double mirrorReach(double longestWavelength, double period) {
        return Math.max(specularReach(longestWavelength), longestWavelength / Math.max(LONGEST_WAVE, 2 * period));
    }
}
