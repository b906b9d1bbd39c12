package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Materials for Mitsuba and Cycles made of exported tables. */
class ExportRendererTest extends InOneWorkplace {
    private static final String SMALL = "--format bsdf --size 12MB --samples 0 --coherence-length 3um --theta-max 70";
    private static final String SURFACE = "--samples 0 --coherence-length 16um";

    @BeforeAll
    static void export() throws IOException {
        workplace.succeedHere("export blaze --format osl --output osl --size 5MB " + SURFACE);
    }

    /** The script fails if samples do not have their density (level 0.01), light is lost, or NumPy reads other colors. */
    @Test
    void mitsubaDrawsDirectionsFromTheTable() throws Exception {
        OtherPrograms.requireMitsuba();
        workplace.succeedHere("export blaze --format npz --output b.npz --samples 0 --size 5MB");

        assertThat(OtherPrograms.python(workplace.folder(), Sunbeam.example("mitsuba_bsdf.py"), "b.npz"))
                .containsPattern("5 degrees: chi-square p 0\\.\\d+; white furnace");
    }

    @Test
    void aShaderForRenderersComesWithItsTableAlone() throws Exception {
        assertThat(workplace.resolve("osl").toFile().list())
                .contains("sunbeam.osl", "sunbeam.exr", "sunbeam.md", "sunbeam.json")
                .noneMatch(name -> name.endsWith(".ktx2") || name.endsWith(".html"));
        assertThat(workplace.resolve("osl/sunbeam.osl")).content().doesNotContainPattern("@[A-Z_]+@");
        assertThat(workplace.resolve("osl/sunbeam.md")).content().doesNotContainPattern("@[A-Z_]+@");
    }

    /** The picture under a sun is the function's value but for the noise of Cycles' sampling: 0.2 at 64 samples. */
    @Test
    void cyclesReflectsWhatTheShaderSays() throws Exception {
        OtherPrograms.requirePython("bpy");

        String said = OtherPrograms.python(
                workplace.folder(), Sunbeam.example("blender_material.py"), "osl", "spheres.png", "48", "64");

        Matcher light =
                Pattern.compile("drawn ([0-9.e-]+), as a color ([0-9.e-]+)").matcher(said);
        assertThat(light.find()).as(said).isTrue();
        assertThat(said).containsPattern("\\d+ % noise at 64 samples");
        double color = Double.parseDouble(light.group(2));
        assertThat(color).isPositive();
        assertThat(Double.parseDouble(light.group(1))).isCloseTo(color, Offset.offset(0.2 * color));
        assertThat(ImageIO.read(workplace.resolve("spheres.png").toFile()).getWidth())
                .isEqualTo(2 * 48);
    }

    /** Mitsuba's eval gives the power of {@code reflectance} under the file's coherence length, but for the file's angular grid. */
    @Test
    void mitsubaReflectsWhatReflectanceSays() throws Exception {
        OtherPrograms.requireMitsuba();
        SunbeamResult made = workplace.here("export blaze --output b.bsdf " + SMALL);
        String length = made.stdout().replaceAll("(?s).*coherence length ([0-9.]+) um .*", "$1");
        List<double[]> rows = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            // Around the plane of the orders.
            rows.add(new double[] {i, 7 * i % 20, 11 * i % 60, i % 2 == 0 ? 180 : 5, 450 + 3 * i});
        }
        workplace.reflectance(
                "blaze", CsvFile.ofDirections(rows), "--average ensemble --coherence-length " + length + "um");

        String said = OtherPrograms.python(workplace.folder(), "-c", """
                import csv, numpy as np, mitsuba as mi
                mi.set_variant('llvm_ad_spectral')
                bsdf = mi.load_dict({'type': 'measured', 'filename': 'b.bsdf'})
                rows = list(csv.DictReader(open('reflectance.csv')))
                col = {n: np.array([float(r[n]) for r in rows]) for n in rows[0]}
                def vector(t, p):
                    t, p = np.radians(col[t]), np.radians(col[p])
                    return mi.Vector3f(*(mi.Float(x.astype('f4')) for x in (np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t))))
                si = mi.SurfaceInteraction3f()
                si.wi = vector('theta_r', 'phi_r')
                si.wavelengths = mi.Spectrum(mi.Float(col['wavelength'].astype('f4')))
                read = np.array(bsdf.eval(mi.BSDFContext(), si, vector('theta_i', 'phi_i')))[0]
                exact = col['brdf'] * np.cos(np.radians(col['theta_i']))
                print(np.median((abs(read - exact) / exact)[exact > 1e-3 * exact.max()]))
                """);

        // Median error of a file of 12 MB.
        assertThat(Double.parseDouble(said.strip())).isLessThan(0.25);
        assertThat(made.stdout()).contains("error of power as it is read");
    }
}
