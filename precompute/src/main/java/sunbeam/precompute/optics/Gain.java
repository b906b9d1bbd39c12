package sunbeam.precompute.optics;

/**
 * What turns the diffracted power into radiance: Schlick's reflectance, the V-cavity mask and the Kirchhoff factors
 * (design section 3; Stam 1999 eq. 12; thesis section 2.5).
 */
public final class Gain {
    /** Refractive index of keratin, as in the thesis. */
    public static final double REFRACTIVE_INDEX = 1.5;

    /** Reflectance at normal incidence. */
    public static final double R0 = Math.pow((REFRACTIVE_INDEX - 1) / (REFRACTIVE_INDEX + 1), 2);

    private Gain() {}

    /** Schlick's reflectance (Schlick 1994) for a cosine between the half vector and the view. */
    public static double reflectance(double cosThetaD) {
        return R0 + (1 - R0) * Math.pow(1 - cosThetaD, 5);
    }

    /** Shadowing and masking of V-shaped cavities, 0..1 (Torrance and Sparrow 1967; Cook and Torrance 1982 eq. 8). */
    public static double mask(Geometry geometry) {
        double halfLength = 2 * geometry.cosThetaD();
        double cosHalf = (geometry.cosThetaI() + geometry.cosThetaR()) / halfLength;
        double factor = 2 * cosHalf / geometry.cosThetaD();
        return Math.min(1, factor * Math.min(geometry.cosThetaR(), geometry.cosThetaI()));
    }

    /** Relative radiance per power: rho = relativeRadiance * power; 1 for the flat mirror seen along the normal. */
    public static double relativeRadiance(Geometry geometry) {
        double kirchhoff = 1 + geometry.wi().dot(geometry.wr());
        double sum = geometry.cosThetaI() + geometry.cosThetaR();
        return reflectance(geometry.cosThetaD())
                / R0
                * kirchhoff
                * kirchhoff
                / (sum * sum * geometry.cosThetaR())
                * mask(geometry);
    }

    /** BRDF in 1/sr per power, without the mask; the Gaussian's effective area is pi sigma^2. */
    public static double brdf(Geometry geometry, CoherenceWindow window, double wavelength) {
        double kirchhoff = 1 + geometry.wi().dot(geometry.wr());
        double ratio = kirchhoff * window.sigmaMetres() / (wavelength * geometry.w());
        return reflectance(geometry.cosThetaD())
                * 4
                * Math.PI
                * ratio
                * ratio
                / (geometry.cosThetaI() * geometry.cosThetaR());
    }
}
