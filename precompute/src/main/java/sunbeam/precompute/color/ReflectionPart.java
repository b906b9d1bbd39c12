package sunbeam.precompute.color;

import java.util.List;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.RefractiveIndex;

/**
 * Fresnel component: a part of the reflected light whose Fresnel factor is a product of a function of wavelength and one of direction.
 * Schlick's reflectance is R0 (1 - s) + s with s = (1 - cos theta_d)^5; if R0 depends on the wavelength, a color is the sum of two
 * integrals, one of them with R0 as a factor of the light's spectrum.
 *
 * @param cie observer, and light times this component's spectral factor
 * @param constant constant term of the directional factor, (constant + schlick s)^exponent
 * @param exponent 1 or, of a single component, 2 ({@link Gain})
 */
public record ReflectionPart(CieTable cie, double constant, double schlick, int exponent) {
    /**
     * Returns the components of a material's light, relative to a flat mirror of the same material seen along the normal.
     *
     * @throws IllegalArgumentException for the square of a reflectance that depends on the wavelength, which is no sum of such components
     */
    public static List<ReflectionPart> of(RefractiveIndex index, CieTable cie, int exponent) {
        double mirror = mirror(index, cie);
        if (index.isConstant()) {
            return List.of(new ReflectionPart(cie, 1, (1 - mirror) / mirror, exponent));
        }
        if (exponent != 1) {
            throw new IllegalArgumentException("the square of an index by wavelength has no two components");
        }
        CieTable colored = cie.times(wavelength -> index.reflectance(wavelength) / mirror);
        return List.of(new ReflectionPart(colored, 1, -1, 1), new ReflectionPart(cie, 0, 1 / mirror, 1));
    }

    /** Returns a material's gain, relative to a mirror weighted by luminance. */
    public static Gain gain(RefractiveIndex index, CieTable cie, int exponent) {
        return new Gain(index, mirror(index, cie), exponent);
    }

    private static double mirror(RefractiveIndex index, CieTable cie) {
        double sum = 0;
        double weights = 0;
        for (int nanometer = CieTable.FIRST_NANOMETER; nanometer <= CieTable.LAST_NANOMETER; nanometer++) {
            double weight = cie.at(nanometer * 1e-9, 1);
            sum += weight * index.reflectance(nanometer * 1e-9);
            weights += weight;
        }
        return sum / weights;
    }

    /** Returns this component's relative radiance per diffracted power, as {@link Gain#relativeRadiance} does for the whole. */
    public double gain(DirectionPair pair) {
        return Gain.ofGeometry(pair) * power(constant + schlick * grazing(pair));
    }

    /** Returns this component's gain divided by that of keratin, which the shaders use. */
    public double overStandard(DirectionPair pair) {
        double standard = Gain.reflectance(pair.cosThetaD()) / Gain.R0;
        return power((constant + schlick * grazing(pair)) / standard);
    }

    private static double grazing(DirectionPair pair) {
        return Math.pow(Math.max(0, 1 - pair.cosThetaD()), 5);
    }

    private double power(double factor) {
        return exponent == 2 ? factor * factor : factor;
    }
}
