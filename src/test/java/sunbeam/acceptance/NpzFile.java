package sunbeam.acceptance;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
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
