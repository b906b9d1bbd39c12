package sunbeam.app.commands.reflectance;

import java.util.ArrayList;
import java.util.List;

/**
 * The columns that a list of directions gets.
 *
 * @param spectral whether each row has a wavelength, and thereby a power
 * @param ensemble whether the chosen average is the ensemble's; else the power is coherent
 * @param both whether the other average's power is written, too
 */
record ResultColumns(boolean spectral, boolean ensemble, boolean both) {
    private static final int COHERENT = 0;
    private static final int ENSEMBLE = 1;
    private static final int RHO = 2;
    private static final int BRDF = 3;

    List<String> names() {
        if (!spectral) {
            return List.of("X", "Y", "Z", "gain");
        }
        List<String> names = new ArrayList<>(List.of("power"));
        if (both || !ensemble) {
            names.add("power_coherent");
        }
        if (both || ensemble) {
            names.add("power_ensemble");
        }
        names.addAll(List.of("rho", "brdf"));
        return names;
    }

    /**
     * The cells of a row.
     *
     * @param result X, Y, Z, gain; or coherent power, ensemble's power, rho, BRDF
     */
    double[] of(double[] result) {
        if (!spectral) {
            return result;
        }
        double chosen = result[ensemble ? ENSEMBLE : COHERENT];
        return both
                ? new double[] {chosen, result[COHERENT], result[ENSEMBLE], result[RHO], result[BRDF]}
                : new double[] {chosen, chosen, result[RHO], result[BRDF]};
    }
}
