package sunbeam.precompute.optics;

/**
 * Gaussian coherence window exp(-r^2 / (2 sigma^2)) with amplitude 1 at its center.
 *
 * @param sigmaMetres its standard deviation in space, metres; a quarter of the coherence length
 */
public record CoherenceWindow(double sigmaMetres) {
    /** Sunlight's coherence length, metres (thesis section 2.2.2). */
    public static final double SUNLIGHT_COHERENCE_LENGTH = 65e-6;

    private static final double LONGEST_WAVELENGTH = 780e-9;
    private static final double LONGEST_WAVE = 5e-6;

    public CoherenceWindow {
        if (!(sigmaMetres > 0) || !Double.isFinite(sigmaMetres)) {
            throw new IllegalArgumentException("sigma must be positive, got " + sigmaMetres + " m");
        }
    }

    /** The window whose four standard deviations are the given length in metres. */
    public static CoherenceWindow ofCoherenceLength(double metres) {
        return new CoherenceWindow(metres / 4);
    }

    public double coherenceLength() {
        return 4 * sigmaMetres;
    }

    /**
     * Returns the radiance of a mirror under light of this coherence, relative to sunlight of the same irradiance: the solid angle of the
     * reflected light falls with the square of the coherence length.
     */
    public double mirrorRadiance() {
        double ratio = coherenceLength() / SUNLIGHT_COHERENCE_LENGTH;
        return ratio * ratio;
    }

    /** Standard deviation of the window's spectrum, 1 / (2 pi sigma), in cycles per metre. */
    public double sigmaFrequency() {
        return 1 / (2 * Math.PI * sigmaMetres);
    }

    /**
     * Returns the |(u, v)| up to which a direction sees the specular peak of any wavelength up to the longest, in meters: the peak is as
     * wide as the window's spectrum, and five deviations hold all of it.
     */
    public double specularReach(double longestWavelength) {
        return 5 * sigmaFrequency() * longestWavelength;
    }

    /**
     * Returns the |(u, v)| up to which a direction sees gloss (the specular peak or its surroundings) and no order (docs/color.md): the
     * specular peak of visible light, and the scatter of surface waves longer than 5 um or, if that is longer, than two periods,
     * so that the first order lies beyond.
     *
     * @param period of the surface, metres; 0 if none is known
     */
    public double mirrorReach(double period) {
        double longest = Math.max(LONGEST_WAVE, 2 * period);
        return Math.max(specularReach(LONGEST_WAVELENGTH), LONGEST_WAVELENGTH / longest);
    }
}
