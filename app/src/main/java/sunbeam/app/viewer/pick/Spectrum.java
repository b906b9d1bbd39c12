package sunbeam.app.viewer.pick;

import java.util.function.BooleanSupplier;
import sunbeam.app.render.SceneData;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.reference.ReferenceEvaluator;

/** Spectrum of a picked point by direct summation over the height samples, without color table or series expansion. */
final class Spectrum {
    // Number, first one and step of the wavelengths, 380 to 780 nm; in meters.
    private static final int COUNT = 81;
    private static final double FIRST_WAVELENGTH = 380e-9;
    private static final double WAVELENGTH_STEP = 5e-9;

    private Spectrum() {}

    /** Returns powers relative to a mirror at 380, 385, ... 780 nm; an empty array once {@code outdated} is true. */
    static double[] of(SceneData data, DirectionPair pair, BooleanSupplier outdated) {
        GaussianArea area = data.scene().method().seeing(data.patch()).area();
        ReferenceEvaluator reference = new ReferenceEvaluator(data.patch().heights(), area.window(), area.origin());
        boolean coherent = area.average() == Average.COHERENT;
        double[] powers = new double[COUNT];
        for (int i = 0; i < COUNT; i++) {
            if (outdated.getAsBoolean()) {
                return new double[0];
            }
            double wavelength = wavelength(i);
            powers[i] = coherent
                    ? reference.coherent(pair, wavelength)
                    : reference.powers(pair, wavelength).ensemble();
        }
        return powers;
    }

    static double wavelength(int index) {
        return FIRST_WAVELENGTH + index * WAVELENGTH_STEP;
    }

    /** Returns X, Y, Z of the powers under D65 for the CIE 1931 observer; Y is 1 for a mirror. */
    static double[] xyz(double[] powers) {
        CieTable light = CieTable.load();
        double[] xyz = new double[3];
        for (int i = 0; i < powers.length; i++) {
            double step = (i == 0 || i == powers.length - 1 ? 0.5 : 1) * WAVELENGTH_STEP / light.integralOfY();
            for (int c = 0; c < 3; c++) {
                xyz[c] += step * powers[i] * light.at(wavelength(i), c);
            }
        }
        return xyz;
    }
}
