package sunbeam.app.cli.reflectance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.terminal.Environment;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.plan.MethodSettings.FresnelFactor;

class EvaluatorTest {
    // Rounding of a few products.
    private static final double ROUNDING = 1e-12;

    @TempDir
    private Path folder;

    /** Returns the last row's values of an index from those of keratin, which all rows have; of its color without a wavelength. */
    private double[] indexed(RefractiveIndex index, FresnelFactor fresnel, String rows, double... keratin)
            throws IOException {
        boolean isColor = rows.split(",", -1).length == 4;
        String text = "theta_i,phi_i,theta_r,phi_r" + (isColor ? "\n" : ",wavelength\n") + rows + "\n";
        DirectionList list = DirectionList.read(Files.writeString(folder.resolve("list.csv"), text));
        int count = list.rows().size();
        return new Evaluator(list, new Environment(Map.of(), folder).progress())
                .indexed(index, CieTable.load(), fresnel, Collections.nCopies(count, keratin))
                .get(count - 1);
    }

    @Test
    void alongTheNormalTheBrdfHasTheMaterialsReflectanceAndRhoIsOne() throws IOException {
        RefractiveIndex silver = RefractiveIndex.parse("0.05+3.3i");
        double[] silvered = indexed(silver, FresnelFactor.ONCE, "0,0,0,0,550", 1, 1, 1, 0.04 * 7);

        double r0 = (0.95 * 0.95 + 3.3 * 3.3) / (1.05 * 1.05 + 3.3 * 3.3);
        assertThat(silvered[0]).isEqualTo(1);
        assertThat(silvered[2]).isCloseTo(1, within(ROUNDING));
        assertThat(silvered[3]).isCloseTo(r0 * 7, within(ROUNDING));
    }

    /** All materials reflect all grazing light, so rho is inversely proportional to the mirror's reflectance. */
    @Test
    void grazingLightIsReflectedByAllAlike() throws IOException {
        double[] gain = indexed(RefractiveIndex.parse("3"), FresnelFactor.ONCE, "89.9,0,89.9,180", 1, 1, 1, 25);
        // The limit is for 90 degrees; at 89.9 degrees 0.9 % is not reflected.
        assertThat(gain[3]).isCloseTo(4, within(0.02));
    }

    @Test
    void anIndexByWavelengthIsTakenAtTheRowsWavelength() throws IOException {
        RefractiveIndex index = new RefractiveIndex(new TreeMap<>(Map.of(380e-9, 1.5, 780e-9, 3.5)), new TreeMap<>());
        assertThat(indexed(index, FresnelFactor.ONCE, "0,0,0,0,380", 1, 1, 1, 1)[3])
                .isCloseTo(1, within(ROUNDING));
        // n = 2.5: (1.5 / 3.5)^2 over 0.04.
        assertThat(indexed(index, FresnelFactor.ONCE, "0,0,0,0,380\n0,0,0,0,580", 1, 1, 1, 1)[3])
                .isCloseTo(1.5 * 1.5 / 3.5 / 3.5 / 0.04, within(1e-9));
    }

    /** Rho has (R / R(0))^2, the BRDF R(0) times as much. */
    @Test
    void theSquareOfAMaterialsReflectanceIsThatOfRho() throws IOException {
        RefractiveIndex index = RefractiveIndex.parse("3");
        double keratin = Math.pow(Gain.reflectance(0.5) / Gain.R0, 2);

        double[] row = indexed(index, FresnelFactor.SQUARED, "60,0,60,180,550", 1, 1, keratin, Gain.R0 * keratin);

        double relative = index.reflectance(550e-9, 0.5) / 0.25;
        assertThat(row[2]).isCloseTo(relative * relative, within(ROUNDING));
        assertThat(row[3]).isCloseTo(0.25 * relative * relative, within(ROUNDING));
    }
}
