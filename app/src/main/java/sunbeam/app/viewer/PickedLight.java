package sunbeam.app.viewer;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.text.Text;

/** Diffracted light at a picked point, by direct sums over the heights: the power and X, Y, Z of command {@code reflectance}. */
public record PickedLight(ExactLight light, CieTable cie, DirectionPair pair) {
    // Every eighth wavelength is computed first.
    private static final int COARSE = 8;

    /** Returns the light of a point of a patch for one pair of directions in its frame, under the scene's illuminant. */
    public static PickedLight of(Scene scene, Patch patch, DirectionPair pair) {
        SceneMethod method = scene.method().seeing(patch);
        CieTable illuminant = LightTable.of(method.choices());
        CieTable cie = scene.effectiveEnergy()
                .divisor(patch.heights(), scene.get(SceneSettings.INDEX).values(), method.choices())
                .map(divisor -> divisor.under(pair.wi(), illuminant))
                .orElse(illuminant);
        ExactLight light = method.method().referenceMethod(patch.heights()).light(patch.heights(), cie);
        return new PickedLight(light, cie, pair);
    }

    /**
     * Powers relative to a mirror at wavelengths in equal steps from 380 to 780 nm: {@link SpectrumPlot#COUNT}, or fewer of a partial one.
     *
     * @param color line with X, Y, Z of the light; empty in a partial spectrum
     */
    public record Spectrum(double[] powers, String color) {
        public static final Spectrum NONE = new Spectrum(new double[0], "");
    }

    public double power(double wavelength) {
        return light.power(pair, wavelength);
    }

    /** Returns X, Y, Z of the power; Y is 1 for a mirror. */
    public double[] xyz() {
        return light.xyz(pair, ExactLight.Quadrature.INTEGRATED);
    }

    /**
     * Evaluates the spectrum: every eighth wavelength, all, then the color.
     *
     * @param partial receives the two partial spectra
     * @return the spectrum, or none once {@code outdated} is true
     */
    Spectrum spectrum(Consumer<Spectrum> partial, BooleanSupplier outdated) {
        double[] powers = new double[SpectrumPlot.COUNT];
        int[] order = IntStream.concat(
                        IntStream.range(0, powers.length).filter(i -> i % COARSE == 0),
                        IntStream.range(0, powers.length).filter(i -> i % COARSE != 0))
                .toArray();
        int coarseCount = (powers.length - 1) / COARSE + 1;
        for (int done = 0; done < powers.length; done++) {
            if (outdated.getAsBoolean()) {
                return Spectrum.NONE;
            }
            if (done == coarseCount) {
                double[] coarse = IntStream.range(0, coarseCount)
                        .mapToDouble(i -> powers[COARSE * i])
                        .toArray();
                partial.accept(new Spectrum(coarse, ""));
            }
            powers[order[done]] = power(SpectrumPlot.wavelength(order[done]));
        }
        partial.accept(new Spectrum(powers, ""));
        if (outdated.getAsBoolean()) {
            return Spectrum.NONE;
        }
        double[] xyz = xyz();
        String color = Text.format("diffracted XYZ, %s  %.6g, %.6g, %.6g", cie.description(), xyz[0], xyz[1], xyz[2]);
        return new Spectrum(powers, color);
    }
}
