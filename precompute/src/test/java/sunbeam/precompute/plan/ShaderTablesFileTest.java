package sunbeam.precompute.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.plan.ShaderArrays.KernelPolynomials;
import sunbeam.precompute.spectrum.InterpolationDesign;

/** Tables are read back bit by bit, other files are refused; layouts and kernels in tables. */
class ShaderTablesFileTest {
    private static final String KEY = "full|a surface|a plan";
    private static final TableLabel LABEL = new TableLabel("gr\u00fcn", "3 terms");
    private static final ArrayLayout FLAT = ArrayLayout.flat("weights", 3, 2, 4).linear();
    private static final ArrayLayout LAYERED = ArrayLayout.layered("terms", 5, 7, 3, 2);

    @TempDir
    Path folder;

    private Path file;
    private byte[] good;

    private static float[] layer(int number) {
        float[] values = new float[LAYERED.floatsPerLayer()];
        for (int i = 0; i < values.length; i++) {
            values[i] = (float) Math.sin(i + 100 * number);
        }
        // Numbers that arithmetic would change.
        values[0] = -0f;
        values[1] = Float.MIN_VALUE;
        return values;
    }

    private static ShaderTables tables() {
        return new ShaderTables.Builder("full_grid")
                .define("TAPS", 4)
                .reals("scale", 0.1)
                .reals("place", 1, 2, 3, 4)
                .integers("first", -7, 9)
                .array(TableArray.of(FLAT, new float[FLAT.floatsPerLayer()]))
                .array(TableArray.computed(LAYERED, ShaderTablesFileTest::layer))
                .build(16e-6, 0.04);
    }

    @BeforeEach
    void write() throws IOException {
        file = folder.resolve("kept.tables");
        ShaderTablesFile.write(file, KEY, LABEL, tables());
        good = Files.readAllBytes(file);
    }

    @Test
    void comeBackAsTheyWere() {
        ShaderTables read = ShaderTablesFile.read(file, KEY);

        assertThat(read.shader()).isEqualTo("full_grid");
        assertThat(read.defines()).isEqualTo(tables().defines());
        assertThat(new TreeMap<>(read.reals())).usingRecursiveComparison().isEqualTo(tables().reals());
        assertThat(new TreeMap<>(read.integers())).usingRecursiveComparison().isEqualTo(tables().integers());
        assertThat(read.windowSigma()).isEqualTo(16e-6);
        assertThat(read.specularReach()).isEqualTo(0.04);
        assertThat(read.arrays()).extracting(TableArray::layout).containsExactly(FLAT, LAYERED);
        for (int number = 0; number < LAYERED.layers(); number++) {
            FloatBuffer floats = read.arrays().get(1).layer(number);
            float[] values = new float[floats.remaining()];
            floats.get(values);
            assertThat(values).as("-0 and 0 differ").containsExactly(layer(number));
        }
    }

    @Test
    void labelsAreReadWithoutTheTables() throws IOException {
        assertThat(ShaderTablesFile.label(file)).isEqualTo(LABEL);
        // Lists of files read labels only.
        Files.write(file, Arrays.copyOf(good, good.length / 2));
        assertThat(ShaderTablesFile.label(file)).isEqualTo(LABEL);
        Files.write(file, Arrays.copyOf(good, 40));
        assertThatThrownBy(() -> ShaderTablesFile.label(file)).isInstanceOf(InputException.class);
    }

    @Test
    void anotherPlansAreRefused() {
        assertThatThrownBy(() -> ShaderTablesFile.read(file, KEY + "!"))
                .isInstanceOf(InputException.class)
                .hasMessage("cannot use " + file + ": tables of another surface or plan");
    }

    private void assertRefused(byte[] content, String words) throws IOException {
        Files.write(file, content);
        assertThatThrownBy(() -> ShaderTablesFile.read(file, KEY))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(words);
    }

    @Test
    void damageIsNoticedWhereverItIs() throws IOException {
        for (int at = 0; at < good.length; at += 3) {
            byte[] flipped = good.clone();
            flipped[at] ^= 0x10;
            assertRefused(flipped, "cannot use ");
            assertRefused(Arrays.copyOf(good, at), "cannot use ");
        }
        assertRefused(Arrays.copyOf(good, good.length + 4), "too long: ");
        byte[] later = good.clone();
        ByteBuffer.wrap(later).putInt(Long.BYTES, ShaderTablesFile.VERSION + 1);
        assertRefused(later, "tables of version ");
    }

    @Test
    void anArrayLargerThanTheFileTakesNoMemory() throws IOException {
        ArrayLayout huge = ArrayLayout.layered("huge", 8192, 8192, Integer.MAX_VALUE, 4);
        TableArray claimed = TableArray.of(huge, new float[0]);
        byte[] header = ShaderTablesFile.header(
                KEY, LABEL, new ShaderTables.Builder("").array(claimed).build(1, 1));
        ByteBuffer claims = ByteBuffer.allocate(16 + header.length + 8);
        claims.put(good, 0, Long.BYTES + Integer.BYTES).putInt(header.length).put(header);

        assertRefused(claims.array(), "truncated: ");
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 4, 5, 6, 7, 8, 9, 10})
    void weightsAreTheKernelsAndFloat32RoundsThemInProportion(int taps) {
        InterpolationDesign design = InterpolationDesign.best(2.5, taps, 3.5);
        KernelPolynomials polynomials = KernelPolynomials.of(taps, design::kernel);
        for (int tap = 0; tap < taps; tap++) {
            double largest = Math.max(polynomials.weight(tap, -1), polynomials.weight(tap, 1));
            for (int i = -19; i <= 19; i++) {
                float place = i / 20f;
                double distance = 0.5 * ((double) place + taps - 1) - tap;
                // Polynomials may omit 2e-9 of the peak, 1; they are fitted at 64 places a tap.
                assertEquals(design.kernel(distance), polynomials.weight(tap, place), 2.5e-9);
                // Horner's rule in float32, one rounding of 6e-8 for each of the few relevant steps.
                double error = Math.abs(inFloats(polynomials, tap, place) - polynomials.weight(tap, place));
                assertTrue(error <= 4e-7 * Math.max(largest, polynomials.weight(tap, place)), tap + " " + place);
            }
        }
    }

    private static float inFloats(KernelPolynomials polynomials, int tap, float place) {
        float sum = 0;
        for (int power = polynomials.powers() - 1; power >= 0; power--) {
            sum = sum * place + (float) polynomials.coefficients()[tap][power];
        }
        return sum;
    }

    @Test
    void aKernelWithACornerIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> KernelPolynomials.of(4, x -> Math.abs(x - 0.3)));
    }
}
