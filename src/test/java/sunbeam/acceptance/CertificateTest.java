package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** {@code --certify} on pictures that the real shaders draw. */
final class CertificateTest extends InWorkplace {
    // A map of odd size has a row of pixels at v = 0, where the grating's orders lie.
    private static final String MAP = "brdf-map --patch blaze --size 33 --output map.png --certify 40 ";

    @Test
    void aPlannedPictureKeepsItsToleranceAndSaysSo() throws Exception {
        SunbeamResult result = workplace.succeedHere(MAP + "--tolerance 1e-3");
        assertThat(result.stdout()).contains("certificate: 40 random pixels");
        String png = Files.readString(workplace.resolve("map.png"), StandardCharsets.ISO_8859_1);
        assertThat(png).contains("Certificate").contains("relative error of XYZ median");
    }

    @Test
    void aPictureFromOneTermMissesItsToleranceInOneLine() throws Exception {
        SunbeamResult result =
                workplace.here(MAP + "--expansion taylor --terms 1").ended(3);
        assertThat(result.stderr().lines().filter(line -> line.contains("missed")))
                .as(result::toString)
                .hasSize(1)
                .allMatch(line -> line.contains("leave out --expansion and --terms"));
        assertThat(workplace.resolve("map.png")).exists();
    }

    private SunbeamResult reflectance(String rows, String options) throws Exception {
        Files.writeString(workplace.resolve("in.csv"), "theta_i,phi_i,theta_r,phi_r" + rows);
        return workplace.here("reflectance --directions in.csv --output out.csv --certify 4 --patch " + options);
    }

    /** Rows in and beside the first orders of a grating of 2.5 um. */
    @Test
    void aTableStatesTheErrorOfItsPowers() throws Exception {
        SunbeamResult result = reflectance(
                        ",wavelength\n0,0,12.7,0,550\n0,0,12.8,180,550\n0,0,0.1,90,500\n30,0,30,180,640\n", "sinusoid")
                .ended(0);
        assertThat(result.stdout()).contains("certificate: all 4 rows").contains("relative error of power");
    }

    @Test
    void darkDirectionsCertifyNothing() throws Exception {
        SunbeamResult result = reflectance("\n0,0,40,45\n0,0,50,45\n", "blaze").ended(3);
        assertThat(result.stderr()).contains("the tolerance is not certified");
    }

    @Test
    void aTableHasNoPowerOfWavelengthsAndSaysSoBeforeItLoads() throws Exception {
        SunbeamResult result = reflectance(",wavelength\n0,0,12.7,0,550\n", "sinusoid --method table")
                .ended(2);
        assertThat(result.stderr())
                .contains("--method table has colors, but no power")
                .doesNotContain("plan:");
    }

    private SunbeamResult angledMap(String more) throws IOException {
        return workplace.here("brdf-map --patch angled.png --width 12um --max-height 120nm --method table"
                + " --average coherent --tolerance 1e-2 --size 128 " + more);
    }

    /**
     * The surface was not used to find the table's steps: a sawtooth at an angle to the samples has sharp orders all over
     * (u, v), with dark lines between their tails.
     */
    @Test
    @Tag("thorough")
    void aTableKeepsItsToleranceWhereItsLawsDoNot() throws Exception {
        Images.gray(workplace.resolve("angled.png"), 256, 256, (x, y) -> (13 * x + 7 * y) % 256);

        SunbeamResult result = angledMap("--certify 80 --output map.png");

        // With the default steps the 95th percentile would be 0.15.
        result.ended(0);
        assertThat(result.stderr()).contains("baked again in steps of");

        // The second run reads the validated table from the cache.
        SunbeamResult again = angledMap("--output again.png").ended(0);
        assertThat(again.stderr()).doesNotContain("baked again");
    }
}
