package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import io.jhdf.HdfFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Arrays of colors and of spectral bands, as HDF5 and as NumPy has them: what they hold is what {@code reflectance} says. */
class ExportArrayTest {
    private static final String SURFACE = "--coherence-length 10um --theta-max 60";
    private static final String BANDS = "--channels spectral --bands 5 --wavelengths 500nm..600nm --tolerance 0.01 ";

    @TempDir
    static Path once;

    private static Workplace made;

    @TempDir
    Path root;

    private Workplace workplace;

    @BeforeAll
    static void export() throws IOException {
        made = Workplace.in(once);
        made.succeedHere(words("export blaze --format hdf5 --output bands.h5 --samples 2 " + BANDS + SURFACE));
        made.succeedHere(words("export blaze --format hdf5 --output a.h5 --samples 0 --illuminant A " + SURFACE));
    }

    @BeforeEach
    void layOut() throws IOException {
        workplace = Workplace.in(root);
    }

    private record Place(int slice, int row, int column) {}

    @Test
    void aBandHoldsTheMeanOfPowerUnderItsTriangle() throws Exception {
        workplace = made;
        try (HdfFile file = new HdfFile(workplace.resolve("bands.h5"))) {
            double[] bands = (double[]) file.getDatasetByPath("wavelengths_nm").getData();
            assertThat(bands).containsExactly(500, 525, 550, 575, 600);
            float[][][][] power = (float[][][][]) file.getDatasetByPath("C").getData();
            Place place = brightest(power[2], file);
            // The middle one's triangle in steps of 1 nm, which orders under 10 um are 20 times as wide as.
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
            assertThat(power[2][place.slice][place.row][place.column])
                    .isCloseTo((float) mean, Offset.offset(0.01f * (float) mean));
            assertThat(file.getAttribute("illuminant").getData().toString()).startsWith("none");
            assertThat((double)
                            file.getAttribute("error_beside_reference_median").getData())
                    .isBetween(0.0, 0.05);
        }
    }

    /** Seen at an angle where an order of blue, green and red lies, that any two directions see. */
    private static Place brightest(float[][][] power, HdfFile file) {
        double[] u = (double[]) file.getDatasetByPath("u").getData();
        Place best = new Place(0, 0, 0);
        int slice = power.length - 2;
        for (int row = 0; row < power[slice].length; row++) {
            for (int column = 0; column < u.length; column++) {
                boolean isOrder = Math.abs(u[column]) > 0.15;
                if (isOrder && power[slice][row][column] > power[best.slice][best.row][best.column]) {
                    best = new Place(slice, row, column);
                }
            }
        }
        return best;
    }

    /** By the list of directions, each nanometer. */
    private double[] powers(Place place, HdfFile file, int first, int last) throws IOException {
        double u = ((double[]) file.getDatasetByPath("u").getData())[place.column];
        double v = ((double[]) file.getDatasetByPath("v").getData())[place.row];
        double w = ((double[]) file.getDatasetByPath("w").getData())[place.slice];
        // Light and view lie beside the half vector, as high as each other.
        double half = Math.sqrt(u * u + v * v + w * w) / 2;
        double aside = Math.sqrt(Math.max(0, 1 - half * half)) / Math.hypot(u, v);
        String light = angles(-u / 2 + aside * v, -v / 2 - aside * u, -w / 2);
        String view = angles(-u / 2 - aside * v, -v / 2 + aside * u, -w / 2);
        StringBuilder rows = new StringBuilder("theta_i,phi_i,theta_r,phi_r,wavelength\n");
        for (int nanometers = first; nanometers <= last; nanometers++) {
            rows.append(light + "," + view + "," + nanometers + "\n");
        }
        Files.writeString(workplace.resolve("in.csv"), rows);
        workplace.succeedHere(words("reflectance --patch blaze --average ensemble --directions in.csv --output out.csv"
                + " --force --coherence-length 10um"));
        List<String> lines = Files.readAllLines(workplace.resolve("out.csv"));
        int column = List.of(lines.get(0).split(",", -1)).indexOf("power");
        return lines.stream()
                .skip(1)
                .mapToDouble(line -> Double.parseDouble(line.split(",", -1)[column]))
                .toArray();
    }

    private static String angles(double x, double y, double z) {
        return Math.toDegrees(Math.acos(z)) + "," + Math.toDegrees(Math.atan2(y, x));
    }

    @Test
    void aTableIsUnderItsLight() {
        try (HdfFile file = new HdfFile(made.resolve("a.h5"))) {
            assertThat(file.getAttribute("illuminant").getData()).isEqualTo("A");
            float[][][][] colors = (float[][][][]) file.getDatasetByPath("C").getData();
            double[] mirror = new double[3];
            for (int c = 0; c < 3; c++) {
                for (float[] row : colors[c][colors[c].length - 1]) {
                    for (float value : row) {
                        mirror[c] = Math.max(mirror[c], value);
                    }
                }
            }
            // Blaze sends nothing but orders, whose sum over a lamp's light is much redder than daylight's 0.95 and
            // 1.09.
            assertThat(mirror[0] / mirror[1]).isGreaterThan(1);
            assertThat(mirror[2] / mirror[1]).isLessThan(0.7);
        }
    }

    @Test
    void h5pyReadsTheAxesAndTheChannels() throws Exception {
        OtherPrograms.requirePython("h5py");

        String said = OtherPrograms.python(
                made.folder(),
                "-c",
                "import h5py; f = h5py.File('bands.h5'); c = f['C'];"
                        + " print(c.shape == tuple(len(f[a]) for a in ('wavelengths_nm', 'w', 'v', 'u')),"
                        + " f.attrs['patch'], c[2].max() > 0)");

        assertThat(said).contains("True").contains("blaze").doesNotContain("False");
    }

    @Test
    void numPyReadsTheSameBands() throws Exception {
        OtherPrograms.requirePython("numpy, h5py");
        workplace = made;
        workplace.succeedHere(
                words("export blaze --format npz --output bands.npz --samples 0 --force " + BANDS + SURFACE));

        String said = OtherPrograms.python(
                made.folder(),
                "-c",
                "import numpy as np, h5py; z = np.load('bands.npz')['C']; c = np.moveaxis(h5py.File('bands.h5')['C'][:], 0, -1);"
                        + " print(z.shape[-1] == 5 and abs(z - c[:z.shape[0], :z.shape[1], :z.shape[2]]).max() < 1e-4 * c.max()"
                        + " if z.shape == c.shape else 'another table')");

        // Archives are smaller, so that the same size may hold finer tables; of so few bands it does not.
        assertThat(said).contains("True");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "export blaze --format hdf5 --output b.npz | --output",
                "export blaze --format hdf5 --output b.h5 --channels spectral --bands 500 | --bands 500",
                "export blaze --format hdf5 --output b.h5 --channels spectral --illuminant A | --illuminant",
                "export blaze --format hdf5 --output b.h5 --bands 20 | --bands",
                "export blaze --format npz --output b.npz --channels spectral --wavelengths 532nm | --bands",
                "export blaze --format osl --output b --bands 20 | --bands"
            })
    void whatAnArrayCannotHoldIsToldInALine(String commandLine, String named) throws Exception {
        Complaint.assertThatIt(workplace.here(words(commandLine)), Complaint.USAGE, named);
        assertThat(workplace.files()).isEmpty();
    }

    @Test
    void aDiskWithoutRoomIsToldBeforeTheWork() throws Exception {
        assertThat(workplace
                        .here(words("export none.gwy --format npz --output b.npz --size 9000TB"))
                        .stderr())
                .contains("9000.0 TB", "are free");
        assertThat(workplace.files()).isEmpty();
    }

    private static String[] words(String commandLine) {
        return commandLine.split(" ", -1);
    }
}
