package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.errors.ErrorStatistics;

/** Errors of the thesis's preset, which come from its choices, not from the shader; and figures beside exact values. */
class ThesisPresetTest extends InOneWorkplace {
    /** Compares with the nine bins, added in double precision without an expansion. */
    @Test
    void itIsTheSumOfNineBinsByDefinition() throws Exception {
        NineBins definition = new NineBins(SharedData.present("patches/elaphe.png"), 65e-6, 375e-9);
        CsvFile directions = SharedData.reference("power", "elaphe").head(12);

        CsvFile ours = reflectance("elaphe", directions, "--preset thesis --window-origin centre");

        for (int row = 0; row < directions.size(); row++) {
            double[] uvw = uvw(directions, row);
            double expected = definition.power(uvw[0], uvw[1], uvw[2], directions.at(row, "wavelength") * 1e-9);
            // 37 terms leave 1e-7 of a relief of 375 nm; float32 takes 6e-5 at the most (measured on 48 rows).
            assertThat(ours.at(row, "power")).as("row %d", row).isCloseTo(expected, Percentage.withPercentage(0.02));
        }
    }

    /** The thesis's pq: nine bins by a sinc of their distance; 65 um hold the patch once, so that the array factor is 1. */
    @Test
    @Tag("thorough")
    void itsReplicasAreInterpolatedByARingOfNineBins() throws Exception {
        NineBins definition = new NineBins(SharedData.present("patches/elaphe.png"), 65e-6, 375e-9);
        CsvFile directions = SharedData.reference("power", "elaphe").head(6);

        CsvFile ours = reflectance("elaphe", directions, "--method pq --preset thesis");

        for (int row = 0; row < directions.size(); row++) {
            double[] uvw = uvw(directions, row);
            double expected = definition.ring(uvw[0], uvw[1], uvw[2], directions.at(row, "wavelength") * 1e-9);
            // Float32 rounds u / lambda to 1e-5 bins, by which a sinc at a bin beside changes as much.
            assertThat(ours.at(row, "power")).as("row %d", row).isCloseTo(expected, Percentage.withPercentage(0.1));
        }
    }

    /** In the mirror direction at 60 degrees R(60) / R(0) = (0.04 + 0.96 / 32) / 0.04 = 1.75 counts once more than it does. */
    @Test
    void itsGainHasFresnelsFactorSquared() throws Exception {
        CsvFile direction = CsvFile.ofDirections(List.of(new double[] {60, 0, 60, 180, 550}));

        CsvFile squared = workplace.reflectance("blaze", direction, "--preset thesis");
        CsvFile once = workplace.reflectance("blaze", direction, "--preset thesis --fresnel once");

        // Both are float32.
        assertThat(squared.at(0, "rho") / once.at(0, "rho")).isCloseTo(1.75, within(1e-5));
    }

    /** With seven by seven bins around the nearest one and enough terms only rounding to float32 remains. */
    @ParameterizedTest
    @CsvSource({"blaze, coherent", "elaphe, ensemble"})
    void withAWiderNeighborhoodTheErrorIsGone(String patch, String average) throws Exception {
        CsvFile exact = SharedData.reference("power", patch);
        String options =
                "--preset thesis --window-origin centre --fresnel once --radius 3 --anchor nearest --expansion taylor --terms 50 --both-averages --average ";

        CsvFile ours = reflectance(patch, exact, options + average);

        for (String column : List.of("power_coherent", "power_ensemble")) {
            ErrorStatistics errors = ours.errors(exact, name -> name.replace("_coherent", ""), column);
            assertThat(errors.median()).as("median of %s", column).isLessThan(2e-5);
            assertThat(errors.percentile95()).as("95 %% of %s", column).isLessThan(1e-4);
            // Float32 rounds f = u / lambda to 6e-8, which three deviations from an order of blaze (f = 2.4e6 / m) is
            // amplified by 2 f |f - f_j| / sigma_f^2 = 1500 to 0.9e-4.
            assertThat(errors.maximum()).as("largest of %s", column).isLessThan(2e-4);
        }
        for (int row = 0; row < exact.size(); row++) {
            double gain = exact.at(row, "rho") / exact.at(row, "power");
            // Both are float32.
            assertThat(ours.at(row, "rho")).isCloseTo(gain * ours.at(row, "power"), within(1e-5 * ours.at(row, "rho")));
        }
    }

    private static double[] uvw(CsvFile directions, int row) {
        double[] uvw = new double[3];
        for (String end : List.of("i", "r")) {
            double theta = Math.toRadians(directions.at(row, "theta_" + end));
            double phi = Math.toRadians(directions.at(row, "phi_" + end));
            uvw[0] -= Math.sin(theta) * Math.cos(phi);
            uvw[1] -= Math.sin(theta) * Math.sin(phi);
            uvw[2] -= Math.cos(theta);
        }
        return uvw;
    }

    private static CsvFile reflectance(String patch, CsvFile directions, String options) throws Exception {
        return workplace.reflectance(SharedData.patch(patch), directions, options);
    }

    private static final int ANGLES = 501;

    @Test
    void sixFiguresHaveTheVerdictsOfTheThesissClaims() throws Exception {
        String verdicts = workplace
                .succeedHere("figures --output agree --size 48 --only 2.6,2.8,3.1,4.5,5.4,5.10")
                .stdout();

        assertThat(verdicts)
                .contains(
                        "2.6 agrees: 'blue light has twice the frequency of red light' holds",
                        "2.8 agrees: '5 nm are enough' holds",
                        "3.1 agrees: 'extremes shrink' holds",
                        "4.5 agrees: 'the more, the sharper' holds",
                        // The sum of nmm lacks its weights.
                        "5.4 differs: 'NMM and PQ look as FLSS' fails",
                        "'FLSS and PQ are not symmetric, Gems is' holds",
                        "5.10 agrees: 'small windows lose colors' holds");
    }

    /** A symmetric wave has no bright side, unlike a blaze. */
    @Test
    void aSurfaceThatIsNoBlazeFailsTheCheckOfBlaze() throws Exception {
        Path patches = Files.createDirectory(workplace.resolve("waves"));
        Images.gray(patches.resolve("wave.png"), 100, 100, (column, row) ->
                (int) Math.round(127.5 * (1 + Math.sin(2 * Math.PI * column / 100))));
        Files.writeString(
                patches.resolve("blaze.json"),
                "{\"heights\": \"wave.png\", \"width\": \"2.5 um\", \"maxHeight\": \"200 nm\"}");

        String verdicts = workplace
                .succeedHere("figures --output differ --patches waves --size 48 --only 5.4")
                .stdout();

        assertThat(verdicts)
                .contains(
                        "5.4 differs: 'FLSS and PQ are not symmetric, Gems is' fails: share of light on the left: blaze-full 0.5");
    }

    /** Figure 4.5: seven periods over one are the array factor (sin 7 pi t / 7 sin pi t)^2, t = d sin theta / lambda. */
    @Test
    void sevenPeriodsSharpenMaximaByTheArrayFactor() throws Exception {
        CsvFile one = response(1);
        CsvFile seven = response(7);

        double largest = IntStream.range(0, ANGLES)
                .mapToDouble(i -> one.at(0, angle(i)))
                .max()
                .orElseThrow();
        for (int i = 0; i < ANGLES; i++) {
            double turns = Math.PI * 2.5e-6 * Math.sin(Math.toRadians(-25 + 0.1 * i)) / 500e-9;
            double factor = Math.abs(Math.sin(turns)) < 1e-9 ? 1 : Math.sin(7 * turns) / (7 * Math.sin(turns));
            // Float32 leaves 1e-5 of the sines' arguments; at a flank of the factor that is 1e-4 of the brightest
            // angle.
            assertThat(seven.at(0, angle(i)))
                    .as("%s degrees", angle(i))
                    .isCloseTo(factor * factor * one.at(0, angle(i)), within(1e-4 * largest));
        }
    }

    private static String angle(int i) {
        return String.format(Locale.ROOT, "%.6f", -25 + 0.1 * i);
    }

    private static CsvFile response(int replicas) throws Exception {
        workplace.succeedHere(
                "evaluate --patch lamellar --method pq --theta-i 0 --azimuth 0 --wavelengths 500:500:1"
                        + " --angles -25:25:0.1 --replicas %s --output q%s",
                replicas, replicas);
        return CsvFile.read(workplace.resolve("q" + replicas + ".csv"));
    }

    /** Figure 5.5: far orders of blaze are 1 nm wide. */
    @Test
    void stepsOfTenNanometersMissOrdersOfBlazeAndOfOneDoNot() throws Exception {
        // 0.045 measured.
        assertThat(error("10nm")).isGreaterThan(0.02);
        assertThat(error("1nm")).isLessThan(1e-3);
    }

    /** Returns the 95th percentile of the relative errors of Y in bright rows. */
    private static double error(String step) throws Exception {
        CsvFile exact = SharedData.reference("xyz", "blaze");
        return workplace
                .reflectance(SharedData.patch("blaze"), exact, "--wavelength-step " + step)
                .errors(exact, name -> name, "Y")
                .percentile95();
    }
}
