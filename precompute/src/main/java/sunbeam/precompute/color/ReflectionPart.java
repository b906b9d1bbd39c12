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
 * @param constant constant term of the directional factor, constant + schlick s
 */
public record ReflectionPart(CieTable cie, double constant, double schlick) {
    /** Returns the components of a material's light, relative to a flat mirror of the same material seen along the normal. */
    public static List<ReflectionPart> of(RefractiveIndex index, CieTable cie) {
        double mirror = mirror(index, cie);
        if (index.isConstant()) {
            return List.of(new ReflectionPart(cie, 1, (1 - mirror) / mirror));
        }
        CieTable colored = cie.times(wavelength -> index.reflectance(wavelength) / mirror);
        return List.of(new ReflectionPart(colored, 1, -1), new ReflectionPart(cie, 0, 1 / mirror));
    }

    /** Weighted by luminance. */
    public static double mirror(RefractiveIndex index, CieTable cie) {
        double sum = 0;
        double weights = 0;
        for (int nanometer = 380; nanometer <= 780; nanometer++) {
            double weight = cie.at(nanometer * 1e-9, 1);
            sum += weight * index.reflectance(nanometer * 1e-9);
            weights += weight;
        }
        return sum / weights;
    }

    /** Returns the relative radiance per diffracted power, as {@link Gain#relativeRadiance} does for keratin. */
    public double gain(DirectionPair pair) {
        return Gain.relativeRadiance(pair) * overStandard(pair);
    }

    /** Returns this component's gain divided by that of keratin, which the shaders use. */
    public double overStandard(DirectionPair pair) {
        double s = Math.pow(Math.max(0, 1 - pair.cosThetaD()), 5);
        return Gain.R0 / Gain.reflectance(pair.cosThetaD()) * (constant + schlick * s);
    }
}
