package sunbeam.precompute.optics;

/** Factors from diffracted power to radiance: Schlick, V-cavity mask, Kirchhoff (Stam 1999 eq. 12; thesis section 2.3.2). */
public final class Gain {
    /** Refractive index of keratin, as in the thesis. */
    public static final double REFRACTIVE_INDEX = 1.5;

    public static final double R0 = Math.pow((REFRACTIVE_INDEX - 1) / (REFRACTIVE_INDEX + 1), 2);

    private Gain() {}

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

    /** Returns the relative radiance per diffracted power, for keratin; 1 for a flat mirror seen along the normal. */
    public static double relativeRadiance(DirectionPair pair) {
        double kirchhoff = 1 + pair.wi().dot(pair.wr());
        double sum = pair.cosThetaI() + pair.cosThetaR();
        return reflectance(pair.cosThetaD()) / R0 * kirchhoff * kirchhoff / (sum * sum * pair.cosThetaR()) * mask(pair);
    }

    /** Returns the BRDF in 1/sr per diffracted power, without the mask, for a wavelength in meters. */
    public static double brdf(DirectionPair pair, CoherenceWindow window, double wavelength) {
        double kirchhoff = 1 + pair.wi().dot(pair.wr());
        double ratio = kirchhoff * window.sigmaMeters() / (wavelength * pair.w());
        return reflectance(pair.cosThetaD()) * 4 * Math.PI * ratio * ratio / (pair.cosThetaI() * pair.cosThetaR());
    }
}
