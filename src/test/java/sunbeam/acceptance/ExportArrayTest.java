package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import io.jhdf.HdfFile;
import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.NpyImage.NpzFile;

/** Exported arrays hold the values of {@code reflectance}; materials for Mitsuba and Cycles made of exported tables. */
class ExportArrayTest extends InOneWorkplace {
    private static final String SURFACE = "--coherence-length 10um --theta-max 60";
    private static final String BANDS = "--channels spectral --bands 5 --wavelengths 500nm..600nm --tolerance 0.01 ";

    @BeforeAll
    static void export() throws IOException {
        workplace.succeedHere("export blaze --format npz --output bands.npz --samples 2 " + BANDS + SURFACE);
        workplace.succeedHere("export blaze --format npz --output a.npz --samples 0 --illuminant A " + SURFACE);
        workplace.succeedHere("export blaze --format osl --output osl --size 5MB --samples 0 --coherence-length 16um");
    }

    private record Place(int slice, int row, int column) {}

    @Test
    void aBandHoldsTheMeanOfPowerUnderItsTriangle() throws Exception {
        NpzFile file = NpzFile.read(workplace.resolve("bands.npz"));
        assertThat(file.metadata().get("wavelengths_m").toString()).isEqualTo("[5.0E-7,5.25E-7,5.5E-7,5.75E-7,6.0E-7]");
        assertThat(file.channels()).isEqualTo(5);
        Place place = brightest(file);
        // The triangle of the middle band in steps of 1 nm; orders under a window of 10 um are 20 nm wide.
        double sum = 0;
        double weights = 0;
        double[] exact = powers(place, file, 525, 575);
        for (int i = 0; i <= 50; i++) {
            double weight = 1 - Math.abs(i - 25) / 25.0;
            sum += weight * exact[i];
            weights += weight;
        }
        double mean = sum / weights;

        // The tolerance of the table.
        assertThat(file.color(place.slice, place.row, place.column, 2))
                .isCloseTo((float) mean, Offset.offset(0.01f * (float) mean));
        assertThat(file.metadata().get("illuminant").asText()).startsWith("none");
        assertThat(file.metadata().at("/error/beside_reference/median").doubleValue())
                .isBetween(1e-9, 0.05);
    }

    /** Returns the brightest texel that two directions reach, in an order of blue, green and red. */
    private static Place brightest(NpzFile file) {
        float[] u = file.axis("u");
        Place best = new Place(0, 0, 0);
        int slice = file.axis("w").length - 2;
        for (int row = 0; row < file.axis("v").length; row++) {
            for (int column = 0; column < u.length; column++) {
                boolean isOrder = Math.abs(u[column]) > 0.15;
                if (isOrder && file.color(slice, row, column, 2) > file.color(best.slice, best.row, best.column, 2)) {
                    best = new Place(slice, row, column);
                }
            }
        }
        return best;
    }

    /** Returns the power at each nanometer, by a list of directions. */
    private double[] powers(Place place, NpzFile file, int first, int last) throws IOException {
        double u = file.axis("u")[place.column];
        double v = file.axis("v")[place.row];
        double w = file.axis("w")[place.slice];
        // Light and view are symmetric about the half vector.
        double half = Math.sqrt(u * u + v * v + w * w) / 2;
        double aside = Math.sqrt(Math.max(0, 1 - half * half)) / Math.hypot(u, v);
        double[] light = angles(-u / 2 + aside * v, -v / 2 - aside * u, -w / 2);
        double[] view = angles(-u / 2 - aside * v, -v / 2 + aside * u, -w / 2);
        List<double[]> rows = new ArrayList<>();
        for (int nanometers = first; nanometers <= last; nanometers++) {
            rows.add(new double[] {light[0], light[1], view[0], view[1], nanometers});
        }
        CsvFile powers = workplace.reflectance(
                "blaze", CsvFile.ofDirections(rows), "--average ensemble --coherence-length 10um");
        return IntStream.range(0, powers.size())
                .mapToDouble(row -> powers.at(row, "power"))
                .toArray();
    }

    private static double[] angles(double x, double y, double z) {
        return new double[] {Math.toDegrees(Math.acos(z)), Math.toDegrees(Math.atan2(y, x))};
    }

    @Test
    void aTableIsUnderItsLight() throws IOException {
        NpzFile file = NpzFile.read(workplace.resolve("a.npz"));
        assertThat(file.metadata().get("illuminant").asText()).isEqualTo("A");
        double[] mirror = new double[3];
        for (int c = 0; c < 3; c++) {
            for (int row = 0; row < file.axis("v").length; row++) {
                for (int column = 0; column < file.axis("u").length; column++) {
                    mirror[c] = Math.max(mirror[c], file.color(file.axis("w").length - 1, row, column, c));
                }
            }
        }
        // Under the lamp's light, X / Y and Z / Y are much redder than daylight's 0.95 and 1.09.
        assertThat(mirror[0] / mirror[1]).isGreaterThan(1);
        assertThat(mirror[2] / mirror[1]).isLessThan(0.7);
    }

    @Test
    void linesOfTheDocsMakeHdf5OfAnArchive() throws Exception {
        OtherPrograms.requirePython("numpy, h5py");
        String page = Files.readString(Sunbeam.repository().resolve("docs/export.md"));
        String lines = page.replaceAll("(?s).*(    import h5py.*?\\n)\\n.*", "$1")
                .stripTrailing()
                .stripIndent();

        OtherPrograms.python(workplace.folder(), "-c", lines.replace("colors.", "bands."));

        NpzFile archive = NpzFile.read(workplace.resolve("bands.npz"));
        try (HdfFile file = new HdfFile(workplace.resolve("bands.h5"))) {
            float[][][][] colors = (float[][][][]) file.getDatasetByPath("C").getData();
            assertThat(colors[1][2][3][4]).isEqualTo(archive.color(1, 2, 3, 4));
            assertThat(colors[0][0][0]).hasSize(5);
            assertThat(file.getDatasetByPath("metadata.json").getData().toString())
                    .contains("\"patch\" : \"blaze\"");
        }
    }

    @ParameterizedTest
    @CsvSource({"npz, 1B, --size 1 B", "html, 1kB, --size 1.0 kB", "bsdf, 10kB, --size"})
    void aSizeThatHoldsNoTableIsToldInALine(String format, String size, String named) throws Exception {
        workplace
                .here("export blaze --format %s --output none.%s --size %s", format, format, size)
                .complains(SunbeamResult.USAGE, named);
        assertThat(workplace.resolve("none." + format)).doesNotExist();
    }

    @Test
    void aDiskWithoutRoomIsToldBeforeTheWork() throws Exception {
        assertThat(workplace
                        .here("export none.gwy --format npz --output none.npz --size 9000TB")
                        .stderr())
                .contains("9000.0 TB", "are free");
        assertThat(workplace.resolve("none.npz")).doesNotExist();
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
        SunbeamResult made = workplace.here(
                "export blaze --format bsdf --output b.bsdf --size 12MB --samples 0 --coherence-length 3um"
                        + " --theta-max 70");
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
