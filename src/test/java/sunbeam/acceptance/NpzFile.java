package sunbeam.acceptance;

import static java.nio.charset.StandardCharsets.US_ASCII;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/**
 * NumPy's archive of an exported table.
 *
 * @param metadata content of metadata.json
 * @param arrays float32, by name
 */
record NpzFile(JsonNode metadata, Map<String, float[]> arrays) {
    private static final int PREFIX_BYTES = 10;

    static NpzFile read(Path file) throws IOException {
        JsonNode metadata = null;
        Map<String, float[]> arrays = new HashMap<>();
        try (ZipFile zip = new ZipFile(file.toFile())) {
            for (ZipEntry entry : zip.stream().toList()) {
                byte[] bytes = zip.getInputStream(entry).readAllBytes();
                if (entry.getName().endsWith(".npy")) {
                    arrays.put(entry.getName().replace(".npy", ""), values(bytes));
                } else {
                    metadata = new ObjectMapper().readTree(bytes);
                }
            }
        }
        return new NpzFile(metadata, arrays);
    }

    private static float[] values(byte[] npy) {
        ByteBuffer bytes = ByteBuffer.wrap(npy).order(ByteOrder.LITTLE_ENDIAN);
        int from = PREFIX_BYTES + bytes.getShort(PREFIX_BYTES - 2);
        if (!new String(npy, PREFIX_BYTES, from - PREFIX_BYTES, US_ASCII).contains("'<f4'")) {
            throw new IllegalArgumentException("no float32");
        }
        bytes.position(from);
        float[] values = new float[bytes.remaining() / Float.BYTES];
        bytes.asFloatBuffer().get(values);
        return values;
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
