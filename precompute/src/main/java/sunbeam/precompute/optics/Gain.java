package sunbeam.precompute.optics;

/**
 * Factors from diffracted power to radiance: Schlick, V-cavity mask, Kirchhoff (Stam 1999 eq. 12; thesis section 2.3.2). The shaders' form,
 * for keratin, is shaders/include/gain.glsl.
 *
 * @param index of the surface's material
 * @param mirror reflectance of the flat mirror that has radiance 1, seen along the normal
 * @param exponent of the reflectance relative to the mirror's: 1, or 2 as in the thesis
 */
public record Gain(RefractiveIndex index, double mirror, int exponent) {
    /** Refractive index of keratin, as in the thesis. */
    public static final double REFRACTIVE_INDEX = 1.5;

    public static final double R0 = Math.pow((REFRACTIVE_INDEX - 1) / (REFRACTIVE_INDEX + 1), 2);
    public static final Gain KERATIN = new Gain(RefractiveIndex.KERATIN, R0, 1);

    // Meters; keratin's index is the same at all wavelengths.
    private static final double ANY_WAVELENGTH = 550e-9;

    /** Returns keratin's reflectance by Schlick (1994) for the cosine of the angle between the half vector and the view. */
    public static double reflectance(double cosThetaD) {
        return RefractiveIndex.schlick(R0, cosThetaD);
    }

    /** Returns the shadowing and masking factor of V-shaped cavities, 0..1 (Torrance and Sparrow 1967; Cook and Torrance 1982 eq. 8). */
    public static double mask(DirectionPair pair) {
        double halfLength = 2 * pair.cosThetaD();
        double cosHalf = (pair.cosThetaI() + pair.cosThetaR()) / halfLength;
        double factor = 2 * cosHalf / pair.cosThetaD();
        return Math.min(1, factor * Math.min(pair.cosThetaR(), pair.cosThetaI()));
    }

    /** Returns an order's share of a mirror's light per |F|^2, without reflectance: (1 + wi.wr)^2 / (w^2 cos theta_i cos theta_r). */
    public static double orderShare(DirectionPair pair) {
        return squareOfKirchhoff(pair.cosThetaD(), pair.w()) / (pair.cosThetaI() * pair.cosThetaR());
    }

    /** Returns (1 + wi.wr)^2 / w^2. */
    private static double squareOfKirchhoff(double cosThetaD, double w) {
        double kirchhoff = 2 * cosThetaD * cosThetaD / w;
        return kirchhoff * kirchhoff;
    }

    /** Returns the relative radiance per diffracted power, without reflectance: 1 for a flat mirror seen along the normal. */
    public static double ofGeometry(DirectionPair pair) {
        return orderShare(pair) * pair.cosThetaI() * mask(pair);
    }

    /** Returns the relative radiance per diffracted power, for keratin; 1 for a flat mirror seen along the normal. */
    public static double relativeRadiance(DirectionPair pair) {
        return KERATIN.relativeRadiance(pair, ANY_WAVELENGTH);
    }

    /** Returns the relative radiance per diffracted power at a wavelength in meters. */
    public double relativeRadiance(DirectionPair pair, double wavelength) {
        return relativeReflectance(pair.cosThetaD(), wavelength) * ofGeometry(pair);
    }

    /** Returns the BRDF in 1/sr per diffracted power, without the mask, for a wavelength in meters. */
    public double brdf(DirectionPair pair, CoherenceWindow window, double wavelength) {
        return brdfTimesCosines(pair.cosThetaD(), pair.w(), window, wavelength) / (pair.cosThetaI() * pair.cosThetaR());
    }

    /** Returns {@link #brdf} times cos theta_i cos theta_r, which (u, v, w) determines; 2 {@code cosThetaD} is its length. */
    public double brdfTimesCosines(double cosThetaD, double w, CoherenceWindow window, double wavelength) {
        double ratio = window.sigmaMeters() / wavelength;
        return mirror
                * relativeReflectance(cosThetaD, wavelength)
                * squareOfKirchhoff(cosThetaD, w)
                * 4
                * Math.PI
                * ratio
                * ratio;
    }

    private double relativeReflectance(double cosThetaD, double wavelength) {
        double once = index.reflectance(wavelength, cosThetaD) / mirror;
        return exponent == 2 ? once * once : once;
    }
}
