package sunbeam.precompute.color;

import java.util.List;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.RefractiveIndex;

/**
 * Fresnel component: a part of the reflected light in which wavelength and direction separate. Schlick's reflectance is R0 (1 - s) + s with
 * s = (1 - cos theta_d)^5 and R0 of the wavelength; colors need it under the integral over wavelengths. So a color is the sum of two
 * integrals, one with R0 as a factor of the light's spectrum; one integral is enough if R0 is constant.
 *
 * @param cie observer and light with this part's spectral factor
 * @param constant constant of the directional factor, constant + schlick s
 * @param schlick coefficient of s in the directional factor
 */
public record ReflectionPart(CieTable cie, double constant, double schlick) {

    /**
     * Returns the components of a material's light, relative to a flat mirror of the same material seen along the normal, whose luminance
     * is 1.
     */
    public static List<ReflectionPart> of(RefractiveIndex index, CieTable cie) {
        double mirror = mirror(index, cie);
        if (index.isConstant()) {
            return List.of(new ReflectionPart(cie, 1, (1 - mirror) / mirror));
        }
        return List.of(new ReflectionPart(colored(index, cie, mirror), 1, -1), new ReflectionPart(cie, 0, 1 / mirror));
    }

    private static CieTable colored(RefractiveIndex index, CieTable cie, double mirror) {
        return cie.times(wavelength -> index.reflectance(wavelength) / mirror);
    }

    /** Returns the mean reflectance along the normal, weighted by luminance. */
    public static double mirror(RefractiveIndex index, CieTable cie) {
        double sum = 0;
        double weights = 0;
        for (int nanometre = 380; nanometre <= 780; nanometre++) {
            double weight = cie.at(nanometre * 1e-9, 1);
            sum += weight * index.reflectance(nanometre * 1e-9);
            weights += weight;
        }
        return sum / weights;
    }

    /** Returns the relative radiance per power of this component, with the mask: {@link Gain#relativeRadiance} for this material. */
    public double gain(DirectionPair pair) {
        return Gain.relativeRadiance(pair) * overStandard(pair);
    }

    /** Returns this component's gain divided by {@link Gain#relativeRadiance}, the standard material's gain in the shaders. */
    public double overStandard(DirectionPair pair) {
        double s = Math.pow(Math.max(0, 1 - pair.cosThetaD()), 5);
        return Gain.R0 / Gain.reflectance(pair.cosThetaD()) * (constant + schlick * s);
    }
}
