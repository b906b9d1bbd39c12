package sunbeam.acceptance;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.function.DoublePredicate;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** Linear BRDF map as a NumPy array: float32, rows x columns x XYZ. */
public record NpyImage(String header, int side, float[] values) {
    private static final int PREFIX_BYTES = 10;

    public static NpyImage read(Path file, int side) throws IOException {
        return of(Files.readAllBytes(file), side);
    }

    static NpyImage of(byte[] file, int side) {
        ByteBuffer bytes = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
        int headerBytes = bytes.getShort(PREFIX_BYTES - 2);
        String header = new String(bytes.array(), PREFIX_BYTES, headerBytes, US_ASCII);
        assertThat(header).contains("'<f4'");
        bytes.position(PREFIX_BYTES + headerBytes);
        float[] values = new float[bytes.remaining() / Float.BYTES];
        bytes.asFloatBuffer().get(values);
        return new NpyImage(header, side, values);
    }

    /** Returns X, Y or Z of a pixel, row 0 on top. */
    public float at(int row, int column, int channel) {
        return values[3 * (row * side + column) + channel];
    }

    public double[] xyz(int row, int column) {
        return new double[] {at(row, column, 0), at(row, column, 1), at(row, column, 2)};
    }

    /** Returns x of a column's center, or minus y of a row's, in the unit disc. */
    public double place(int index) {
        return (2.0 * index + 1) / side - 1;
    }

    /** True if a pixel's center lies in the unit disc. */
    public boolean inDisc(int row, int column) {
        return Math.hypot(place(row), place(column)) < 1;
    }

    /** Returns the sum of Y without the mirror order over accepted azimuths, -180 to 180 degrees. */
    public double luminance(DoublePredicate azimuthAccepted) {
        double specularRadius = 0.15;
        double sum = 0;
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                double azimuth = Math.toDegrees(Math.atan2(-place(row), place(column)));
                if (inDisc(row, column)
                        && Math.hypot(place(row), place(column)) > specularRadius
                        && azimuthAccepted.test(azimuth)) {
                    sum += at(row, column, 1);
                }
            }
        }
        return sum;
    }

    /**
     * NumPy's archive of an exported table.
     *
     * @param metadata content of metadata.json
     * @param arrays float32, by name
     */
    record NpzFile(JsonNode metadata, Map<String, float[]> arrays) {
        static NpzFile read(Path file) throws IOException {
            JsonNode metadata = null;
            Map<String, float[]> arrays = new HashMap<>();
            try (ZipFile zip = new ZipFile(file.toFile())) {
                for (ZipEntry entry : zip.stream().toList()) {
                    byte[] bytes = zip.getInputStream(entry).readAllBytes();
                    if (entry.getName().endsWith(".npy")) {
                        arrays.put(
                                entry.getName().replace(".npy", ""),
                                NpyImage.of(bytes, 0).values());
                    } else {
                        metadata = new ObjectMapper().readTree(bytes);
                    }
                }
            }
            return new NpzFile(metadata, arrays);
        }

        float[] axis(String name) {
            return arrays.get(name);
        }

        int channels() {
            return arrays.get("C").length / (axis("u").length * axis("v").length * axis("w").length);
        }

        float color(int slice, int row, int column, int channel) {
            int texel = (slice * axis("v").length + row) * axis("u").length + column;
            return arrays.get("C")[texel * channels() + channel];
        }
    }
}
